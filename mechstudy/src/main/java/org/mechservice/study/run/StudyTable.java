package org.mechservice.study.run;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonObject;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;

/** The table of a study, and the file beside it that says where it comes from. */
final class StudyTable {
  private static final Gson JSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

  private final int factors;
  private final int outputs;

  /** Hands out rows. */
  interface Rows {
    void each(StudyJournal.RowReader row) throws IOException;
  }

  StudyTable(int factors, int outputs) {
    this.factors = factors;
    this.outputs = outputs;
  }

  /** Adds a row to statistics. */
  void addTo(StudyStatistics statistics, String line) {
    List<String> cells = CsvLine.cells(line);
    double[] values = new double[outputs];
    int first = factors + 4;
    for (int i = 0; i < outputs; i++) {
      String cell = cells.get(first + i);
      values[i] = cell.isEmpty() ? Double.NaN : Double.parseDouble(cell);
    }
    statistics.add(cells.get(factors + 1).equals(StudyPlan.FAILED), values);
  }

  /** Returns the file beside a table. */
  static Path beside(Path table) {
    String name = table.getFileName().toString();
    return table.resolveSibling(name.substring(0, name.lastIndexOf('.')) + ".study.json");
  }

  /** Returns what the file beside the table says. */
  static JsonObject provenance(JsonObject identity, StudyPart part, StudyStatistics statistics) {
    JsonObject all = new JsonObject();
    all.add("identity", identity);
    if (!part.isWhole()) {
      all.addProperty("part", part.toString());
    }
    all.addProperty("rows", statistics.rows());
    all.addProperty("failed", statistics.failed());
    all.add("statistics", statistics.json());
    return all;
  }

  static String text(JsonObject provenance) {
    return JSON.toJson(provenance) + "\n";
  }

  /** Writes whole files: none is seen under its name before it is complete. */
  static void write(Path file, String header, String provenance, Rows rows) throws IOException {
    Path growing = file.resolveSibling("." + file.getFileName() + ".growing");
    try (BufferedWriter out = Files.newBufferedWriter(growing, StandardCharsets.UTF_8)) {
      out.write(header);
      rows.each(
          line -> {
            out.write(line);
            out.write('\n');
          });
    }
    move(growing, file);
    Path beside = beside(file);
    Path growingBeside = beside.resolveSibling("." + beside.getFileName() + ".growing");
    Files.writeString(growingBeside, provenance);
    move(growingBeside, beside);
  }

  private static void move(Path from, Path to) throws IOException {
    Files.move(from, to, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
  }
}
