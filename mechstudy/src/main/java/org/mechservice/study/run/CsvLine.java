package org.mechservice.study.run;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.text.ShortestDecimal;

/** Lines of a table, RFC 4180; no cell has a line break. */
final class CsvLine {
  private static final int LONGEST_NUMBER = 32;
  private static final ThreadLocal<NumberText> NUMBERS = ThreadLocal.withInitial(NumberText::new);

  private CsvLine() {}

  /** Returns a line with its line break. */
  static String of(List<String> cells) {
    StringBuilder line = new StringBuilder();
    for (String cell : cells) {
      if (line.length() > 0) {
        line.append(',');
      }
      if (cell.indexOf(',') >= 0 || cell.indexOf('"') >= 0) {
        line.append('"').append(cell.replace("\"", "\"\"")).append('"');
      } else {
        line.append(cell);
      }
    }
    return line.append('\n').toString();
  }

  /** Returns the shortest decimal of a finite number. */
  static String number(double value) {
    return NUMBERS.get().text(value);
  }

  /** A writer of numbers, which keeps its powers of ten. */
  private static final class NumberText {
    private final ShortestDecimal decimal = new ShortestDecimal();
    private final byte[] bytes = new byte[LONGEST_NUMBER];

    String text(double value) {
      int end = decimal.write(value, bytes, 0);
      return new String(bytes, 0, end, StandardCharsets.US_ASCII);
    }
  }

  /** Returns the cells of a line without its line break. */
  static List<String> cells(String line) {
    List<String> cells = new ArrayList<>();
    StringBuilder cell = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (c == '"') {
        boolean doubled = quoted && i + 1 < line.length() && line.charAt(i + 1) == '"';
        if (doubled) {
          cell.append(c);
          i++;
        } else {
          quoted = !quoted;
        }
      } else if (c == ',' && !quoted) {
        cells.add(cell.toString());
        cell.setLength(0);
      } else {
        cell.append(c);
      }
    }
    cells.add(cell.toString());
    return cells;
  }
}
