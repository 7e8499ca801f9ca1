package org.mechservice.solver.simulation;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;

/** The columns of a row and the offset of each group. */
final class RowLayout {
  private static final String[] POSE_COLUMNS = {
    ".x", ".y", ".z", ".e0", ".e1", ".e2", ".e3", ".vx", ".vy", ".vz", ".wx", ".wy", ".wz"
  };
  private static final String[] POSE_UNITS = {
    "m", "m", "m", "1", "1", "1", "1", "m/s", "m/s", "m/s", "rad/s", "rad/s", "rad/s"
  };

  /** Groups whose columns the model names and computes. */
  static final Set<ColumnGroup> BY_THE_MODEL =
      EnumSet.of(
          ColumnGroup.CONSTRAINTS,
          ColumnGroup.REACTIONS,
          ColumnGroup.FORCES,
          ColumnGroup.OUTPUTS,
          ColumnGroup.MOMENTUM,
          ColumnGroup.DRIVES);

  /** Offset of a group that is not part of the rows. */
  static final int ABSENT = -1;

  private final List<Variable> columns = new ArrayList<>();
  private int accelerations = ABSENT;
  private int bodies = ABSENT;
  private int energy = ABSENT;
  private final Map<ColumnGroup, Integer> offsets = new EnumMap<>(ColumnGroup.class);

  /**
   * @param further columns that the model names itself
   * @throws IllegalArgumentException if the model was built without a group that is asked for
   */
  RowLayout(ExplicitModel model, ResultColumns further, Set<ColumnGroup> groups) {
    columns.add(new Variable("t", "s"));
    columns.addAll(model.description().states());
    if (groups.contains(ColumnGroup.ACCELERATIONS)) {
      accelerations = columns.size();
      columns.addAll(model.description().accelerations());
    }
    if (groups.contains(ColumnGroup.BODIES)) {
      bodies = columns.size();
      addPoses(model);
    }
    if (groups.contains(ColumnGroup.ENERGY)) {
      energy = columns.size();
      requireEnergies(model);
      columns.add(new Variable("energy.kinetic", "J"));
      columns.add(new Variable("energy.potential", "J"));
      columns.add(new Variable("energy.work", "J"));
    }
    for (ColumnGroup group : BY_THE_MODEL) {
      if (groups.contains(group)) {
        offsets.put(group, columns.size());
        columns.addAll(further.columns(group));
      }
    }
  }

  private void addPoses(ExplicitModel model) {
    if (!(model instanceof BodyPoses posed)) {
      throw builtWithout(model, ColumnGroup.BODIES);
    }
    for (String body : posed.bodies()) {
      for (int i = 0; i < BodyPoses.NUMBERS_PER_BODY; i++) {
        columns.add(new Variable(body + POSE_COLUMNS[i], POSE_UNITS[i]));
      }
    }
  }

  private static void requireEnergies(ExplicitModel model) {
    if (!(model instanceof Energies)) {
      throw builtWithout(model, ColumnGroup.ENERGY);
    }
  }

  /** Returns the refusal of a group that a model was built without. */
  static IllegalArgumentException builtWithout(Model model, ColumnGroup group) {
    return new IllegalArgumentException(
        MessageCode.COLUMN_GROUP_MISSING
            + " model \""
            + model.description().name()
            + "\" was built without the column group \""
            + group.label()
            + "\"; build it with: mech build MODEL.xml -o FILE.jar --columns "
            + group.label());
  }

  List<Variable> columns() {
    return List.copyOf(columns);
  }

  int accelerations() {
    return accelerations;
  }

  int bodies() {
    return bodies;
  }

  int energy() {
    return energy;
  }

  /** Returns where a group of {@link #BY_THE_MODEL} begins. */
  int offset(ColumnGroup group) {
    return offsets.getOrDefault(group, ABSENT);
  }
}
