package org.mechservice.cli.sweep;

import com.google.gson.JsonArray;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.sweep.SweepGrid;
import org.mechservice.client.sweep.SweepRow;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * The rows of a sweep in the order of its grid: parameters, how the run ended, its last row,
 * figures of its report.
 */
final class SweepTable {
  private final SweepGrid grid;
  private final List<Variable> columns;
  private final List<Integer> taken;
  private final List<String> figures;

  /**
   * @param columns of the runs' rows
   * @param wanted names of those to put out; empty: all
   * @param figures of the report to put out
   * @throws UsageException if there is no column of such a name
   */
  SweepTable(SweepGrid grid, List<Variable> columns, List<String> wanted, List<String> figures) {
    this.grid = grid;
    this.columns = columns;
    this.figures = figures;
    taken = new ArrayList<>();
    List<String> names = columns.stream().map(Variable::name).toList();
    for (String name : wanted.isEmpty() ? names : wanted) {
      if (!names.contains(name)) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE
                + " --take: the runs put out no column \""
                + name
                + "\"; there are "
                + String.join(", ", names)
                + " (--columns adds others)");
      }
      taken.add(names.indexOf(name));
    }
  }

  /**
   * Makes sure that a report has the requested figures.
   *
   * @throws UsageException if it lacks one
   */
  void requireFigures(Map<String, Object> report) {
    for (String figure : figures) {
      if (!report.containsKey(figure)) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE
                + " --figures: the run report has no \""
                + figure
                + "\"; there are "
                + String.join(", ", report.keySet()));
      }
    }
  }

  /** Returns the rows as CSV, RFC 4180 with line feeds. */
  String csv(Collection<SweepRow> rows) {
    List<String> head = new ArrayList<>();
    grid.parameters().forEach(parameter -> head.add(parameter.name()));
    head.addAll(List.of("outcome", "code", "message"));
    taken.forEach(column -> head.add(columns.get(column).name()));
    head.addAll(figures);
    StringBuilder csv = new StringBuilder(line(head));
    rows.forEach(row -> csv.append(line(cells(row))));
    return csv.toString();
  }

  private List<String> cells(SweepRow row) {
    List<String> cells = new ArrayList<>(grid.point(row.point()).values());
    cells.addAll(List.of(row.outcome(), row.code(), row.message()));
    for (int column : taken) {
      cells.add(value(row, column).map(ShortestDecimal::format).orElse(""));
    }
    figures.forEach(figure -> cells.add(cell(row.report().getOrDefault(figure, ""))));
    return cells;
  }

  /** Numbers as in the results of a run, the same on every version of Java. */
  private static String cell(Object figure) {
    return figure instanceof Double number
        ? ShortestDecimal.format(number)
        : String.valueOf(figure);
  }

  private static Optional<Double> value(SweepRow row, int column) {
    return column < row.values().size() ? Optional.of(row.values().get(column)) : Optional.empty();
  }

  private static String line(List<String> cells) {
    return cells.stream().map(SweepTable::quoted).collect(Collectors.joining(",", "", "\n"));
  }

  private static String quoted(String cell) {
    return cell.matches("[^\",\r\n]*") ? cell : '"' + cell.replace("\"", "\"\"") + '"';
  }

  /** Returns the rows as JSON. */
  JsonArray json(Collection<SweepRow> rows) {
    JsonArray all = new JsonArray();
    for (SweepRow row : rows) {
      JsonObject json = new JsonObject();
      JsonObject parameters = new JsonObject();
      grid.point(row.point()).forEach(parameters::addProperty);
      json.add("parameters", parameters);
      json.addProperty("outcome", row.outcome());
      if (!row.code().isEmpty()) {
        json.addProperty("code", row.code());
        json.addProperty("message", row.message());
      }
      JsonObject values = new JsonObject();
      for (int column : taken) {
        values.add(
            columns.get(column).name(),
            value(row, column)
                .filter(Double::isFinite)
                .<com.google.gson.JsonElement>map(JsonPrimitive::new)
                .orElse(JsonNull.INSTANCE));
      }
      json.add("values", values);
      JsonObject report = new JsonObject();
      row.report()
          .forEach(
              (figure, value) -> {
                if (figures.contains(figure)) {
                  report.add(figure, SweepJournal.json(value));
                }
              });
      json.add("report", report);
      all.add(json);
    }
    return all;
  }
}
