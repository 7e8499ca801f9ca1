package org.mechservice.sim.service;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.Variable;

/**
 * The columns of a run.
 *
 * @param variables name and unit of each; the first is time
 * @param groups label of the column group each belongs to
 */
record RunColumns(List<Variable> variables, List<String> groups) {
  RunColumns {
    variables = List.copyOf(variables);
    groups = List.copyOf(groups);
  }

  /**
   * Finds out which column belongs to which group.
   *
   * @param columnsOf the columns of a run with certain groups
   * @param asked the groups of this run
   */
  static RunColumns of(
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

  int count() {
    return variables.size();
  }

  /** Returns the place of a column; -1 if there is none of that name. */
  int indexOf(String name) {
    for (int i = 0; i < variables.size(); i++) {
      if (variables.get(i).name().equals(name)) {
        return i;
      }
    }
    return -1;
  }
}
