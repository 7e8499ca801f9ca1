package org.mechservice.sim.service;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.idl.NotFound;
import org.mechservice.solver.api.Variable;

/** Which columns of a run a cursor hands out, in which order. */
final class ColumnSelection {
  private final List<Variable> columns;
  private final int[] indices;

  private ColumnSelection(List<Variable> columns, int[] indices) {
    this.columns = columns;
    this.indices = indices;
  }

  /**
   * Chooses columns.
   *
   * @param names names of columns or of column groups, in the order wanted; empty: all
   * @param all the run's columns
   * @throws NotFound if the run has no such column or group
   */
  static ColumnSelection of(String[] names, RunColumns all) throws NotFound {
    if (names.length == 0) {
      return ofAll(all);
    }
    List<Integer> chosen = new ArrayList<>();
    for (String name : names) {
      int index = all.indexOf(name);
      List<Integer> found = index < 0 ? group(name, all) : List.of(index);
      if (found.isEmpty()) {
        throw Refusal.notFound(
            "the run has no column or column group \""
                + name
                + "\"; its columns are "
                + all.variables().stream().map(Variable::name).collect(Collectors.joining(", ")));
      }
      chosen.addAll(found);
    }
    int[] indices = chosen.stream().mapToInt(Integer::intValue).toArray();
    return new ColumnSelection(chosen.stream().map(all.variables()::get).toList(), indices);
  }

  /** Chooses all columns. */
  static ColumnSelection ofAll(RunColumns all) {
    return new ColumnSelection(all.variables(), IntStream.range(0, all.count()).toArray());
  }

  private static List<Integer> group(String label, RunColumns all) {
    return IntStream.range(0, all.count())
        .filter(i -> all.groups().get(i).equals(label))
        .boxed()
        .toList();
  }

  /** Returns the columns handed out. */
  List<Variable> columns() {
    return columns;
  }

  /** Returns how many columns are handed out. */
  int count() {
    return indices.length;
  }

  /**
   * Picks the chosen columns out of rows.
   *
   * @param rows whole rows, one after the other; not modified
   * @param width numbers per whole row
   */
  double[] pick(double[] rows, int width) {
    if (indices.length == width && isIdentity()) {
      return rows;
    }
    int count = rows.length / width;
    double[] picked = new double[count * indices.length];
    for (int row = 0; row < count; row++) {
      for (int i = 0; i < indices.length; i++) {
        picked[row * indices.length + i] = rows[row * width + indices[i]];
      }
    }
    return picked;
  }

  private boolean isIdentity() {
    for (int i = 0; i < indices.length; i++) {
      if (indices[i] != i) {
        return false;
      }
    }
    return true;
  }
}
