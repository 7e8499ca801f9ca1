package org.mechservice.view.plot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A request for a diagram.
 *
 * @param files result files; their curves are drawn over each other
 * @param columns names of columns, or patterns in which {@code *} stands for any text and {@code ?}
 *     for one character; without any the positions of the joints, or what there is
 * @param x name of the column on the horizontal axis; empty for the time
 */
public record PlotRequest(List<Path> files, List<String> columns, Optional<String> x) {
  /** Curves of a diagram for which no columns are named. */
  private static final int SHOWN_BY_ITSELF = 16;

  /** Columns of any diagram: more than this cannot be told apart. */
  private static final int MOST_COLUMNS = 64;

  /** Rows kept of a file are at most a few for each of these. */
  private static final int BUCKETS = 3000;

  private static final String TIME = "t";
  private static final String POSITION = ".q";
  private static final int SUGGESTIONS = 3;

  public PlotRequest {
    files = List.copyOf(files);
    columns = List.copyOf(columns);
  }

  /** The columns shown of all, and notes about the rest. */
  private record Choice(List<String> columns, List<String> notes) {}

  /**
   * Reads the files.
   *
   * @throws IOException if one cannot be read
   * @throws IllegalArgumentException with a message code if one is no result file, or a column does
   *     not exist
   */
  public Plot read() throws IOException {
    List<StoredResult> results = new ArrayList<>();
    for (Path file : files) {
      results.add(StoredResult.open(file));
    }
    String horizontal = horizontal(results);
    Set<String> all = new LinkedHashSet<>();
    results.forEach(result -> all.addAll(result.names()));
    List<String> there = all.stream().filter(name -> !name.equals(horizontal)).toList();
    Choice choice = columns.isEmpty() ? byItself(there, results) : named(all, horizontal);
    List<String> names = runNames();
    List<String> notes = new ArrayList<>(choice.notes());
    List<List<double[]>> tables = new ArrayList<>();
    List<List<String>> shownOf = new ArrayList<>();
    for (StoredResult result : results) {
      List<String> wanted = new ArrayList<>(List.of(horizontal));
      choice.columns().stream().filter(result.names()::contains).forEach(wanted::add);
      List<String> missing =
          choice.columns().stream().filter(name -> !result.names().contains(name)).toList();
      if (!missing.isEmpty()) {
        notes.add(names.get(tables.size()) + " has no column " + String.join(", ", missing));
      }
      ThinnedRows rows = new ThinnedRows(BUCKETS);
      result.read(wanted, rows);
      if (rows.count() == 0) {
        notes.add(names.get(tables.size()) + " has no rows");
      }
      tables.add(rows.rows());
      shownOf.add(wanted);
    }
    return new Plot(
        title(names, horizontal, results),
        horizontal,
        unit(results, horizontal),
        names,
        panels(choice.columns(), results, tables, shownOf),
        notes);
  }

  private String horizontal(List<StoredResult> results) {
    for (StoredResult result : results) {
      if (x.isPresent() && !result.names().contains(x.get())) {
        throw unknown(x.get(), result.names(), String.valueOf(result.file().getFileName()));
      }
    }
    if (x.isPresent()) {
      return x.get();
    }
    String first = results.get(0).names().contains(TIME) ? TIME : results.get(0).names().get(0);
    for (StoredResult result : results) {
      if (!result.names().contains(first)) {
        throw unknown(first, result.names(), String.valueOf(result.file().getFileName()));
      }
    }
    return first;
  }

  /** Positions of joints in radians and metres, else all columns; as many as can be told apart. */
  private static Choice byItself(List<String> there, List<StoredResult> results) {
    List<String> positions =
        there.stream()
            .filter(name -> name.endsWith(POSITION) || name.contains(POSITION + "["))
            .filter(name -> !unit(results, name).equals("1"))
            .toList();
    List<String> liked = positions.isEmpty() ? there : positions;
    List<String> shown = liked.subList(0, Math.min(liked.size(), SHOWN_BY_ITSELF));
    int left = there.size() - shown.size();
    return new Choice(
        shown,
        left == 0
            ? List.of()
            : List.of(
                "Shown are "
                    + shown.size()
                    + " of "
                    + there.size()
                    + " columns; name others, such as "
                    + there.stream().filter(name -> !shown.contains(name)).findFirst().orElse("")
                    + " or '*.v'"));
  }

