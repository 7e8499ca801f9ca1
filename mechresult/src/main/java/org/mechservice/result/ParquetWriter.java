package org.mechservice.result;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.text.CsvWriter;
import org.mechservice.solver.text.ResultWriter;

/**
 * Writes rows as an Apache Parquet file: one required column of type DOUBLE for each column, plain
 * encoding, without compression, one page for each column of a row group. The file's metadata have
 * the units under the key {@code units}, a JSON object of name and unit.
 *
 * <p>A row group of at most 64 MB is collected in memory; of a finished one only its place and
 * number of rows are kept.
 */
final class ParquetWriter implements ResultWriter {
  static final byte[] MAGIC = "PAR1".getBytes(StandardCharsets.US_ASCII);

  /** Numbers of parquet.thrift: Type, FieldRepetitionType, Encoding, PageType, CompressionCodec. */
  static final int TYPE_DOUBLE = 5;

  static final int REQUIRED = 0;
  static final int PLAIN = 0;
  private static final int RLE = 3;
  static final int DATA_PAGE = 0;
  static final int UNCOMPRESSED = 0;

  private static final int GROUP_BYTES = 1 << 26;
  private static final int FIRST_ROWS = 256;

  /** A row group: where its first page begins and the length of each page's header. */
  private record Group(long start, int rows, int headerBytes) {
    long pageBytes() {
      return headerBytes + (long) rows * Double.BYTES;
    }
  }

  private final OutputStream out;
  private final List<Group> groups = new ArrayList<>();
  private List<Variable> columns = List.of();
  private double[][] values = new double[0][];
  private int mostRows;
  private int filled;
  private long position;
  private long rows;

  ParquetWriter(OutputStream out) {
    this.out = out;
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    this.columns = List.copyOf(columns);
    mostRows = Math.max(1, GROUP_BYTES / Double.BYTES / columns.size());
    values = new double[columns.size()][Math.min(mostRows, FIRST_ROWS)];
    write(MAGIC);
  }

  private void write(byte[] bytes) throws IOException {
    out.write(bytes);
    position += bytes.length;
  }

  @Override
  public void row(double[] row) throws IOException {
    if (filled == values[0].length) {
      int more = Math.min(mostRows, 2 * filled);
      for (int i = 0; i < values.length; i++) {
        values[i] = Arrays.copyOf(values[i], more);
      }
    }
    for (int i = 0; i < values.length; i++) {
      values[i][filled] = row[i];
    }
    filled++;
    rows++;
    if (filled == mostRows) {
      writeGroup();
    }
  }

  private void writeGroup() throws IOException {
    int size = filled * Double.BYTES;
    byte[] header =
        new ThriftWriter()
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
    groups.add(new Group(position, filled, header.length));
    ByteBuffer page = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    for (double[] column : values) {
      write(header);
      page.clear();
      page.asDoubleBuffer().put(column, 0, filled);
      write(page.array());
    }
    filled = 0;
  }

  @Override
  public void finish() throws IOException {
    if (filled > 0) {
      writeGroup();
    }
    long start = position;
    writeFooter();
    int length = (int) (position - start);
    write(ByteBuffer.allocate(4).order(ByteOrder.LITTLE_ENDIAN).putInt(length).array());
    write(MAGIC);
    out.flush();
  }

  /** Writes the structure FileMetaData. */
  private void writeFooter() throws IOException {
    ThriftWriter footer = new ThriftWriter();
    footer.i32(1, 1).list(2, ThriftWriter.STRUCT, columns.size() + 1);
    footer.element().text(4, "schema").i32(5, columns.size()).end();
    for (Variable column : columns) {
      footer.element().i32(1, TYPE_DOUBLE).i32(3, REQUIRED).text(4, column.name()).end();
    }
    footer.i64(3, rows).list(4, ThriftWriter.STRUCT, groups.size());
    for (Group group : groups) {
      append(group, footer);
      write(footer.take());
    }
    footer.list(5, ThriftWriter.STRUCT, 1);
    footer.element().text(1, "units").text(2, CsvWriter.unitsJson(columns)).end();
    footer.text(6, "MechService").end();
    write(footer.take());
  }

  private void append(Group group, ThriftWriter footer) {
    long page = group.start();
    footer.element().list(1, ThriftWriter.STRUCT, columns.size());
    for (Variable column : columns) {
      footer.element().i64(2, page).struct(3);
      footer.i32(1, TYPE_DOUBLE);
      footer.list(2, ThriftWriter.I32, 1).i32(PLAIN);
      footer.list(3, ThriftWriter.BINARY, 1).text(column.name());
      footer.i32(4, UNCOMPRESSED).i64(5, group.rows());
      footer.i64(6, group.pageBytes()).i64(7, group.pageBytes()).i64(9, page);
      footer.end().end();
      page += group.pageBytes();
    }
    footer.i64(2, columns.size() * group.pageBytes()).i64(3, group.rows()).end();
  }

  @Override
  public void close() throws IOException {
    values = new double[0][];
    out.close();
  }
}
