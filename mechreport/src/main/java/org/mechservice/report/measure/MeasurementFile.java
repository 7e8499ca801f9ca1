package org.mechservice.report.measure;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The file of all runs. Each run is written at its end, and read again when an interrupted report
 * is resumed. It contains the data of the page.
 */
public final class MeasurementFile implements AutoCloseable {
  private final List<MeasuredRun> runs = new ArrayList<>();
  private final BufferedWriter out;

  private MeasurementFile(List<MeasuredRun> kept, BufferedWriter out) {
    runs.addAll(kept);
    this.out = out;
  }

  /**
   * Opens a journal; runs in it are kept if they were made for the same purpose.
   *
   * @param purpose model, settings and versions in one line
   * @throws IOException if the file cannot be used
   */
  public static MeasurementFile open(Path file, String purpose) throws IOException {
    String title = "# " + purpose;
    List<MeasuredRun> kept = new ArrayList<>();
    if (Files.exists(file)) {
      List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
      if (lines.size() > 1 && lines.get(0).equals(title)) {
        kept = complete(lines);
      }
    }
    BufferedWriter out = Files.newBufferedWriter(file, StandardCharsets.UTF_8);
    MeasurementFile journal = new MeasurementFile(kept, out);
    journal.writeLine(title);
    journal.writeLine(MeasuredRun.HEADER);
    for (MeasuredRun run : kept) {
      journal.writeLine(run.line());
    }
    out.flush();
    return journal;
  }

  /** The last line may have been cut off with the process that wrote it. */
  private static List<MeasuredRun> complete(List<String> lines) {
    List<MeasuredRun> runs = new ArrayList<>();
    for (String line : lines.subList(2, lines.size())) {
      try {
        runs.add(MeasuredRun.parse(line));
      } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
        break;
      }
    }
    return runs;
  }

  /** Reads the runs of a journal, whatever it was made for; none of a file that is not one. */
  public static List<MeasuredRun> read(Path file) throws IOException {
    List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
    return lines.size() > 1 && lines.get(1).equals(MeasuredRun.HEADER)
        ? complete(lines)
        : List.of();
  }

  private void writeLine(String line) throws IOException {
    out.write(line);
    out.write('\n');
  }

  /** Adds a run. */
  public void add(MeasuredRun run) throws IOException {
    runs.add(run);
    writeLine(run.line());
    out.flush();
  }

  /** Returns all runs, in the order they were made. */
  public List<MeasuredRun> runs() {
    return List.copyOf(runs);
  }

  /** Returns the runs of a method at a tolerance. */
  public List<MeasuredRun> runs(String method, double tolerance) {
    return runs.stream()
        .filter(run -> run.method().equals(method) && run.tolerance() == tolerance)
        .toList();
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
