package org.mechservice.solver.text;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.api.result.Variable;

/**
 * Writes rows as CSV (RFC 4180, UTF-8): one header line, then one line per row, every number as the
 * shortest decimal that reads back exactly. With tabs between the values the same is TSV.
 */
public final class CsvWriter implements ResultWriter {
  private static final int BUFFER_SIZE = 1 << 16;

  private final OutputStream out;
  private final char separator;
  private final ShortestDecimal decimal = new ShortestDecimal();
  private final byte[] buffer = new byte[BUFFER_SIZE];
  private int filled;

  /**
   * @param out receives the bytes; closed with this writer
   */
  public CsvWriter(OutputStream out) {
    this(out, ',');
  }

  /**
   * @param out takes the bytes; closed with this writer
   * @param separator stands between two values of a row: a comma or a tab
   */
  public CsvWriter(OutputStream out, char separator) {
    this.out = out;
    this.separator = separator;
  }

  /**
   * Returns the units of the columns as a JSON object, name to unit, for the units file.
   *
   * @param columns the columns of the results
   */
  public static String unitsJson(List<Variable> columns) {
    Map<String, Object> units = new LinkedHashMap<>();
    for (Variable column : columns) {
      units.put(column.name(), column.unit());
    }
    return JsonText.write(units);
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    List<String> names = new ArrayList<>();
    for (Variable column : columns) {
      names.add(quoted(column.name()));
    }
    out.write(
        (String.join(String.valueOf(separator), names) + "\r\n").getBytes(StandardCharsets.UTF_8));
  }

  private String quoted(String name) {
    boolean special =
        name.chars()
            .anyMatch(
                c -> c == ',' || c == separator || c == '"' || c == '\r' || c == '\n' || c == ' ');
    return special ? '"' + name.replace("\"", "\"\"") + '"' : name;
  }

  @Override
  public void row(double[] values) throws IOException {
    for (int i = 0; i < values.length; i++) {
      if (filled > BUFFER_SIZE - ShortestDecimal.MAX_LENGTH - 2) {
        drain();
      }
      if (i > 0) {
        buffer[filled++] = (byte) separator;
      }
      filled = decimal.write(values[i], buffer, filled);
    }
    buffer[filled++] = '\r';
    buffer[filled++] = '\n';
  }

  private void drain() throws IOException {
    out.write(buffer, 0, filled);
    filled = 0;
  }

  /** Passes all bytes written so far to the stream. */
  public void flush() throws IOException {
    drain();
    out.flush();
  }

  @Override
  public void finish() throws IOException {
    flush();
  }

  @Override
  public void close() throws IOException {
    try (out) {
      drain();
    }
  }
}
