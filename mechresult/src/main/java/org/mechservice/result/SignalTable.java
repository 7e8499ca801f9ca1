package org.mechservice.result;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The rows of one result file, in memory.
 *
 * @param columns names and units, in the file's order, the first is time; the unit of a column is
 *     empty if the file does not tell it
 * @param values one array for each column with one number for each row; shared, not to be modified
 */
public record SignalTable(List<Variable> columns, List<double[]> values) {
  public SignalTable {
    columns = List.copyOf(columns);
    values = List.copyOf(values);
  }

  /**
   * Reads a file in the format that its name says.
   *
   * @throws IOException S-042 if it cannot be read, S-177 if it is no result in that format
   */
  public static SignalTable read(Path file) throws IOException {
    ResultFormat format =
        ResultFormat.of(file)
            .orElseThrow(
                () ->
                    unreadable(
                        file, "the name of a result ends in " + ResultFormat.endings(), null));
    if (!Files.isRegularFile(file)) {
      throw new IOException(
          MessageCode.FILE_UNUSABLE + " there is no file " + file + " to read results from");
    }
    try {
      SignalTable table =
          switch (format) {
            case CSV -> TextReader.read(file, ',');
            case TSV -> TextReader.read(file, '\t');
            case MAT -> MatReader.read(file);
            case JSON -> JsonResultReader.read(file);
            case PARQUET -> ParquetReader.read(file);
          };
      return table.checked();
    } catch (IOException | RuntimeException e) {
      // The readers of foreign formats report damaged bytes by exceptions of many kinds.
      throw unreadable(file, reason(e), e);
    }
  }

  /** Returns the first line of what an exception says, without the name of its class. */
  private static String reason(Exception e) {
    String said =
        String.valueOf(e.getMessage())
            .replaceFirst("^(?:[a-z]\\w*\\.)+[A-Z]\\w*: ", "")
            .lines()
            .findFirst()
            .orElse("");
    return e.getMessage() == null || said.isBlank() ? "its bytes make no sense" : said;
  }

  private static IOException unreadable(Path file, String why, @Nullable Exception cause) {
    return new IOException(
        MessageCode.RESULT_UNREADABLE + " " + file + " cannot be read as a result: " + why, cause);
  }

  private SignalTable checked() throws IOException {
    if (columns.isEmpty()) {
      throw new IOException("it has no columns");
    }
    Set<String> names = new HashSet<>();
    for (Variable column : columns) {
      if (!names.add(column.name())) {
        throw new IOException("it has two columns \"" + column.name() + '"');
      }
    }
    double[] time = values.get(0);
    for (int i = 0; i < time.length; i++) {
      if (!Double.isFinite(time[i]) || (i > 0 && time[i] < time[i - 1])) {
        throw new IOException(
            "its first column, \""
                + columns.get(0).name()
                + "\", is not a time that grows: row "
                + (i + 1)
                + " has "
                + time[i]);
      }
    }
    return this;
  }

  /** Returns the number of rows. */
  public int rows() {
    return values.get(0).length;
  }

  /** Returns the times of the rows, s; not to be modified. */
  public double[] time() {
    return values.get(0);
  }
}
