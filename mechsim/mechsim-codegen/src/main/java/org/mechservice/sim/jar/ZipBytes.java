package org.mechservice.sim.jar;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;

/**
 * A ZIP file in memory (PKWARE's APPNOTE, 4.3): deflated entries of one date with nothing beside
 * them that can be left out.
 */
final class ZipBytes {
  private static final int LOCAL = 0x04034b50;
  private static final int CENTRAL = 0x02014b50;
  private static final int END = 0x06054b50;
  private static final int VERSION = 20;
  private static final int UTF_8 = 1 << 11;
  private static final int DEFLATED = 8;

  /** The first date there is: 1 January 1980. */
  private static final int DATE = 1 << 5 | 1;

  private final ByteArrayOutputStream files = new ByteArrayOutputStream();
  private final ByteArrayOutputStream directory = new ByteArrayOutputStream();
  private int count;

  /** Adds a file. */
  void add(String path, byte[] content, Packing packing) {
    byte[] name = path.getBytes(StandardCharsets.UTF_8);
    byte[] deflated = packing.deflated(content);
    CRC32 crc = new CRC32();
    crc.update(content);
    int offset = files.size();
    four(LOCAL, files);
    common(path, name, (int) crc.getValue(), deflated.length, content.length, files);
    files.writeBytes(name);
    files.writeBytes(deflated);
    four(CENTRAL, directory);
    two(VERSION, directory);
    common(path, name, (int) crc.getValue(), deflated.length, content.length, directory);
    // Neither comment nor another disk nor attributes.
    two(0, directory);
    two(0, directory);
    two(0, directory);
    four(0, directory);
    four(offset, directory);
    directory.writeBytes(name);
    count++;
  }

  private static void common(
      String path, byte[] name, int crc, int deflated, int length, ByteArrayOutputStream out) {
    two(VERSION, out);
    two(name.length == path.length() ? 0 : UTF_8, out);
    two(DEFLATED, out);
    two(0, out);
    two(DATE, out);
    four(crc, out);
    four(deflated, out);
    four(length, out);
    two(name.length, out);
    two(0, out);
  }

  /** Returns the file. */
  byte[] bytes() {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    all.writeBytes(files.toByteArray());
    all.writeBytes(directory.toByteArray());
    four(END, all);
    two(0, all);
    two(0, all);
    two(count, all);
    two(count, all);
    four(directory.size(), all);
    four(files.size(), all);
    two(0, all);
    return all.toByteArray();
  }

  private static void two(int value, ByteArrayOutputStream out) {
    out.write(value);
    out.write(value >>> 8);
  }

  private static void four(int value, ByteArrayOutputStream out) {
    two(value, out);
    two(value >>> 16, out);
  }
}
