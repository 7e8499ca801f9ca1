package org.mechservice.sim.service;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.mechservice.idl.NotFound;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.ModelDescription;
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
   * @param model tells which columns form which group
   * @throws NotFound if the run has no such column or group
   */
  static ColumnSelection of(String[] names, List<Variable> all, ModelDescription model)
      throws NotFound {
    if (names.length == 0) {
      return new ColumnSelection(all, IntStream.range(0, all.size()).toArray());
    }
    Map<String, Integer> indexOf = new LinkedHashMap<>();
    for (int i = 0; i < all.size(); i++) {
      indexOf.put(all.get(i).name(), i);
    }
    List<Integer> chosen = new ArrayList<>();
    for (String name : names) {
      Integer index = indexOf.get(name);
      List<Integer> found = index == null ? group(name, all, model) : List.of(index);
      if (found.isEmpty()) {
        throw Refusal.notFound(
            "the run has no column or column group \""
                + name
                + "\"; its columns are "
                + String.join(", ", indexOf.keySet()));
      }
      chosen.addAll(found);
    }
    int[] indices = chosen.stream().mapToInt(Integer::intValue).toArray();
    return new ColumnSelection(chosen.stream().map(all::get).toList(), indices);
  }

  private static List<Integer> group(String label, List<Variable> all, ModelDescription model) {
    for (ColumnGroup group : ColumnGroup.values()) {
      if (group.label().equals(label)) {
        return IntStream.range(0, all.size())
            .filter(i -> groupOf(i, all.get(i), model) == group)
            .boxed()
            .toList();
      }
    }
    return List.of();
  }

  private static ColumnGroup groupOf(int index, Variable column, ModelDescription model) {
    if (index <= model.stateCount()) {
      return ColumnGroup.JOINTS;
    } else if (model.accelerations().contains(column)) {
      return ColumnGroup.ACCELERATIONS;
    }
    return column.name().startsWith("energy.") ? ColumnGroup.ENERGY : ColumnGroup.BODIES;
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
