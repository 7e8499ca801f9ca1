package org.mechservice.cli.simulate;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.result.ResultFormat;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.CsvWriter;
import org.mechservice.solver.text.ResultFile;
import org.mechservice.solver.text.Sha256;

/** The files that take the rows of one run, and standard output if it does; there may be none. */
public final class ResultFiles implements ResultSink, AutoCloseable {
  /** The name that stands for standard output, which takes CSV. */
  static final Path STANDARD_OUTPUT = Path.of("-");

  private final List<Path> targets;
  private final List<ResultFile> files = new ArrayList<>();
  private final List<AnimationFile> animations;
  private final Optional<CsvWriter> printed;
  private final MessageDigest printedDigest = Sha256.digest();
  private final OptionalLong expectedRows;
  private long rows;
  private double time;

  private ResultFiles(
      List<Path> targets,
      PrintWriter terminal,
      OptionalLong expectedRows,
      List<AnimationFile> animations) {
    this.targets = List.copyOf(targets);
    this.animations = List.copyOf(animations);
    this.expectedRows = expectedRows;
    printed =
        targets.contains(STANDARD_OUTPUT)
            ? Optional.of(
                new CsvWriter(new DigestOutputStream(new PrintedRows(terminal), printedDigest)))
            : Optional.empty();
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
      if (!target.equals(STANDARD_OUTPUT)) {
        requireUsableName(target);
      }
      if (!seen.add(target.toAbsolutePath().normalize())) {
        throw new UsageException(
            MessageCode.RESULT_FILE_NAME + " --out " + target + " is given twice");
      }
    }
  }

  private static void requireUsableName(Path target) {
    if (AnimationFile.is(target)) {
      throw new UsageException(
          MessageCode.RESULT_FILE_NAME
              + " --out "
              + target
              + ": an animated scene needs a model; write it by mech simulate MODEL.xml --out "
              + target);
    }
    if (ResultFormat.of(target).isEmpty()) {
      throw new UsageException(
          MessageCode.RESULT_FILE_NAME
              + " --out "
              + target
              + ": results are written to files whose names end in "
              + ResultFormat.endings()
              + ", or as CSV to - (standard output)");
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
  }

  /**
   * Opens the files under temporary names.
   *
   * @param terminal standard output
   * @param expectedRows number of rows that the settings of the run give; empty: not known
   * @param animations those of the files that are animated scenes
   * @throws IOException if one cannot be written
   */
  static ResultFiles open(
      List<Path> targets,
      PrintWriter terminal,
      OptionalLong expectedRows,
      List<AnimationFile> animations)
      throws IOException {
    ResultFiles files = new ResultFiles(targets, terminal, expectedRows, animations);
    try {
      for (Path target : targets) {
        if (!target.equals(STANDARD_OUTPUT) && !AnimationFile.is(target)) {
          files.files.add(new ResultFile(target, format(target)));
        }
      }
    } catch (IOException e) {
      files.close();
      throw e;
    }
    return files;
  }

  private static ResultFormat format(Path target) {
    return ResultFormat.of(target).orElseThrow();
  }

  /**
   * {@inheritDoc}
   *
   * @throws UsageException S-176 if a file cannot hold so many rows and columns
   */
  @Override
  public void begin(List<Variable> columns) throws IOException {
    if (expectedRows.isPresent()) {
      requireRoom(expectedRows.getAsLong(), columns.size());
    }
    if (printed.isPresent()) {
      printed.get().begin(columns);
    }
    for (ResultFile file : files) {
      file.begin(columns);
    }
    for (AnimationFile animation : animations) {
      animation.begin(columns);
    }
  }

  private void requireRoom(long rowsToCome, int columns) {
    for (Path target : targets) {
      Optional<String> refusal =
          ResultFormat.of(target).flatMap(format -> format.refusal(rowsToCome, columns));
      if (refusal.isPresent()) {
        throw new UsageException(
            MessageCode.RESULT_TOO_LARGE
                + " --out "
                + target
                + " cannot hold the "
                + rowsToCome
                + " rows of this run: "
                + refusal.get());
      }
    }
  }

  @Override
  public void row(double[] values) throws IOException {
    if (printed.isPresent()) {
      printed.get().row(values);
    }
    for (ResultFile file : files) {
      file.row(values);
    }
    for (AnimationFile animation : animations) {
      animation.row(values);
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
  String filesOfRows() {
    return targets.isEmpty() || rows == 0 ? "" : " Rows up to there are in " + this + ".";
  }

  /**
   * Puts the files in their places.
   *
   * @return SHA-256 of the first table, or else of what was printed; empty if there is neither
   * @throws IOException if a file cannot be completed
   */
  Optional<String> keep() throws IOException {
    List<String> hashes = new ArrayList<>();
    for (ResultFile file : files) {
      hashes.add(file.keep());
    }
    for (AnimationFile animation : animations) {
      animation.keep();
    }
    if (printed.isPresent()) {
      printed.get().finish();
      hashes.add(HexFormat.of().formatHex(printedDigest.digest()));
    }
    return hashes.stream().findFirst();
  }

  /** Returns whether a file takes a limited number of rows only. */
  static boolean haveLimit(List<Path> targets) {
    return targets.stream()
        .flatMap(target -> ResultFormat.of(target).stream())
        .anyMatch(ResultFormat::isLimited);
  }

  /** Returns whether the rows go to standard output, which then takes nothing else. */
  static boolean arePrinted(List<Path> targets) {
    return targets.contains(STANDARD_OUTPUT);
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
    return targets.stream()
        .map(target -> target.equals(STANDARD_OUTPUT) ? "standard output" : target.toString())
        .collect(Collectors.joining(", "));
  }
}
