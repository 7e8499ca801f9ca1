package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.formula.FormulaCheck;
import org.mechservice.solver.force.formula.FurtherRates;
import org.mechservice.solver.force.formula.SampleStates;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/**
 * Common part of the data-driven models of an open tree: state, forces, energies, poses, outputs
 * and defects. Workspace of one run and thread.
 */
public abstract class OpenTreeModel
    implements ExplicitModel, Energies, PowerInput, BodyPoses, ResultColumns, Defects, RunNotes {
  final TreeGeometry tree;
  final TreeMotion motion;
  final StateCoordinates coordinates;
  final TreeLoads loads;
  final FurtherRates further;
  private final ModelDescription description;
  private final StateJoints joints;
  private final WorldMotion world;
  private final DrivenColumns driven;
  private final WeakPivots weakPivots;
  private final double[] accelerations;
  private Optional<Defect> defect = Optional.empty();

  /**
   * @param mechanism an open tree
   * @param formulation name of the formulation
   * @param defaults default settings of the model
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the mechanism closes loops, or a force or a motion cannot
   *     be used
   */
  OpenTreeModel(
      Mechanism mechanism, String formulation, RunSettings defaults, UserForceSource userForces) {
    requireOpen(mechanism, formulation);
    joints = new StateJoints(mechanism);
    description =
        new ModelDescription(
            mechanism.name(),
            formulation,
            joints.variables(),
            mechanism.stateVariables(),
            defaults);
    tree = new TreeGeometry(mechanism);
    coordinates = new StateCoordinates(mechanism);
    motion = new TreeMotion(tree);
    loads = new TreeLoads(motion, userForces);
    further = new FurtherRates(motion);
    world = new WorldMotion(motion);
    driven = new DrivenColumns(tree);
    weakPivots = new WeakPivots(joints);
    accelerations = new double[tree.stateVelocityCount];
  }

  private static void requireOpen(Mechanism mechanism, String formulation) {
    List<String> closures = mechanism.closures().stream().map(LoopClosure::name).toList();
    if (!closures.isEmpty()) {
      String advice =
          formulation.equals(Formulation.DTR.label())
              ? "use DSR, RR or RR-JF"
              : "choose how they are closed: projection or penalty";
      throw new IllegalArgumentException(
          MessageCode.FORMULATION_NOT_AVAILABLE
              + " "
              + formulation
              + " without closure is for open chains; the scene closes loops at "
              + String.join(", ", closures)
              + "; "
              + advice);
    }
  }

  /**
   * Writes the joint accelerations for the last motion and loads.
   *
   * @param a in state order from {@code aAt}; overwritten
   * @return {@link ExplicitModel#REGULAR}, or the index of a velocity without inertia
   */
  abstract int accelerate(double[] a, int aAt);

  /** Returns the check of the pivots of the last evaluation. */
  abstract PivotCheck check();

  /**
   * Writes the driving forces of the last {@link #accelerate}, in the order of the extended
   * velocities.
   */
  abstract void drivingForces(double[] force);

  @Override
  public final ModelDescription description() {
    return description;
  }

  @Override
  public final boolean hasUserClasses() {
    return tree.mechanism().hasUserClasses();
  }

  @Override
  public final void initialState(double[] y) {
    tree.mechanism().initialState(y);
  }

  @Override
  public final int derivative(double t, double[] y, double[] yDot) {
    int nq = tree.statePositionCount;
    coordinates.rates(y, 0, y, nq, yDot, 0);
    int loaded = load(t, y);
    if (loaded != REGULAR) {
      return loaded;
    }
    further.evaluate(t, yDot, nq + tree.stateVelocityCount);
    return solve(t, yDot, nq);
  }

  /** Sets the motion to a state without forces; sweeps the links if the accelerations need it. */
  void place(double t, double[] y) {
    motion.sweepRelative(t, y);
  }

  /** Sets the motion to a state and evaluates the forces; returns REGULAR or DEFECT. */
  final int load(double t, double[] y) {
    if (loads.isEmpty() && further.count() == 0) {
      place(t, y);
      return REGULAR;
    }
    motion.sweep(t, y);
    if (loads.evaluate(t) == ForceSet.REGULAR) {
      return REGULAR;
    }
    defect = Optional.of(loads.forces().defect());
    return DEFECT;
  }

  private int solve(double t, double[] a, int aAt) {
    int singular = accelerate(a, aAt);
    if (singular == REGULAR) {
      weakPivots.observe(t, check());
      return REGULAR;
    }
    motion.sweepRelative();
    SingularInertia found = SingularInertia.of(motion, t, singular);
    return joints.isSingle(found.motion()) && !found.isOfDifferentSizes()
        ? joints.jointOf(singular)
        : fail(joints.singular(found));
  }

  /** Stores why an evaluation failed; returns DEFECT. */
  final int fail(Defect why) {
    defect = Optional.of(why);
    return DEFECT;
  }

  @Override
  public final Defect lastDefect() {
    return defect.orElseThrow(() -> new IllegalStateException("no evaluation has failed"));
  }

  @Override
  public final Optional<Defect> withoutValue(
      double t, double[] y, double[] yDot, List<Failure.Step> tried) {
    return FormulaCheck.of(motion)
        .flatMap(
            check ->
                SampleStates.search(
                    check.lines(),
                    (time, state) -> {
                      motion.sweep(time, state);
                      return check.values(time);
                    },
                    t,
                    y,
                    yDot,
                    tried));
  }

  @Override
  public List<Note> notes() {
    return weakPivots.notes();
  }

  @Override
  public final void energy(double t, double[] y, double[] energy) {
    motion.sweep(t, y);
    loads.evaluate(t);
    energy[0] = world.kineticEnergy();
    energy[1] = world.potentialEnergy() + loads.forces().potentialEnergy();
  }

  @Override
  public final void power(double t, double[] y, double[] power) {
    double driving = drivingPower(t, y);
    power[0] = loads.forces().power() + driving;
    power[1] = loads.forces().turnover() + Math.abs(driving);
  }

  /** Evaluates the loads, and returns the power of the prescribed motions, W. */
  private double drivingPower(double t, double[] y) {
    motion.sweep(t, y);
    loads.evaluate(t);
    if (driven.isEmpty()) {
      return 0;
    }
    accelerate(accelerations, 0);
    drivingForces(driven.forces());
    return driven.power(motion);
  }

  @Override
  public final List<String> bodies() {
    return tree.mechanism().bodies().stream().map(Body::name).toList();
  }

  @Override
  public final void poses(double t, double[] y, double[] poses) {
    motion.sweep(t, y);
    world.poses(poses);
  }

  /** {@inheritDoc} Driving forces are among the applied forces. */
  @Override
  public final List<Variable> columns(ColumnGroup group) {
    List<Variable> columns = new ArrayList<>();
    if (group == ColumnGroup.FORCES) {
      columns.addAll(loads.forces().columns());
      columns.addAll(driven.columns());
    }
    return columns;
  }

  @Override
  public final void values(ColumnGroup group, double t, double[] y, double[] values, int at) {
    if (group != ColumnGroup.FORCES) {
      return;
    }
    motion.sweep(t, y);
    loads.evaluate(t);
    loads.forces().values(values, at);
    if (!driven.isEmpty()) {
      accelerate(accelerations, 0);
      drivingForces(driven.forces());
      double[] force = driven.forces();
      System.arraycopy(force, 0, values, at + loads.forces().columns().size(), force.length);
    }
  }
}
