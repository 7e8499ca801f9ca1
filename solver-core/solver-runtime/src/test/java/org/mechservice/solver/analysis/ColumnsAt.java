package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.analysis.column.FurtherColumns;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;

/** Further columns of a mechanism in a state, by name. */
final class ColumnsAt {
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "ode113", 1e-8, 1e-10);

  final ExplicitModel model;
  final FurtherColumns columns;
  private final List<ColumnGroup> groups;

  ColumnsAt(Mechanism mechanism, List<Output> outputs, ColumnGroup... groups) {
    boolean open = mechanism.closures().isEmpty();
    CompactModel data =
        new CompactModel(
            mechanism, open ? "DTR" : "DSR", open ? "none" : "projection", SETTINGS, outputs);
    Model made = DataDriven.model(data, UserForceSource.NONE);
    model = (ExplicitModel) ModelParts.of(made).equations();
    this.groups = List.of(groups);
    columns =
        new FurtherColumns(model, data, Set.of(groups), UserForceSource.NONE, Optional.empty());
  }

  ColumnsAt(Mechanism mechanism, ColumnGroup... groups) {
    this(mechanism, List.of(), groups);
  }

  double[] start() {
    double[] y = new double[model.description().stateCount()];
    model.initialState(y);
    return y;
  }

  Map<String, Double> at(double t, double[] y) {
    Map<String, Double> found = new LinkedHashMap<>();
    for (ColumnGroup group : groups) {
      List<Variable> variables = new ArrayList<>(columns.columns(group));
      double[] values = new double[variables.size()];
      columns.values(group, t, y, values, 0);
      for (int i = 0; i < values.length; i++) {
        found.put(variables.get(i).name(), values[i]);
      }
    }
    return found;
  }

  static double value(Map<String, Double> values, String name) {
    return Objects.requireNonNull(values.get(name), name);
  }

  static double[] vector(Map<String, Double> values, String name, String kind) {
    return new double[] {
      value(values, name + "." + kind + "x"),
      value(values, name + "." + kind + "y"),
      value(values, name + "." + kind + "z")
    };
  }
}
