package org.mechservice.client;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarInputStream;
import java.util.zip.ZipEntry;
import org.mechservice.solver.pack.PackedClasses;

/** The content of a JAR whose hash was checked; what is loaded is what was checked. */
final class FetchedJar {
  private final Attributes manifest;
  private final Map<String, byte[]> entries;

  private FetchedJar(Attributes manifest, Map<String, byte[]> entries) {
    this.manifest = manifest;
    this.entries = entries;
  }

  /**
   * Unpacks a JAR in memory.
   *
   * @throws JarRefusedException if it cannot be read
   */
  static FetchedJar unpack(byte[] jar, String what) {
    Map<String, byte[]> entries = new HashMap<>();
    try (JarInputStream in = new JarInputStream(new ByteArrayInputStream(jar))) {
      ZipEntry entry = in.getNextEntry();
      while (entry != null) {
        if (entry.getName().equals(PackedClasses.ENTRY)) {
          entries.putAll(PackedClasses.unpack(in.readAllBytes()));
        } else if (!entry.isDirectory()) {
          entries.put(entry.getName(), in.readAllBytes());
        }
        entry = in.getNextEntry();
      }
      Attributes manifest =
          in.getManifest() == null ? new Attributes() : in.getManifest().getMainAttributes();
      return new FetchedJar(manifest, entries);
    } catch (IOException e) {
      throw new JarRefusedException("S-036", what + " is no JAR: " + e.getMessage());
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
