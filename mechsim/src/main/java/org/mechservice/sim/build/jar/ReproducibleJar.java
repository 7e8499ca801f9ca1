package org.mechservice.sim.build.jar;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.LocalDateTime;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * A JAR whose bytes depend on its content alone: the manifest first, then the entries by name, all
 * of one date, deflated as far as it goes.
 */
public final class ReproducibleJar {
  /** The first date a ZIP file can hold. */
  private static final LocalDateTime DATE = LocalDateTime.of(1980, 1, 1, 0, 0);

  private final Map<String, String> manifest;
  private final SortedMap<String, byte[]> entries = new TreeMap<>();

  /**
   * @param manifest main attributes in order, after the manifest's own version; not modified
   */
  public ReproducibleJar(Map<String, String> manifest) {
    this.manifest = manifest;
  }

  /** Adds a file. */
  public ReproducibleJar add(String path, byte[] content) {
    entries.put(path, content);
    return this;
  }

  /** Adds class files by binary name. */
  public ReproducibleJar addClasses(SortedMap<String, byte[]> classFiles) {
    classFiles.forEach((name, bytes) -> add(name.replace('.', '/') + ".class", bytes));
    return this;
  }

  /** Returns the JAR's bytes. */
  public byte[] bytes() {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.setLevel(Deflater.BEST_COMPRESSION);
      write(zip, JarFile.MANIFEST_NAME, manifestBytes());
      for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
        write(zip, entry.getKey(), entry.getValue());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  private byte[] manifestBytes() throws IOException {
    Manifest written = new Manifest();
    Attributes attributes = written.getMainAttributes();
    attributes.put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest.forEach((key, value) -> attributes.putValue(key, oneLine(value)));
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    written.write(bytes);
    return bytes.toByteArray();
  }

  /** A line end inside a value would begin another attribute. */
  private static String oneLine(String value) {
    return value.replaceAll("\\p{Cntrl}", " ");
  }

  /** Sizes are given beforehand, which spares a descriptor behind each entry. */
  private static void write(ZipOutputStream zip, String path, byte[] content) throws IOException {
    ZipEntry entry = new ZipEntry(path);
    CRC32 crc = new CRC32();
    crc.update(content);
    entry.setTimeLocal(DATE);
    entry.setCrc(crc.getValue());
    entry.setSize(content.length);
    entry.setCompressedSize(deflatedSize(content));
    zip.putNextEntry(entry);
    zip.write(content);
    zip.closeEntry();
  }

  /** Returns how many bytes a file takes inside the JAR. */
  public static int deflatedSize(byte[] content) {
    Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
    try {
      deflater.setInput(content);
      deflater.finish();
      byte[] buffer = new byte[8192];
      int size = 0;
      while (!deflater.finished()) {
        size += deflater.deflate(buffer);
      }
      return size;
    } finally {
      deflater.end();
    }
  }
}
