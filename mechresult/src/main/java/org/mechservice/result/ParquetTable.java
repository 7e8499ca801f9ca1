package org.mechservice.result;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writes a table as an Apache Parquet file: required columns of type DOUBLE, or of type BYTE_ARRAY
 * with UTF-8, plain encoding, without compression, one page for each column of a row group.
 *
 * <p>A row group of at most 64 MB is collected in memory; of a finished one only its place and
 * lengths are kept.
 */
public final class ParquetTable {
  static final byte[] MAGIC = "PAR1".getBytes(StandardCharsets.US_ASCII);

  /** Numbers of parquet.thrift: Type, FieldRepetitionType, Encoding, PageType, CompressionCodec. */
  static final int TYPE_DOUBLE = 5;

  private static final int TYPE_BYTE_ARRAY = 6;
  private static final int UTF8 = 0;
  static final int REQUIRED = 0;
  static final int PLAIN = 0;
  private static final int RLE = 3;
  static final int DATA_PAGE = 0;
  static final int UNCOMPRESSED = 0;

  private static final int GROUP_BYTES = 1 << 26;
  private static final int FIRST_ROWS = 256;

  /** The kind of values in a column. */
  public enum Kind {
    /** 64-bit numbers. */
    NUMBER,
    /** Texts. */
    TEXT
  }

  /** A column with its name. */
  public record Column(String name, Kind kind) {}

  /** A row group: its rows, and where each page with its header begins and the last one ends. */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  private record Group(int rows, long[] pages) {}

  private final OutputStream out;
  private final List<Column> columns;
  private final List<Group> groups = new ArrayList<>();
  private final double[][] numbers;
  private final List<ByteArrayOutputStream> texts = new ArrayList<>();
  private final int mostRows;
  private int filled;
  private long position;
  private long rows;

  /**
   * Begins a table.
   *
   * @throws IOException if it cannot be written
   */
  public ParquetTable(OutputStream out, List<Column> columns) throws IOException {
    this.out = out;
    this.columns = List.copyOf(columns);
    int count = (int) columns.stream().filter(c -> c.kind() == Kind.NUMBER).count();
    mostRows = Math.max(1, GROUP_BYTES / Double.BYTES / columns.size());
    numbers = new double[count][Math.min(mostRows, FIRST_ROWS)];
    for (int i = count; i < columns.size(); i++) {
      texts.add(new ByteArrayOutputStream());
    }
    write(MAGIC);
  }

  private void write(byte[] bytes) throws IOException {
    out.write(bytes);
    position += bytes.length;
  }

  /**
   * Writes a row.
   *
   * @param row values of the number columns in their order; not modified
   * @param words values of the text columns in their order
   * @throws IOException if it cannot be written
   */
  public void row(double[] row, List<String> words) throws IOException {
    for (int i = 0; i < numbers.length; i++) {
      if (filled == numbers[i].length) {
        numbers[i] = Arrays.copyOf(numbers[i], Math.min(mostRows, 2 * filled));
      }
      numbers[i][filled] = row[i];
    }
    int size = 0;
    for (int i = 0; i < texts.size(); i++) {
      byte[] word = words.get(i).getBytes(StandardCharsets.UTF_8);
      ByteBuffer length = ByteBuffer.allocate(Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN);
      texts.get(i).writeBytes(length.putInt(word.length).array());
      texts.get(i).writeBytes(word);
      size += texts.get(i).size();
    }
    filled++;
    rows++;
    if (filled == mostRows || size > GROUP_BYTES) {
      writeGroup();
    }
  }

  private void writeGroup() throws IOException {
    long[] pages = new long[columns.size() + 1];
    int number = 0;
    int text = 0;
    for (int i = 0; i < columns.size(); i++) {
      pages[i] = position;
      if (columns.get(i).kind() == Kind.NUMBER) {
        int size = filled * Double.BYTES;
        write(header(size));
        ByteBuffer page = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
        page.asDoubleBuffer().put(numbers[number++], 0, filled);
        write(page.array());
      } else {
        ByteArrayOutputStream page = texts.get(text++);
        write(header(page.size()));
        write(page.toByteArray());
        page.reset();
      }
    }
    pages[columns.size()] = position;
    groups.add(new Group(filled, pages));
    filled = 0;
  }

  private byte[] header(int size) {
    return new ThriftWriter()
        .i32(1, DATA_PAGE)
        .i32(2, size)
        .i32(3, size)
        .struct(5)
        .i32(1, filled)
        .i32(2, PLAIN)
        .i32(3, RLE)
        .i32(4, RLE)
        .end()
        .end()
        .take();
  }

  /**
   * Ends the table; the stream is flushed, not closed.
   *
   * @param metadata of the file, by key
   * @throws IOException if it cannot be written
   */
  public void finish(Map<String, String> metadata) throws IOException {
    if (filled > 0) {
      writeGroup();
    }
    long start = position;
    writeFooter(new TreeMap<>(metadata));
    int length = (int) (position - start);
    write(ByteBuffer.allocate(4).order(ByteOrder.LITTLE_ENDIAN).putInt(length).array());
    write(MAGIC);
    out.flush();
  }

  /** Writes the structure FileMetaData. */
  private void writeFooter(Map<String, String> metadata) throws IOException {
    ThriftWriter footer = new ThriftWriter();
    footer.i32(1, 1).list(2, ThriftWriter.STRUCT, columns.size() + 1);
    footer.element().text(4, "schema").i32(5, columns.size()).end();
    for (Column column : columns) {
      footer.element().i32(1, type(column)).i32(3, REQUIRED).text(4, column.name());
      if (column.kind() == Kind.TEXT) {
        footer.i32(6, UTF8);
      }
      footer.end();
    }
    footer.i64(3, rows).list(4, ThriftWriter.STRUCT, groups.size());
    for (Group group : groups) {
      append(group, footer);
      write(footer.take());
    }
    footer.list(5, ThriftWriter.STRUCT, metadata.size());
    metadata.forEach((key, value) -> footer.element().text(1, key).text(2, value).end());
    footer.text(6, "MechService").end();
    write(footer.take());
  }

  private static int type(Column column) {
    return column.kind() == Kind.NUMBER ? TYPE_DOUBLE : TYPE_BYTE_ARRAY;
  }

  private void append(Group group, ThriftWriter footer) {
    footer.element().list(1, ThriftWriter.STRUCT, columns.size());
    for (int i = 0; i < columns.size(); i++) {
      long page = group.pages()[i];
      long size = group.pages()[i + 1] - page;
      footer.element().i64(2, page).struct(3);
      footer.i32(1, type(columns.get(i)));
      footer.list(2, ThriftWriter.I32, 1).i32(PLAIN);
      footer.list(3, ThriftWriter.BINARY, 1).text(columns.get(i).name());
      footer.i32(4, UNCOMPRESSED).i64(5, group.rows());
      footer.i64(6, size).i64(7, size).i64(9, page);
      footer.end().end();
    }
    long size = group.pages()[columns.size()] - group.pages()[0];
    footer.i64(2, size).i64(3, group.rows()).end();
  }
}
