package org.mechservice.solver.analysis.column;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.analysis.equation.DriveShares;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.dynamics.event.WrittenValues;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * Result columns that a model does not compute itself: residuals and multipliers of constraints,
 * joint reactions, values of forces, outputs by expression. One sweep over the mechanism computes
 * them from the accelerations, for all formulations.
 */
public final class FurtherColumns implements ResultColumns {
  private static final Set<ColumnGroup> NEED_BALANCE =
      EnumSet.of(
          ColumnGroup.CONSTRAINTS, ColumnGroup.REACTIONS, ColumnGroup.FORCES, ColumnGroup.DRIVES);

  private final ExplicitModel model;
  private final EquationsOfMotion equations;
  private final Map<ColumnGroup, ColumnValues> groups = new EnumMap<>(ColumnGroup.class);
  private final boolean needsBalance;
  private final DriveShares shares;
  private final Optional<MomentumBalance> momentum;
  private final Optional<WrittenOutputs> written;
  private final double[] yDot;

  /**
   * Prepares columns.
   *
   * @param model gives the accelerations, and the groups that are not asked for here
   * @param data its mechanism and outputs
   * @param asked groups among constraints, reactions, forces, outputs, momentum and drives
   * @param userForces creates the user forces
   * @param code evaluates the outputs, if it was written for them
   */
  public FurtherColumns(
      ExplicitModel model,
      CompactModel data,
      Set<ColumnGroup> asked,
      UserForceSource userForces,
      Optional<WrittenValues> code) {
    this.model = model;
    equations = new EquationsOfMotion(data.mechanism(), userForces);
    shares = new DriveShares(equations);
    written =
        code.filter(values -> asked.contains(ColumnGroup.OUTPUTS))
            .map(values -> new WrittenOutputs(values, data.outputs().size()));
    for (ColumnGroup group : asked) {
      groups.put(group, values(group, data));
    }
    needsBalance = asked.stream().anyMatch(NEED_BALANCE::contains);
    momentum =
        groups.get(ColumnGroup.MOMENTUM) instanceof MomentumBalance balance
            ? Optional.of(balance)
            : Optional.empty();
    yDot = new double[data.mechanism().stateCount()];
  }

  private ColumnValues values(ColumnGroup group, CompactModel data) {
    return switch (group) {
      case CONSTRAINTS -> new ConstraintColumns(equations);
      case REACTIONS -> new ReactionColumns(equations);
      case FORCES -> new ForceColumns(equations);
      case OUTPUTS -> new OutputColumns(equations.motion, data.outputs());
      case MOMENTUM -> new MomentumColumns(model, equations.motion);
      case DRIVES -> new DriveColumns(equations);
      default -> throw new IllegalArgumentException(group + " are columns of the model itself");
    };
  }

  @Override
  public List<Variable> columns(ColumnGroup group) {
    ColumnValues own = groups.get(group);
    if (own != null) {
      return own.columns();
    }
    return model instanceof ResultColumns columns ? columns.columns(group) : List.of();
  }

  @Override
  public void values(ColumnGroup group, double t, double[] y, double[] values, int at) {
    ColumnValues own = groups.get(group);
    if (group == ColumnGroup.OUTPUTS && written.isPresent()) {
      written.get().write(t, y, values, at);
    } else if (own == null) {
      // A model without such columns has none to write.
      if (model instanceof ResultColumns columns) {
        columns.values(group, t, y, values, at);
      }
    } else if (evaluate(t, y)) {
      own.write(t, values, at);
    } else {
      Arrays.fill(values, at, at + own.columns().size(), Double.NaN);
    }
  }

  @Override
  public void observe(double t, double[] y) {
    if (groups.values().stream().anyMatch(ColumnValues::observes) && evaluate(t, y)) {
      groups.values().forEach(values -> values.observe(t));
    }
  }

  @Override
  public List<Note> notes() {
    return groups.values().stream().flatMap(values -> values.notes().stream()).toList();
  }

  @Override
  public Optional<MomentumBalance> momentum() {
    return momentum;
  }

  /** Returns whether the state has accelerations and forces. */
  private boolean evaluate(double t, double[] y) {
    equations.place(t, y);
    if (!needsBalance) {
      return true;
    }
    if (model.derivative(t, y, yDot) != ExplicitModel.REGULAR || !equations.applyForces(t)) {
      return false;
    }
    equations.formResidual(yDot, equations.nq);
    equations.balance();
    shares.share();
    equations.forces.accepted();
    return true;
  }
}
