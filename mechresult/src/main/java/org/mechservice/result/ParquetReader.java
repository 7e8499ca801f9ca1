package org.mechservice.result;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.result.Variable;

/**
 * Reads Parquet files of the form that {@link ParquetWriter} writes: required columns of type
 * DOUBLE in plain encoding without compression, pages of the first version. Others are refused.
 */
final class ParquetReader {
  private static final int TAIL = 8;

  /** Longest header of a page, with statistics of other writers. */
  private static final int LONGEST_PAGE_HEADER = 1 << 12;

  private final FileChannel file;

  private ParquetReader(FileChannel file) {
    this.file = file;
  }

  static SignalTable read(Path path) throws IOException {
    try (FileChannel file = FileChannel.open(path)) {
      return new ParquetReader(file).read();
    }
  }

  private SignalTable read() throws IOException {
    long end = file.size() - TAIL;
    ByteBuffer tail = bytes(Math.max(0, end), TAIL);
    long length = tail.getInt();
    byte[] magic = new byte[ParquetTable.MAGIC.length];
    tail.get(magic);
    if (!Arrays.equals(magic, ParquetTable.MAGIC) || length < 0 || length > end) {
      throw new IOException("it has no footer of a Parquet file, it may be incomplete");
    }
    Map<Integer, Object> footer = new ThriftReader(bytes(end - length, (int) length)).struct();
    Map<String, String> units = units(footer);
    List<Variable> columns = new ArrayList<>();
    for (Object element : list(footer, 2).subList(1, list(footer, 2).size())) {
      columns.add(column(struct(element), units));
    }
    int rows = Math.toIntExact(number(footer, 3));
    if (rows < 0 || (double) rows * columns.size() * Double.BYTES > file.size()) {
      throw new EOFException("it ends too early");
    }
    List<double[]> values = new ArrayList<>();
    for (int i = 0; i < columns.size(); i++) {
      values.add(column(footer, i, rows));
    }
    return new SignalTable(columns, values);
  }

  private static Map<String, String> units(Map<Integer, Object> footer) throws IOException {
    if (footer.containsKey(5)) {
      for (Object pair : list(footer, 5)) {
        if ("units".equals(struct(pair).get(1))) {
          return TextReader.units(String.valueOf(struct(pair).get(2)));
        }
      }
    }
    return Map.of();
  }

  private static Variable column(Map<Integer, Object> element, Map<String, String> units)
      throws IOException {
    String name = String.valueOf(element.get(4));
    require(
        element.containsKey(1)
            && number(element, 1) == ParquetTable.TYPE_DOUBLE
            && number(element, 3) == ParquetTable.REQUIRED,
        name);
    return new Variable(name, units.getOrDefault(name, ""));
  }

  private static void require(boolean met, String column) throws IOException {
    if (!met) {
      throw new IOException(
          "column "
              + column
              + " is not what mech writes and reads: required, of type DOUBLE, plain encoding, not"
              + " compressed; convert the file to CSV");
    }
  }

  private double[] column(Map<Integer, Object> footer, int column, int rows) throws IOException {
    double[] values = new double[rows];
    int filled = 0;
    for (Object group : list(footer, 4)) {
      Map<Integer, Object> chunk = struct(list(struct(group), 1).get(column));
      Map<Integer, Object> meta = struct(chunk.get(3));
      String name = String.valueOf(list(meta, 3));
      require(number(meta, 4) == ParquetTable.UNCOMPRESSED && !meta.containsKey(11), name);
      long at = number(meta, 9);
      long last = filled + number(meta, 5);
      while (filled < last) {
        ByteBuffer head = bytes(at, (int) Math.min(LONGEST_PAGE_HEADER, file.size() - at));
        Map<Integer, Object> page = new ThriftReader(head).struct();
        require(number(page, 1) == ParquetTable.DATA_PAGE, name);
        Map<Integer, Object> data = struct(page.get(5));
        require(number(data, 2) == ParquetTable.PLAIN, name);
        int count = Math.toIntExact(number(data, 1));
        at += head.position();
        bytes(at, count * Double.BYTES).asDoubleBuffer().get(values, filled, count);
        at += (long) count * Double.BYTES;
        filled += count;
      }
    }
    return values;
  }

  private ByteBuffer bytes(long at, int count) throws IOException {
    if (at < 0 || count < 0 || at + count > file.size()) {
      throw new EOFException("it ends too early");
    }
    ByteBuffer bytes = ByteBuffer.allocate(count).order(ByteOrder.LITTLE_ENDIAN);
    while (bytes.hasRemaining()) {
      if (file.read(bytes, at + bytes.position()) < 0) {
        throw new EOFException("it ends too early");
      }
    }
    return bytes.flip();
  }

  @SuppressWarnings("unchecked") // the reader of structures makes no other maps
  private static Map<Integer, Object> struct(@Nullable Object value) throws IOException {
    if (value instanceof Map<?, ?>) {
      return (Map<Integer, Object>) value;
    }
    throw damaged();
  }

  @SuppressWarnings("unchecked") // the reader of structures makes no other lists
  private static List<Object> list(Map<Integer, Object> struct, int field) throws IOException {
    if (struct.get(field) instanceof List<?> list) {
      return (List<Object>) list;
    }
    throw damaged();
  }

  private static long number(Map<Integer, Object> struct, int field) throws IOException {
    if (struct.get(field) instanceof Long number) {
      return number;
    }
    throw damaged();
  }

  private static IOException damaged() {
    return new IOException("its description of the columns is damaged");
  }
}