  private Choice named(Set<String> all, String horizontal) {
    Set<String> chosen = new LinkedHashSet<>();
    for (String column : columns) {
      List<String> matching = all.contains(column) ? List.of(column) : matching(all, column);
      if (matching.isEmpty()) {
        String where =
            files.size() == 1
                ? String.valueOf(files.get(0).getFileName())
                : "any of the " + files.size() + " files";
        throw unknown(column, List.copyOf(all), where);
      }
      matching.stream()
          .filter(name -> !name.equals(horizontal) || name.equals(column))
          .forEach(chosen::add);
    }
    List<String> shown = chosen.stream().limit(MOST_COLUMNS).toList();
    int left = chosen.size() - shown.size();
    return new Choice(
        shown,
        left == 0
            ? List.of()
            : List.of("Shown are the first " + shown.size() + " of " + chosen.size() + " columns"));
  }

  private static List<String> matching(Set<String> all, String pattern) {
    if (pattern.indexOf('*') < 0 && pattern.indexOf('?') < 0) {
      return List.of();
    }
    StringBuilder regex = new StringBuilder();
    for (int i = 0; i < pattern.length(); i++) {
      char c = pattern.charAt(i);
      regex.append(c == '*' ? ".*" : c == '?' ? "." : Pattern.quote(String.valueOf(c)));
    }
    Pattern matcher = Pattern.compile(regex.toString());
    return all.stream().filter(name -> matcher.matcher(name).matches()).toList();
  }

  private static IllegalArgumentException unknown(String column, List<String> names, String where) {
    List<String> nearest =
        names.stream()
            .sorted(Comparator.comparingInt(name -> changes(column, name)))
            .limit(SUGGESTIONS)
            .map(name -> "\"" + name + "\"")
            .toList();
    return new IllegalArgumentException(
        MessageCode.OPTION_UNUSABLE
            + " there is no column \""
            + column
            + "\" in "
            + where
            + "; the nearest names are "
            + String.join(", ", nearest));
  }

  /** Returns how many letters change between two names (Levenshtein), regardless of case. */
  private static int changes(String one, String other) {
    int[] row = new int[other.length() + 1];
    for (int j = 0; j < row.length; j++) {
      row[j] = j;
    }
    for (int i = 1; i <= one.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j < row.length; j++) {
        boolean same =
            Character.toLowerCase(one.charAt(i - 1)) == Character.toLowerCase(other.charAt(j - 1));
        int replaced = diagonal + (same ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
      }
    }
    return row[other.length()];
  }

  /** Returns names of the files: as much of their paths as tells them apart. */
  private List<String> runNames() {
    for (int parts = 1; parts <= 4; parts++) {
      List<String> names = new ArrayList<>();
      for (Path file : files) {
        int count = file.getNameCount();
        names.add(file.subpath(Math.max(0, count - parts), count).toString());
      }
      if (Set.copyOf(names).size() == names.size()) {
        return names;
      }
    }
    return files.stream().map(Path::toString).toList();
  }

  private static String title(List<String> names, String horizontal, List<StoredResult> results) {
    boolean phase = results.get(0).names().contains(TIME) && !horizontal.equals(TIME);
    return String.join(", ", names) + (phase ? " over " + horizontal : "");
  }

  private static String unit(List<StoredResult> results, String column) {
    return results.stream()
        .map(result -> result.unit(column))
        .filter(unit -> !unit.isEmpty())
        .findFirst()
        .orElse("");
  }

  /** One panel for each unit; columns without a unit go together by the end of their names. */
  private static List<Plot.Panel> panels(
      List<String> shown,
      List<StoredResult> results,
      List<List<double[]>> tables,
      List<List<String>> shownOf) {
    Map<String, List<String>> byUnit = new LinkedHashMap<>();
    for (String column : shown) {
      String unit = unit(results, column);
      String key = unit.isEmpty() ? "?" + quantity(column) : unit;
      byUnit.computeIfAbsent(key, k -> new ArrayList<>()).add(column);
    }
    List<Plot.Panel> panels = new ArrayList<>();
    for (List<String> columns : byUnit.values()) {
      List<Plot.Curve> curves = new ArrayList<>();
      for (int c = 0; c < columns.size(); c++) {
        for (int run = 0; run < results.size(); run++) {
          int at = shownOf.get(run).indexOf(columns.get(c));
          if (at >= 0) {
            curves.add(new Plot.Curve(columns.get(c), run, c, tables.get(run), at));
          }
        }
      }
      panels.add(new Plot.Panel(common(columns), unit(results, columns.get(0)), curves));
    }
    return panels;
  }

  /** Returns the part of a name after its last point, without an index. */
  private static String quantity(String column) {
    String name = column.replaceFirst("\\[\\d+\\]$", "");
    return name.substring(name.lastIndexOf('.') + 1);
  }

  /** Returns the quantity that all columns have, or nothing. */
  private static String common(List<String> columns) {
    List<String> quantities = columns.stream().map(PlotRequest::quantity).distinct().toList();
    return quantities.size() == 1 ? quantities.get(0) : "";
  }
}
