package org.mechservice.cli.simulate;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ResultFile;

/** The files that take the rows of one run; there may be none. */
public final class ResultFiles implements ResultSink, AutoCloseable {
  private final List<Path> targets;
  private final List<ResultFile> files;
  private long rows;
  private double time;

  private ResultFiles(List<Path> targets, List<ResultFile> files) {
    this.targets = targets;
    this.files = files;
  }

  /**
   * Checks names before anything is computed for them.
   *
   * @throws UsageException if one has no format that can be written, no folder to be in, or occurs
   *     twice
   */
  public static void requireUsableNames(List<Path> targets) {
    Set<Path> seen = new HashSet<>();
    for (Path target : targets) {
      if (!target.toString().toLowerCase(Locale.ROOT).endsWith(".csv")) {
        throw new UsageException(
            MessageCode.RESULT_FILE_NAME
                + " --out "
                + target
                + ": results are written to .csv files");
      }
      Path folder = target.toAbsolutePath().getParent();
      if (folder == null || !Files.isDirectory(folder)) {
        throw new UsageException(
            MessageCode.RESULT_FILE_NAME
                + " --out "
                + target
                + ": the folder "
                + folder
                + " does not exist; make it first");
      }
      if (!seen.add(target.toAbsolutePath().normalize())) {
        throw new UsageException(
            MessageCode.RESULT_FILE_NAME + " --out " + target + " is given twice");
      }
    }
  }

  /**
   * Opens the files under temporary names.
   *
   * @throws IOException if one cannot be written
   */
  static ResultFiles open(List<Path> targets) throws IOException {
    ResultFiles files = new ResultFiles(List.copyOf(targets), new ArrayList<>());
    try {
      for (Path target : targets) {
        files.files.add(new ResultFile(target));
      }
    } catch (IOException e) {
      files.close();
      throw e;
    }
    return files;
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    for (ResultFile file : files) {
      file.begin(columns);
    }
  }

  @Override
  public void row(double[] values) throws IOException {
    for (ResultFile file : files) {
      file.row(values);
    }
    rows++;
    time = values[0];
  }

  /** Returns how many rows came. */
  long rows() {
    return rows;
  }

  /** Returns the time of the last row with its unit. */
  String reached() {
    return "t=" + time + " s";
  }

  /** Returns a sentence that names the files, or nothing if there are no rows in any. */
  String whereRowsAre() {
    return files.isEmpty() || rows == 0 ? "" : " Rows up to there are in " + this + ".";
  }

  /**
   * Puts the files in their places.
   *
   * @return SHA-256 of the rows as CSV; empty if there are no files
   * @throws IOException if a file cannot be completed
   */
  Optional<String> keep() throws IOException {
    Optional<String> hash = Optional.empty();
    for (ResultFile file : files) {
      hash = Optional.of(file.keep());
    }
    return hash;
  }

  /** Deletes the files that were not kept. */
  @Override
  public void close() throws IOException {
    for (ResultFile file : files) {
      file.close();
    }
  }

  @Override
  public String toString() {
    return targets.stream().map(Path::toString).collect(Collectors.joining(", "));
  }
}
