package org.mechservice.view.plot;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.mechservice.result.ResultFormat;
import org.mechservice.result.SignalTable;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A result file in any format of {@code mech simulate --out}. CSV, after RFC 4180 with one header
 * line and beside {@code r.csv} the units in {@code r.units.json}, is read as a stream: a file of
 * any length takes the memory of a line. The other formats are read into memory.
 */
public final class StoredResult {
  private static final String EXTENSION = ".csv";

  private final Path file;
  private final List<String> names;
  private final Map<String, String> units;

  /** The rows, unless they are read from the file as a stream. */
  private final Optional<SignalTable> table;

  private StoredResult(
      Path file, List<String> names, Map<String, String> units, Optional<SignalTable> table) {
    this.file = file;
    this.names = List.copyOf(names);
    this.units = Map.copyOf(units);
    this.table = table;
  }

  /**
   * Reads the header of a file, and its units if there are any.
   *
   * @throws IOException if it cannot be read
   * @throws IllegalArgumentException with a message code if it is no result file
   */
  public static StoredResult open(Path file) throws IOException {
    Optional<ResultFormat> format = ResultFormat.of(file);
    return format.isPresent() && format.get() != ResultFormat.CSV ? inMemory(file) : csv(file);
  }

  private static StoredResult inMemory(Path file) throws IOException {
    SignalTable table = SignalTable.read(file);
    Map<String, String> units = new HashMap<>();
    table.columns().forEach(column -> units.put(column.name(), column.unit()));
    List<String> names = table.columns().stream().map(Variable::name).toList();
    return new StoredResult(file, names, units, Optional.of(table));
  }

  private static StoredResult csv(Path file) throws IOException {
    try (BufferedReader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      String header = in.readLine();
      if (header == null || header.isBlank()) {
        throw unusable(file, "it is empty; a result file begins with a line of column names");
      }
      List<String> names = cells(header.startsWith("\uFEFF") ? header.substring(1) : header);
      Set<String> seen = new HashSet<>();
      for (String name : names) {
        if (!seen.add(name)) {
          throw unusable(file, "its first line names column \"" + name + "\" twice");
        }
      }
      return new StoredResult(file, names, units(file), Optional.empty());
    } catch (CharacterCodingException e) {
      throw unusable(file, "it is no text in UTF-8");
    }
  }

  private static IllegalArgumentException unusable(Path file, String why) {
    return new IllegalArgumentException(
        MessageCode.FILE_UNUSABLE + " " + file + " cannot be plotted: " + why);
  }

  private static Map<String, String> units(Path file) throws IOException {
    String name = String.valueOf(file.getFileName());
    String stem =
        name.endsWith(EXTENSION) ? name.substring(0, name.length() - EXTENSION.length()) : name;
    Path beside = file.resolveSibling(stem + ".units.json");
    Map<String, String> units = new HashMap<>();
    if (Files.isRegularFile(beside)) {
      try {
        JsonObject object = JsonParser.parseString(Files.readString(beside)).getAsJsonObject();
        for (Map.Entry<String, JsonElement> entry : object.entrySet()) {
          units.put(entry.getKey(), entry.getValue().getAsString());
        }
      } catch (JsonParseException
          | IllegalStateException
          | UnsupportedOperationException
          | CharacterCodingException e) {
        throw unusable(
            beside, "it is no JSON object of column names and units; remove it to plot without");
      }
    }
    return units;
  }

  /** Returns where the file is. */
  public Path file() {
    return file;
  }

  /** Returns the names of the columns in file order. */
  public List<String> names() {
    return names;
  }

  /** Returns the unit of a column; empty if it is not known. */
  public String unit(String column) {
    return units.getOrDefault(column, "");
  }

  /**
   * Reads all rows.
   *
   * @param columns names of the columns wanted; each is one of {@link #names}
   * @param rows takes one array for each row, which is new and in the order of {@code columns}; NaN
   *     stands for an empty cell and for what is not finite
   * @throws IOException if the file cannot be read
   * @throws IllegalArgumentException with a message code, naming the line, if a cell is no number
   *     or a row has not one cell for each column
   */
  public void read(List<String> columns, Consumer<double[]> rows) throws IOException {
    if (table.isPresent()) {
      read(table.get(), columns.stream().mapToInt(names::indexOf).toArray(), rows);
    } else {
      readCsv(columns, rows);
    }
  }

  private static void read(SignalTable table, int[] columns, Consumer<double[]> rows) {
    for (int row = 0; row < table.rows(); row++) {
      double[] values = new double[columns.length];
      for (int i = 0; i < columns.length; i++) {
        double value = table.values().get(columns[i])[row];
        values[i] = Double.isInfinite(value) ? Double.NaN : value;
      }
      rows.accept(values);
    }
  }

  private void readCsv(List<String> columns, Consumer<double[]> rows) throws IOException {
    int[] place = new int[names.size()];
    Arrays.fill(place, -1);
    for (int i = 0; i < columns.size(); i++) {
      place[names.indexOf(columns.get(i))] = i;
    }
    try (BufferedReader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      in.readLine();
      long number = 1;
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        number++;
        if (!line.isBlank() || names.size() == 1) {
          rows.accept(row(line, number, place, columns.size()));
        }
      }
    } catch (CharacterCodingException e) {
      throw unusable(file, "it is no text in UTF-8");
    }
  }

  private double[] row(String line, long number, int[] place, int wanted) {
    double[] row = new double[wanted];
    int column = 0;
    if (line.indexOf('"') >= 0) {
      for (String cell : cells(line)) {
        put(cell, number, column++, place, row);
      }
    } else {
      int from = 0;
      for (int comma = line.indexOf(','); comma >= 0; comma = line.indexOf(',', from)) {
        put(line.substring(from, comma), number, column++, place, row);
        from = comma + 1;
      }
      put(line.substring(from), number, column++, place, row);
    }
    if (column != place.length) {
      throw unusable(
          file,
          "line "
              + number
              + " has "
              + column
              + " values, but the first line names "
              + place.length
              + " columns");
    }
    return row;
  }

  private void put(String cell, long line, int column, int[] place, double[] row) {
    if (column < place.length && place[column] >= 0) {
      row[place[column]] = value(cell, line, column);
    }
  }

  private double value(String cell, long line, int column) {
    String text = cell.strip();
    if (text.isEmpty()) {
      return Double.NaN;
    }
    try {
      double value = Double.parseDouble(text);
      return Double.isInfinite(value) ? Double.NaN : value;
    } catch (NumberFormatException e) {
      if (text.equalsIgnoreCase("nan") || text.matches("(?i)[+-]?inf(inity)?")) {
        return Double.NaN;
      }
      throw unusable(
          file,
          "line "
              + line
              + ", column \""
              + names.get(column)
              + "\": \""
              + (text.length() > 40 ? text.substring(0, 40) + "…" : text)
              + "\" is no number");
    }
  }

  /** Returns the cells of a line after RFC 4180. */
  private static List<String> cells(String line) {
    List<String> cells = new ArrayList<>();
    StringBuilder cell = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (quoted && c == '"' && i + 1 < line.length() && line.charAt(i + 1) == '"') {
        cell.append('"');
        i++;
      } else if (c == '"') {
        quoted = !quoted;
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
