package org.mechservice.result;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.text.CsvWriter;
import org.mechservice.solver.text.JsonText;
import org.mechservice.solver.text.ResultWriter;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * Writes rows as one JSON object (RFC 8259): {@code columns}, the names in order; {@code units}, an
 * object of name and unit; {@code rows}, an array of numbers for each row, one row a line. Every
 * number is the shortest decimal that reads back exactly; one that is not finite is {@code null}.
 */
final class JsonWriter implements ResultWriter {
  private static final int BUFFER_SIZE = 1 << 16;
  private static final int LONGEST_NUMBER = 32;
  private static final byte[] NULL = "null".getBytes(StandardCharsets.US_ASCII);
  private static final byte[] MINUS_ZERO = "-0.0".getBytes(StandardCharsets.US_ASCII);

  private final OutputStream out;
  private final ShortestDecimal decimal = new ShortestDecimal();
  private final byte[] buffer = new byte[BUFFER_SIZE];
  private int filled;
  private boolean hasRows;

  JsonWriter(OutputStream out) {
    this.out = out;
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    String names =
        columns.stream().map(c -> JsonText.quoted(c.name())).collect(Collectors.joining(", "));
    String head =
        "{\n\"columns\": ["
            + names
            + "],\n\"units\": "
            + CsvWriter.unitsJson(columns)
            + ",\n\"rows\": [";
    out.write(head.getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public void row(double[] values) throws IOException {
    if (hasRows) {
      buffer[filled++] = ',';
    }
    hasRows = true;
    buffer[filled++] = '\n';
    for (int i = 0; i < values.length; i++) {
      buffer[filled++] = (byte) (i == 0 ? '[' : ',');
      append(values[i]);
      if (filled > BUFFER_SIZE - LONGEST_NUMBER - 8) {
        drain();
      }
    }
    buffer[filled++] = ']';
  }

  /** Readers that know integers take {@code -0} for one, and lose its sign. */
  private void append(double value) {
    if (!Double.isFinite(value)) {
      append(NULL);
    } else if (value == 0 && 1 / value < 0) {
      append(MINUS_ZERO);
    } else {
      filled = decimal.write(value, buffer, filled);
    }
  }

  private void append(byte[] text) {
    System.arraycopy(text, 0, buffer, filled, text.length);
    filled += text.length;
  }

  private void drain() throws IOException {
    out.write(buffer, 0, filled);
    filled = 0;
  }

  @Override
  public void finish() throws IOException {
    drain();
    out.write("\n]\n}\n".getBytes(StandardCharsets.US_ASCII));
    out.flush();
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
