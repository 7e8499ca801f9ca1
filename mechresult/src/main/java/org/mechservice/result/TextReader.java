package org.mechservice.result;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads CSV and TSV with one header line; the units from the file beside it, if there is one. */
final class TextReader {
  private TextReader() {}

  static SignalTable read(Path file, char separator) throws IOException {
    try (BufferedReader text = Files.newBufferedReader(file)) {
      String header = text.readLine();
      if (header == null || header.isEmpty()) {
        throw new IOException("it is empty; the first line must name the columns");
      }
      GrowingTable table = new GrowingTable(cells(header, separator));
      double[] row = new double[table.columnCount() + 1];
      for (String line = text.readLine(); line != null; line = text.readLine()) {
        if (!line.isEmpty()) {
          table.add(row, numbers(line, separator, row));
        }
      }
      return table.table(units(file));
    }
  }

  /** Splits the header; a name in quotation marks may contain the separator. */
  private static List<String> cells(String line, char separator) {
    List<String> cells = new ArrayList<>();
    StringBuilder cell = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      boolean doubled = quoted && c == '"' && i + 1 < line.length() && line.charAt(i + 1) == '"';
      if (doubled) {
        cell.append('"');
        i++;
      } else if (c == '"') {
        quoted = !quoted;
      } else if (c == separator && !quoted) {
        cells.add(cell.toString());
        cell.setLength(0);
      } else if (c != '\uFEFF') {
        cell.append(c);
      }
    }
    cells.add(cell.toString());
    return cells;
  }

  /** Puts the numbers of a line into a row, whose last place shows that there are too many. */
  private static int numbers(String line, char separator, double[] row) {
    int count = 0;
    int begin = 0;
    while (begin <= line.length() && count < row.length) {
      int end = line.indexOf(separator, begin);
      end = end < 0 ? line.length() : end;
      String cell = line.substring(begin, end).strip();
      row[count++] = cell.isEmpty() ? Double.NaN : Double.parseDouble(cell);
      begin = end + 1;
    }
    return count;
  }

  private static Map<String, String> units(Path file) throws IOException {
    String name = String.valueOf(file.getFileName());
    Path beside = file.resolveSibling(name.substring(0, name.length() - 4) + ".units.json");
    return Files.isRegularFile(beside) ? units(Files.readString(beside)) : Map.of();
  }

  /** Returns the units of a JSON object of name and unit. */
  static Map<String, String> units(String json) {
    JsonObject object = JsonParser.parseString(json).getAsJsonObject();
    Map<String, String> units = new LinkedHashMap<>();
    object.entrySet().forEach(unit -> units.put(unit.getKey(), unit.getValue().getAsString()));
    return units;
  }
}
