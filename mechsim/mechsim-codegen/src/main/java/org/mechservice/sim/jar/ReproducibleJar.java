package org.mechservice.sim.jar;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.Manifest;

/**
 * A JAR whose bytes depend on its content alone: the manifest first, then the entries by name, all
 * of one date, deflated.
 */
public final class ReproducibleJar {
  private final Packing packing;
  private final Map<String, String> manifest;
  private final SortedMap<String, byte[]> entries = new TreeMap<>();

  /**
   * @param manifest main attributes in order, after the manifest's own version; not modified
   * @param packing how its entries are made small
   */
  public ReproducibleJar(Map<String, String> manifest, Packing packing) {
    this.packing = packing;
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
    ZipBytes zip = new ZipBytes();
    zip.add(JarFile.MANIFEST_NAME, manifestBytes(), packing);
    entries.forEach((path, content) -> zip.add(path, content, packing));
    return zip.bytes();
  }

  private byte[] manifestBytes() {
    Manifest written = new Manifest();
    Attributes attributes = written.getMainAttributes();
    attributes.put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest.forEach((key, value) -> attributes.putValue(key, oneLine(value)));
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      written.write(bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  /** A line end inside a value would begin another attribute. */
  private static String oneLine(String value) {
    return value.replaceAll("\\p{Cntrl}", " ");
  }
}
