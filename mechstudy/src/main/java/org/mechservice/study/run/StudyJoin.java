package org.mechservice.study.run;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;

/** Puts the parts of a study together. */
public final class StudyJoin {
  /** The content of the file beside a part's table. */
  private record Part(Path table, StudyPart part, JsonObject json) {}

  private StudyJoin() {}

  /**
   * Writes the table that the whole study would have written.
   *
   * @param tables of all parts, in any order
   * @throws IOException S-182 if they are not the parts of one study, each once; also if a file
   *     cannot be read or written
   */
  public static void join(List<Path> tables, Path out) throws IOException {
    TreeMap<Integer, Part> parts = new TreeMap<>();
    for (Path table : tables) {
      Part part = read(table);
      Part first = parts.isEmpty() ? part : parts.firstEntry().getValue();
      if (!identity(part).equals(identity(first)) || part.part.count() != first.part.count()) {
        throw refused(
            table + " is of another study, model, version or division than " + first.table);
      }
      Part twice = parts.put(part.part.number(), part);
      if (twice != null) {
        throw refused(twice.table + " and " + table + " are both part " + part.part);
      }
    }
    int count = parts.firstEntry().getValue().part.count();
    for (int i = 1; i <= count; i++) {
      if (!parts.containsKey(i)) {
        throw refused("part " + i + "/" + count + " is missing");
      }
    }
    write(parts.values(), out);
  }

  private static IOException refused(String why) {
    return new IOException(MessageCode.STUDY_PARTS + " " + why);
  }

  private static JsonObject identity(Part part) {
    return part.json.getAsJsonObject("identity");
  }

  private static Part read(Path table) throws IOException {
    if (StudyTable.isParquet(table)) {
      throw refused(table + " is a Parquet table; parts are joined from .csv tables");
    }
    Path beside = StudyTable.beside(table);
    try {
      JsonObject json = JsonParser.parseString(Files.readString(beside)).getAsJsonObject();
      JsonElement part = json.get("part");
      return new Part(
          table, part == null ? StudyPart.WHOLE : StudyPart.parse(part.getAsString()), json);
    } catch (JsonParseException | IllegalStateException | IllegalArgumentException e) {
      throw new IOException(
          MessageCode.STUDY_PARTS + " " + beside + " is not what mech study writes beside a table",
          e);
    }
  }

  private static void write(Collection<Part> parts, Path out) throws IOException {
    Part first = parts.iterator().next();
    JsonObject identity = identity(first);
    List<StudyOutput> outputs = outputs(first.json);
    StopRule stop = stop(identity, outputs);
    StudyTable table = new StudyTable(identity.getAsJsonObject("units").size(), outputs.size());
    StudyStatistics statistics = new StudyStatistics(outputs, StudyRows.factorsOfIndices(identity));
    List<String> header = new ArrayList<>();
    List<Integer> rows = new ArrayList<>();
    for (Part part : parts) {
      int taken = 0;
      try (BufferedReader lines = Files.newBufferedReader(part.table)) {
        header.add(String.valueOf(lines.readLine()));
        for (String line = lines.readLine();
            line != null && !stop.ends(statistics);
            line = lines.readLine()) {
          table.addTo(statistics, line);
          taken++;
        }
      }
      int all = part.json.get("rows").getAsInt();
      if (taken != all && !stop.ends(statistics)) {
        throw refused(part.table + " has " + taken + " rows of " + all + "; run this part again");
      }
      rows.add(taken);
    }
    table.write(
        out,
        header.get(0) + "\n",
        StudyTable.text(StudyTable.provenance(identity, StudyPart.WHOLE, statistics)),
        row -> {
          int i = 0;
          for (Part part : parts) {
            copy(part.table, rows.get(i++), row);
          }
        });
  }

  private static void copy(Path table, int rows, StudyJournal.RowReader row) throws IOException {
    try (BufferedReader lines = Files.newBufferedReader(table)) {
      lines.readLine();
      for (int i = 0; i < rows; i++) {
        row.take(String.valueOf(lines.readLine()));
      }
    }
  }

  private static List<StudyOutput> outputs(JsonObject json) {
    List<StudyOutput> outputs = new ArrayList<>();
    for (JsonElement one : json.getAsJsonArray("statistics")) {
      JsonObject output = one.getAsJsonObject();
      JsonElement failing = output.get("failing");
      outputs.add(
          new StudyOutput(
              output.get("output").getAsString(),
              "",
              output.get("unit").getAsString(),
              Unit.ONE,
              failing == null ? OptionalDouble.empty() : OptionalDouble.of(failing.getAsDouble())));
    }
    return outputs;
  }

  private static StopRule stop(JsonObject identity, List<StudyOutput> outputs) {
    JsonArray given = identity.getAsJsonArray("stop");
    if (given.isEmpty()) {
      return StopRule.NONE;
    }
    JsonObject stop = given.get(0).getAsJsonObject();
    int failures = stop.has("failures") ? stop.get("failures").getAsInt() : 0;
    if (!stop.has("output")) {
      return new StopRule(failures, -1, 0);
    }
    List<String> names = outputs.stream().map(StudyOutput::name).toList();
    return new StopRule(
        failures,
        names.indexOf(stop.get("output").getAsString().strip()),
        stop.get("error").getAsDouble());
  }
}
