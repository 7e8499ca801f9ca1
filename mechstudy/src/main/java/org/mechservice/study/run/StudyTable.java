package org.mechservice.study.run;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonObject;
import java.io.BufferedOutputStream;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.mechservice.result.ParquetTable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The table of a study, and the file beside it that says where it comes from. In a Parquet table
 * points, factors and outputs are columns of numbers, outcomes, codes and messages of texts; an
 * output without value is NaN; the metadata have what the file beside it says, under {@code study}.
 */
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

  /** Returns whether a table of this name is written in Parquet. */
  static boolean isParquet(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".parquet");
  }

  /**
   * Writes whole files: none is seen under its name before it is complete.
   *
   * @param header with its line break
   */
  void write(Path file, String header, String provenance, Rows rows) throws IOException {
    try {
      writeBoth(file, header, provenance, rows);
    } catch (FileSystemException e) {
      throw e;
    } catch (IOException e) {
      throw new IOException(
          MessageCode.FILE_UNUSABLE + " " + file + " cannot be written: " + e.getMessage(), e);
    }
  }

  private void writeBoth(Path file, String header, String provenance, Rows rows)
      throws IOException {
    Path growing = file.resolveSibling("." + file.getFileName() + ".growing");
    if (isParquet(file)) {
      try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(growing))) {
        writeParquet(out, header, provenance, rows);
      }
    } else {
      try (BufferedWriter out = Files.newBufferedWriter(growing, StandardCharsets.UTF_8)) {
        out.write(header);
        rows.each(
            line -> {
              out.write(line);
              out.write('\n');
            });
      }
    }
    move(growing, file);
    Path beside = beside(file);
    Path growingBeside = beside.resolveSibling("." + beside.getFileName() + ".growing");
    Files.writeString(growingBeside, provenance);
    move(growingBeside, beside);
  }

  /**
   * @param header of the CSV table, with its line break
   */
  void writeParquet(OutputStream out, String header, String provenance, Rows rows)
      throws IOException {
    List<String> names = CsvLine.cells(header.strip());
    int words = 3;
    List<ParquetTable.Column> columns = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      boolean isText = i > factors && i <= factors + words;
      columns.add(
          new ParquetTable.Column(
              names.get(i), isText ? ParquetTable.Kind.TEXT : ParquetTable.Kind.NUMBER));
    }
    ParquetTable table = new ParquetTable(out, columns);
    double[] numbers = new double[1 + factors + outputs];
    rows.each(
        line -> {
          List<String> cells = CsvLine.cells(line);
          for (int i = 0; i < numbers.length; i++) {
            String cell = cells.get(i <= factors ? i : i + words);
            numbers[i] = cell.isEmpty() ? Double.NaN : Double.parseDouble(cell);
          }
          table.row(numbers, cells.subList(factors + 1, factors + 1 + words));
        });
    table.finish(Map.of("study", provenance));
  }

  private static void move(Path from, Path to) throws IOException {
    Files.move(from, to, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
  }
}
