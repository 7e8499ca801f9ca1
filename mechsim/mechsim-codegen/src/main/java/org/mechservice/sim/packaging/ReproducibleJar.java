package org.mechservice.sim.packaging;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.LocalDateTime;
import java.util.HashMap;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;

/**
 * An ordinary JAR whose bytes depend only on its content: the manifest first, then the entries in
 * the order of their names, all with the same date.
 *
 * <p>The entries are compressed by the deflater of the Java runtime. Two Java builds with different
 * zlib versions can give different bytes for the same content; one Java build always gives the same
 * bytes. A recorded SHA-256 is therefore the hash of the JAR as it was built.
 */
public final class ReproducibleJar {
  /**
   * Date of all entries. The ZIP format begins at 1 January 1980; {@link ZipEntry} writes exactly
   * that date with the time zone of the machine, so a later one is used.
   */
  private static final LocalDateTime DATE = LocalDateTime.of(1980, 2, 1, 0, 0);

  private final Map<String, String> manifest;
  private final SortedMap<String, byte[]> entries = new TreeMap<>();
  private final Map<String, Long> compressedSizes = new HashMap<>();

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
    classFiles.forEach((name, bytes) -> add(classPath(name), bytes));
    return this;
  }

  /** Returns the path of a class file in a JAR. */
  private static String classPath(String binaryName) {
    return binaryName.replace('.', '/') + ".class";
  }

  /** Returns the JAR's bytes. */
  public byte[] bytes() {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JarOutputStream out = new JarOutputStream(bytes)) {
      out.setLevel(Deflater.BEST_COMPRESSION);
      write(JarFile.MANIFEST_NAME, manifestBytes(), out);
      for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
        write(entry.getKey(), entry.getValue(), out);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("bytes in memory can always be written", e);
    }
    return bytes.toByteArray();
  }

  private void write(String path, byte[] content, JarOutputStream out) throws IOException {
    ZipEntry entry = new ZipEntry(path);
    entry.setTimeLocal(DATE);
    out.putNextEntry(entry);
    out.write(content);
    out.closeEntry();
    compressedSizes.put(path, entry.getCompressedSize());
  }

  /**
   * Returns the compressed size of classes, in bytes, once {@link #bytes} was called.
   *
   * @param classFiles class files by binary name, which were added before; not modified
   */
  public long compressedSize(SortedMap<String, byte[]> classFiles) {
    return classFiles.keySet().stream()
        .mapToLong(name -> compressedSizes.getOrDefault(classPath(name), 0L))
        .sum();
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

  /** Returns a value on one line; a line end would begin another attribute. */
  private static String oneLine(String value) {
    return value.replaceAll("\\p{Cntrl}", " ");
  }
}
