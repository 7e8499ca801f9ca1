package org.mechservice.sim.service.results;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.idl.NotFound;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;

/**
 * The columns of a run.
 *
 * @param variables name and unit of each; the first is time
 * @param groups label of the column group each belongs to
 */
public record RunColumns(List<Variable> variables, List<String> groups) {
  public RunColumns {
    variables = List.copyOf(variables);
    groups = List.copyOf(groups);
  }

  /**
   * Returns other columns; those that are not among these are values of forces, the only columns
   * that a model without its users' classes does not know.
   *
   * @param all name and unit of each
   */
  public RunColumns with(List<Variable> all) {
    Map<String, String> groupOf = new HashMap<>();
    for (int i = 0; i < variables.size(); i++) {
      groupOf.put(variables.get(i).name(), groups.get(i));
    }
    String forces = ColumnGroup.FORCES.label();
    return new RunColumns(
        all, all.stream().map(column -> groupOf.getOrDefault(column.name(), forces)).toList());
  }

  /**
   * Finds out which column belongs to which group.
   *
   * @param columnsOf the columns of a run with certain groups
   * @param asked column groups of this run
   */
  public static RunColumns of(
      Function<Set<ColumnGroup>, List<Variable>> columnsOf, Set<ColumnGroup> asked) {
    Map<String, String> groupOf = new HashMap<>();
    for (Variable joint : columnsOf.apply(EnumSet.of(ColumnGroup.JOINTS))) {
      groupOf.put(joint.name(), ColumnGroup.JOINTS.label());
    }
    for (ColumnGroup group : asked) {
      for (Variable column : columnsOf.apply(EnumSet.of(ColumnGroup.JOINTS, group))) {
        groupOf.putIfAbsent(column.name(), group.label());
      }
    }
    List<Variable> all = columnsOf.apply(asked);
    List<String> groups = new ArrayList<>();
    all.forEach(column -> groups.add(groupOf.getOrDefault(column.name(), "")));
    return new RunColumns(all, groups);
  }

  /** Returns how many characters their names and units have. */
  public long characters() {
    return variables.stream()
        .mapToLong(column -> column.name().length() + column.unit().length())
        .sum();
  }

  public int count() {
    return variables.size();
  }

  /** Returns the place of a column; -1 if there is none of that name. */
  public int indexOf(String name) {
    for (int i = 0; i < variables.size(); i++) {
      if (variables.get(i).name().equals(name)) {
        return i;
      }
    }
    return -1;
  }

  /** Chooses all columns. */
  Selection selectAll() {
    return new Selection(variables, IntStream.range(0, count()).toArray());
  }

  /**
   * Chooses columns.
   *
   * @param names names of columns or of column groups, in the order wanted; empty: all
   * @throws NotFound if the run has no such column or group
   */
  Selection select(String[] names) throws NotFound {
    if (names.length == 0) {
      return selectAll();
    }
    List<Integer> chosen = new ArrayList<>();
    for (String name : names) {
      int index = indexOf(name);
      List<Integer> found = index < 0 ? group(name) : List.of(index);
      if (found.isEmpty()) {
        throw ContractErrors.notFound(
            "the run has no column or column group \""
                + name
                + "\"; its columns are "
                + variables.stream().map(Variable::name).collect(Collectors.joining(", ")));
      }
      chosen.addAll(found);
    }
    int[] indices = chosen.stream().mapToInt(Integer::intValue).toArray();
    return new Selection(chosen.stream().map(variables::get).toList(), indices);
  }

  private List<Integer> group(String label) {
    return IntStream.range(0, count()).filter(i -> groups.get(i).equals(label)).boxed().toList();
  }

  /** The columns that a cursor returns, in its order. */
  static final class Selection {
    private final List<Variable> columns;
    private final int[] indices;

    private Selection(List<Variable> columns, int[] indices) {
      this.columns = columns;
      this.indices = indices;
    }

    /** Returns the chosen columns. */
    List<Variable> columns() {
      return columns;
    }

    /** Returns the number of chosen columns. */
    public int count() {
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
}
