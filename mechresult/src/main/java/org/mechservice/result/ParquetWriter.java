package org.mechservice.result;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.text.CsvWriter;
import org.mechservice.solver.text.ResultWriter;

/**
 * Writes rows of a run as an Apache Parquet file ({@link ParquetTable}): a number column for each
 * column. The file's metadata have the units under the key {@code units}, a JSON object of name and
 * unit.
 */
final class ParquetWriter implements ResultWriter {
  private static final List<String> NO_TEXTS = List.of();

  private final OutputStream out;
  private List<Variable> columns = List.of();
  private @Nullable ParquetTable table;

  ParquetWriter(OutputStream out) {
    this.out = out;
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    this.columns = List.copyOf(columns);
    table =
        new ParquetTable(
            out,
            columns.stream()
                .map(c -> new ParquetTable.Column(c.name(), ParquetTable.Kind.NUMBER))
                .toList());
  }

  private ParquetTable table() {
    if (table == null) {
      throw new IllegalStateException("begin comes first");
    }
    return table;
  }

  @Override
  public void row(double[] row) throws IOException {
    table().row(row, NO_TEXTS);
  }

  @Override
  public void finish() throws IOException {
    table().finish(Map.of("units", CsvWriter.unitsJson(columns)));
  }

  @Override
  public void close() throws IOException {
    table = null;
    out.close();
  }
}
