package org.mechservice.cli.optimise;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.Front;

/** A front as text, as CSV and as JSON. */
final class FrontText {
  private final Front front;
  private final String derivatives;

  /**
   * @param derivatives how derivatives were found, for the last line; empty for a method without
   */
  FrontText(Front front, String derivatives) {
    this.front = front;
    this.derivatives = derivatives;
  }

  Front front() {
    return front;
  }

  /** Returns the names of the columns: variables, then aims. */
  List<String> columns() {
    List<String> names = new ArrayList<>();
    front.problem().variables().stream().map(DesignVariable::name).forEach(names::add);
    front.problem().aims().forEach(aim -> names.add(aim.text()));
    return names;
  }

  /** Returns a row of numbers for each point of the front. */
  List<double[]> rows() {
    List<double[]> rows = new ArrayList<>();
    for (Front.Point point : front.points()) {
      double[] row = new double[point.point().length + point.values().length];
      System.arraycopy(point.point(), 0, row, 0, point.point().length);
      System.arraycopy(point.values(), 0, row, point.point().length, point.values().length);
      rows.add(row);
    }
    return rows;
  }

  /** Returns the rows as people read them. */
  List<List<String>> shown() {
    return rows().stream()
        .map(row -> Arrays.stream(row).mapToObj(OptimiseCommand::shown).toList())
        .toList();
  }

  /** Returns a table in columns, and a line on how it was found. */
  String lines() {
    List<List<String>> table = new ArrayList<>(List.of(columns()));
    table.addAll(shown());
    List<Integer> widths = new ArrayList<>();
    for (int j = 0; j < columns().size(); j++) {
      int column = j;
      widths.add(Collections.max(table.stream().map(row -> row.get(column).length()).toList()));
    }
    StringBuilder text = new StringBuilder();
    for (List<String> row : table) {
      for (int j = 0; j < row.size(); j++) {
        text.append(j == 0 ? "" : "  ")
            .append(" ".repeat(widths.get(j) - row.get(j).length()))
            .append(row.get(j));
      }
      text.append('\n');
    }
    return text.append(summary()).toString();
  }

  /** Returns how the front was found. */
  String summary() {
    return "front of "
        + OptimiseCommand.counted(front.points().size(), "point")
        + " by method "
        + front.method().label()
        + ", "
        + OptimiseCommand.counted(front.runs(), "run")
        + ", "
        + front.failures()
        + " failed"
        + derivatives;
  }

  String csv() {
    StringBuilder csv = new StringBuilder();
    csv.append(columns().stream().map(OptimiseCommand::quoted).collect(Collectors.joining(",")));
    csv.append('\n');
    for (double[] row : rows()) {
      csv.append(
          Arrays.stream(row).mapToObj(OptimiseCommand::number).collect(Collectors.joining(",")));
      csv.append('\n');
    }
    return csv.toString();
  }

  JsonObject json() {
    JsonArray points = new JsonArray();
    List<String> names = columns();
    for (double[] row : rows()) {
      JsonObject point = new JsonObject();
      for (int j = 0; j < row.length; j++) {
        point.addProperty(names.get(j), row[j]);
      }
      points.add(point);
    }
    JsonObject all = new JsonObject();
    all.add("front", points);
    all.addProperty("method", front.method().label());
    all.addProperty("runs", front.runs());
    all.addProperty("failed", front.failures());
    return all;
  }
}
