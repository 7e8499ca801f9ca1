package org.mechservice.sim.scene.forecast;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.LoopPaths;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Finds bodies that nothing moves: they start at rest, the forces on them balance there, and no
 * drive, input or formula of time, in a force or in a constraint, acts on them, so that they stay
 * where they are during the run.
 *
 * <p>The bodies are taken in groups: those beyond one joint of the root, together with those that
 * constraints and forces between bodies connect to them.
 */
final class RestCheck {
  /** Largest number of bodies that a message names. */
  private static final int MOST_NAMES = 8;

  /** Acceleration that is rounding, m/s² or rad/s². */
  private static final double ROUNDING = 1e-12;

  /** Largest number of velocities; the equations of larger mechanisms take too long. */
  private static final int MOST_VELOCITIES = 2000;

  private final Mechanism mechanism;

  /** The group of each joint of the tree, a number of one of its joints. */
  private final int[] group;

  /** Whether a group moves, by its number. */
  private final boolean[] moving;

  private RestCheck(Mechanism mechanism) {
    this.mechanism = mechanism;
    group = new int[mechanism.joints().size()];
    moving = new boolean[group.length];
  }

  /**
   * Returns the finding about all such bodies; empty if there are none, or if states, samples,
   * events or classes of users may move anything.
   */
  static Optional<Finding> of(MechmlModel model, RunSettings settings) {
    Mechanism mechanism = model.mechanism();
    boolean driven =
        !mechanism.furtherStates().isEmpty()
            || !mechanism.samplings().isEmpty()
            || !model.settings().events().isEmpty()
            || mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance);
    if (driven
        || !(model.settings().task() instanceof SimulationTask.Dynamic)
        || mechanism.velocityCount() == 0
        || mechanism.velocityCount() > MOST_VELOCITIES) {
      return Optional.empty();
    }
    try {
      return new RestCheck(mechanism).found(model, settings);
    } catch (IllegalArgumentException e) {
      // A mechanism that cannot be built is refused, with the reason, when the run starts.
      return Optional.empty();
    }
  }

  private Optional<Finding> found(MechmlModel model, RunSettings settings) {
    connect();
    for (int j = 0; j < group.length; j++) {
      moving[group[j]] |= mechanism.isDriven(j);
    }
    for (ForceElement force : mechanism.forces()) {
      if (force.formulas().stream().anyMatch(f -> isTimed(f.expression()))) {
        moves(force);
      }
    }
    for (LoopClosure closure : mechanism.closures()) {
      if (formulas(closure).stream().anyMatch(RestCheck::isTimed)) {
        moves(LoopPaths.indices(closure));
      }
    }
    return accelerate(model, settings) ? finding() : Optional.empty();
  }

  private static boolean isTimed(Expression formula) {
    return FormulaForecast.parts(formula).stream().anyMatch(Expression.Time.class::isInstance);
  }

  /** Returns whether a formula may read what other bodies do. */
  private static boolean isOfState(Expression formula) {
    return FormulaForecast.parts(formula).stream()
        .anyMatch(
            part ->
                part instanceof Expression.CoordinatePosition
                    || part instanceof Expression.CoordinateVelocity
                    || part instanceof Expression.PointPosition
                    || part instanceof Expression.PointVelocity
                    || part instanceof Expression.RelativeMotion);
  }

  private static List<Expression> formulas(LoopClosure closure) {
    if (closure instanceof JointClosure joint) {
      return joint.motion();
    }
    return closure instanceof CoordinateClosure coupling ? List.of(coupling.relation()) : List.of();
  }

  /** Marks what a force acts on; a coupling of coordinates may act on everything that it reads. */
  private void moves(ForceElement force) {
    if (force.jointCoordinate().isPresent()) {
      moving[groupOf(force.jointCoordinate().get())] = true;
    } else {
      moves(force.bodies());
    }
  }

  /** Marks the groups of bodies; all of them if no bodies are named. */
  private void moves(List<Integer> bodies) {
    List<Integer> moved = bodies.isEmpty() ? all() : bodies;
    moved.stream().filter(b -> b != Mechanism.ROOT).forEach(b -> moving[groupOf(b)] = true);
  }

  /** Joins what hangs at the root to groups. */
  private void connect() {
    for (int joint : mechanism.outward()) {
      int parent = mechanism.joints().get(joint).attachment().parent();
      group[joint] = parent == Mechanism.ROOT ? joint : group[mechanism.jointOf(parent)];
    }
    for (LoopClosure closure : mechanism.closures()) {
      List<Integer> bodies = LoopPaths.indices(closure);
      join(bodies.isEmpty() ? all() : bodies);
    }
    for (ForceElement force : mechanism.forces()) {
      boolean wide = force.formulas().stream().anyMatch(f -> isOfState(f.expression()));
      join(wide ? all() : force.bodies());
    }
  }

  private List<Integer> all() {
    List<Integer> bodies = new ArrayList<>();
    for (int b = 0; b < mechanism.bodies().size(); b++) {
      bodies.add(b);
    }
    return bodies;
  }

  private void join(List<Integer> bodies) {
    int first = -1;
    for (int body : bodies) {
      if (body != Mechanism.ROOT) {
        int number = groupOf(body);
        first = first < 0 ? number : first;
        for (int j = 0; j < group.length; j++) {
          group[j] = group[j] == number ? first : group[j];
        }
      }
    }
  }

  private int groupOf(int body) {
    return group[mechanism.jointOf(body)];
  }

  private int groupOf(Coordinate coordinate) {
    Joint joint = mechanism.jointOf(coordinate);
    return groupOf(joint.attachment().child());
  }

  /** Marks the groups that have a velocity or an acceleration; returns whether all have values. */
  private boolean accelerate(MechmlModel model, RunSettings settings) {
    ExplicitModel equations = equations(model, settings);
    double[] y = new double[equations.description().stateCount()];
    double[] yDot = new double[y.length];
    equations.initialState(y);
    if (equations.derivative(settings.tStart(), y, yDot) != ExplicitModel.REGULAR) {
      return false;
    }
    for (int j = 0; j < group.length; j++) {
      if (mechanism.isDriven(j)) {
        continue;
      }
      int from = mechanism.positionCount() + mechanism.velocityOffset(j);
      for (int i = from; i < from + mechanism.joints().get(j).type().velocityCount(); i++) {
        moving[group[j]] |= y[i] != 0 || !(Math.abs(yDot[i]) <= ROUNDING);
      }
    }
    return true;
  }

  private ExplicitModel equations(MechmlModel model, RunSettings settings) {
    if (mechanism.closures().isEmpty()) {
      return new DataDrivenModel(mechanism, settings);
    }
    ClosedStart start = model.closedStart(settings.tStart());
    if (!start.isAssembled()) {
      throw new IllegalArgumentException("the loops are not closed");
    }
    return new ProjectionModel(
        new ClosedMechanism(mechanism, Formulation.DSR.label(), settings, start),
        UserForceSource.NONE);
  }

  private Optional<Finding> finding() {
    List<Joint> still = new ArrayList<>();
    for (int j = 0; j < group.length; j++) {
      if (!moving[group[j]] && hasFreedom(group[j])) {
        still.add(mechanism.joints().get(j));
      }
    }
    if (still.isEmpty()) {
      return Optional.empty();
    }
    String names =
        still.stream()
            .limit(MOST_NAMES)
            .map(j -> "\"" + mechanism.bodies().get(j.attachment().child()).name() + "\"")
            .collect(Collectors.joining(", "));
    if (still.size() > MOST_NAMES) {
      names += " and " + (still.size() - MOST_NAMES) + " more";
    }
    return Optional.of(
        new Finding(
            MessageCode.BODY_STAYS_AT_REST,
            "nothing moves "
                + (still.size() == 1 ? "body " : "bodies ")
                + names
                + ": at the start there is neither a velocity nor a force that is not balanced, and"
                + " no drive or formula of time acts later; give a joint there a start position, a"
                + " velocity or a force, or leave out what does not move",
            mechanism.bodies().get(still.get(0).attachment().child()).origin()));
  }

  /** Returns whether a joint of a group moves at all: bodies that are welded to the root do not. */
  private boolean hasFreedom(int number) {
    for (int j = 0; j < group.length; j++) {
      if (group[j] == number && mechanism.joints().get(j).type().velocityCount() > 0) {
        return true;
      }
    }
    return false;
  }
}
