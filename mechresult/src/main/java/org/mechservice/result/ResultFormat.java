package org.mechservice.result;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.solver.text.CsvWriter;
import org.mechservice.solver.text.ResultFile;
import org.mechservice.solver.text.ResultWriter;

/** The formats of result files. The ending of a file's name chooses its format. */
public enum ResultFormat implements ResultFile.Format {
  /** Values separated by commas, RFC 4180; the units beside it. */
  CSV(true, true) {
    @Override
    public ResultWriter writer(OutputStream out, Path file) {
      return new CsvWriter(out);
    }
  },
  /** Values separated by tabs; the units beside it. */
  TSV(true, true) {
    @Override
    public ResultWriter writer(OutputStream out, Path file) {
      return new CsvWriter(out, '\t');
    }
  },
  /** MATLAB's format of level 5: {@code data}, {@code names}, {@code units}. */
  MAT(false, false) {
    @Override
    public ResultWriter writer(OutputStream out, Path file) throws IOException {
      return new MatWriter(out, file);
    }

    @Override
    public Optional<String> refusal(long rows, int columns) {
      return MatWriter.refusal(rows, columns);
    }
  },
  /** One JSON object: {@code columns}, {@code units}, {@code rows}. */
  JSON(false, false) {
    @Override
    public ResultWriter writer(OutputStream out, Path file) {
      return new JsonWriter(out);
    }
  },
  /** Apache Parquet, one column of 64-bit numbers for each column; the units in its metadata. */
  PARQUET(false, false) {
    @Override
    public ResultWriter writer(OutputStream out, Path file) {
      return new ParquetWriter(out);
    }
  };

  private final boolean unitsBeside;
  private final boolean readableUnfinished;

  ResultFormat(boolean unitsBeside, boolean readableUnfinished) {
    this.unitsBeside = unitsBeside;
    this.readableUnfinished = readableUnfinished;
  }

  /** Returns the format of a file by the ending of its name, in any case; empty if none has it. */
  public static Optional<ResultFormat> of(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    return Arrays.stream(values()).filter(format -> name.endsWith(format.ending())).findFirst();
  }

  /** Returns the endings of all formats, separated by commas. */
  public static String endings() {
    return Arrays.stream(values()).map(ResultFormat::ending).collect(Collectors.joining(", "));
  }

  @Override
  public String ending() {
    return '.' + name().toLowerCase(Locale.ROOT);
  }

  @Override
  public boolean unitsBeside() {
    return unitsBeside;
  }

  @Override
  public boolean readableUnfinished() {
    return readableUnfinished;
  }

  /**
   * Returns why a file of this format cannot hold a result; empty if it can.
   *
   * @param rows number of rows
   * @param columns number of columns, with time
   */
  public Optional<String> refusal(long rows, int columns) {
    return Optional.empty();
  }

  /** Returns whether there are results that a file of this format cannot hold. */
  public boolean isLimited() {
    return refusal(Long.MAX_VALUE, 1).isPresent();
  }
}
