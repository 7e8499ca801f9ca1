package org.mechservice.cli.sweep;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.sweep.SweepRow;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The finished points of a sweep, one JSON object a line behind one that says which sweep it is. A
 * line is in the file before the next point is counted as finished, so whatever ends the process,
 * the sweep goes on from there.
 */
final class SweepJournal implements AutoCloseable {
  private final Path file;
  private final Map<Integer, SweepRow> rows;
  private final Writer out;

  private SweepJournal(Path file, Map<Integer, SweepRow> rows, Writer out) {
    this.file = file;
    this.rows = rows;
    this.out = out;
  }

  /**
   * Opens the journal of a sweep, with the rows of an earlier process.
   *
   * @param sweep hash of model, options and grid
   * @throws UsageException with code S-165 if the file is of another sweep
   */
  static SweepJournal open(Path file, JsonObject sweep) throws IOException {
    Map<Integer, SweepRow> rows = new TreeMap<>();
    List<String> kept = new ArrayList<>(List.of(sweep.toString()));
    if (Files.exists(file)) {
      List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
      boolean ours = lines.isEmpty() || lines.get(0).equals(sweep.toString());
      if (!ours && lines.size() > 1) {
        throw new UsageException(
            MessageCode.WRONG_SWEEP_JOURNAL
                + " "
                + file
                + " has points of another sweep; delete it, or choose another file with --out");
      }
      for (String line : lines.stream().skip(1).toList()) {
        try {
          SweepRow row = row(JsonParser.parseString(line).getAsJsonObject());
          rows.put(row.point(), row);
          kept.add(line);
        } catch (JsonParseException | IllegalStateException | NullPointerException e) {
          break; // the process ended while it wrote this
        }
      }
    }
    Files.write(file, kept, StandardCharsets.UTF_8);
    return new SweepJournal(
        file,
        rows,
        Files.newBufferedWriter(
            file, StandardCharsets.UTF_8, StandardOpenOption.WRITE, StandardOpenOption.APPEND));
  }

  /** Returns the finished points by their number. */
  Map<Integer, SweepRow> rows() {
    return rows;
  }

  /** Adds a finished point. */
  void add(SweepRow row) throws IOException {
    rows.put(row.point(), row);
    out.write(json(row) + "\n");
    out.flush();
  }

  /** Deletes the file, as nothing is left to be done. */
  void delete() throws IOException {
    out.close();
    Files.deleteIfExists(file);
  }

  /** Leaves the file for the next process, if there is a point in it. */
  @Override
  public void close() throws IOException {
    out.close();
    if (rows.isEmpty()) {
      Files.deleteIfExists(file);
    }
  }

  private static JsonObject json(SweepRow row) {
    JsonObject json = new JsonObject();
    json.addProperty("point", row.point());
    json.addProperty("outcome", row.outcome());
    json.addProperty("code", row.code());
    json.addProperty("message", row.message());
    JsonArray values = new JsonArray();
    row.values().forEach(value -> values.add(Double.toString(value)));
    json.add("values", values);
    JsonObject report = new JsonObject();
    row.report().forEach((key, value) -> report.add(key, json(value)));
    json.add("report", report);
    return json;
  }

  /** Returns a value of a report; numbers that are not finite have no place in JSON. */
  static JsonElement json(Object value) {
    if (value instanceof Boolean flag) {
      return new JsonPrimitive(flag);
    } else if (value instanceof Number number && Double.isFinite(number.doubleValue())) {
      return new JsonPrimitive(number);
    }
    return new JsonPrimitive(value.toString());
  }

  /** Returns the value that {@link #json(Object)} wrote. */
  private static Object value(JsonPrimitive value) {
    if (value.isBoolean()) {
      return value.getAsBoolean();
    }
    String text = value.getAsString();
    if (!value.isNumber()) {
      return text;
    }
    return text.matches("-?[0-9]+") ? (Object) Long.valueOf(text) : Double.valueOf(text);
  }

  private static SweepRow row(JsonObject json) {
    List<Double> values =
        json.getAsJsonArray("values").asList().stream()
            .map(value -> Double.parseDouble(value.getAsString()))
            .toList();
    Map<String, Object> report = new LinkedHashMap<>();
    json.getAsJsonObject("report")
        .asMap()
        .forEach((key, value) -> report.put(key, value(value.getAsJsonPrimitive())));
    return new SweepRow(
        json.get("point").getAsInt(),
        json.get("outcome").getAsString(),
        json.get("code").getAsString(),
        json.get("message").getAsString(),
        values,
        report);
  }
}
