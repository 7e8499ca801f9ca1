package org.mechservice.client.jar;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarInputStream;
import java.util.zip.ZipEntry;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.catalogue.MessageCode;

/** The content of a JAR in memory: the bytes whose hash was checked are the bytes that are used. */
final class FetchedJar {
  private static final String API_VERSION_ATTRIBUTE = "Mech-Api-Version";

  private final Attributes manifest;
  private final Map<String, byte[]> entries;

  private FetchedJar(Attributes manifest, Map<String, byte[]> entries) {
    this.manifest = manifest;
    this.entries = entries;
  }

  /**
   * Reads a JAR in memory.
   *
   * @param what the JAR's name in messages
   * @throws JarRefusedException if it cannot be read, or was built for another solver API
   */
  static FetchedJar read(byte[] jar, String what) {
    Map<String, byte[]> entries = new HashMap<>();
    try (JarInputStream in = new JarInputStream(new ByteArrayInputStream(jar))) {
      Attributes manifest =
          in.getManifest() == null ? new Attributes() : in.getManifest().getMainAttributes();
      requireSameApi(manifest, what);
      ZipEntry entry = in.getNextEntry();
      while (entry != null) {
        if (!entry.isDirectory()) {
          entries.put(entry.getName(), in.readAllBytes());
        }
        entry = in.getNextEntry();
      }
      return new FetchedJar(manifest, entries);
    } catch (IOException e) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(), what + " is no JAR: " + e.getMessage());
    }
  }

  private static void requireSameApi(Attributes manifest, String what) {
    String built = manifest.getValue(API_VERSION_ATTRIBUTE);
    String own = Integer.toString(Model.API_VERSION);
    if (!own.equals(built)) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(),
          what
              + " was built for solver API version "
              + (built == null ? "none" : built)
              + "; this client has "
              + own
              + ": use the client of the server's version");
    }
  }

  /** Returns a main attribute of the manifest. */
  Optional<String> attribute(String name) {
    return Optional.ofNullable(manifest.getValue(name));
  }

  /** Returns the bytes of an entry. */
  Optional<byte[]> entry(String name) {
    return Optional.ofNullable(entries.get(name));
  }
}
