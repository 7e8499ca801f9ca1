package org.mechservice.client;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarInputStream;
import java.util.zip.ZipEntry;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.pack.KeptClasses;
import org.mechservice.solver.pack.PackedClasses;

/** The content of a JAR whose hash was checked; what is loaded is what was checked. */
final class FetchedJar {
  private static final String API_VERSION_ATTRIBUTE = "Mech-Api-Version";

  private final Attributes manifest;
  private final Map<String, byte[]> entries;

  private FetchedJar(Attributes manifest, Map<String, byte[]> entries) {
    this.manifest = manifest;
    this.entries = entries;
  }

  /**
   * Unpacks a JAR in memory.
   *
   * @param cache keeps classes that are packed together, which take long to unpack
   * @throws JarRefusedException if it cannot be read, or was built for another solver API
   */
  static FetchedJar unpack(byte[] jar, String what, JarCache cache) {
    Map<String, byte[]> entries = new HashMap<>();
    try (JarInputStream in = new JarInputStream(new ByteArrayInputStream(jar))) {
      Attributes manifest =
          in.getManifest() == null ? new Attributes() : in.getManifest().getMainAttributes();
      requireSameApi(manifest, what);
      ZipEntry entry = in.getNextEntry();
      while (entry != null) {
        byte[] content = in.readAllBytes();
        if (entry.getName().equals(PackedClasses.ENTRY)) {
          entries.putAll(classes(content, manifest, cache));
        } else if (!entry.isDirectory()) {
          entries.put(entry.getName(), content);
        }
        entry = in.getNextEntry();
      }
      return new FetchedJar(manifest, entries);
    } catch (IOException | UncheckedIOException e) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(), what + " is no JAR: " + e.getMessage());
    }
  }

  /** Before anything is unpacked: the form of packed classes belongs to the version, too. */
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

  /** The hash is the JAR's own word, and the JAR was checked. */
  private static Map<String, byte[]> classes(byte[] packed, Attributes manifest, JarCache cache)
      throws IOException {
    String sha256 = manifest.getValue(PackedClasses.KEPT_SHA_256);
    return sha256 == null
        ? PackedClasses.unpack(packed)
        : KeptClasses.read(cache.unpacked(sha256, () -> unpacked(packed)));
  }

  private static byte[] unpacked(byte[] packed) {
    try {
      return KeptClasses.write(PackedClasses.unpack(packed));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
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
