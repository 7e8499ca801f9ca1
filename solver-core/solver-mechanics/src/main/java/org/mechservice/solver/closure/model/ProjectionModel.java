package org.mechservice.solver.closure.model;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * DSR with closed loops by the second velocity transformation: the state is [q; v] of the open
 * tree, with as many independent coordinates as degrees of freedom
 * (docs/theory/loops.md#projection).
 */
public class ProjectionModel extends LoopModel implements DependentStates, ModelState {
  public final Completion completion;
  private Optional<ProjectedMotion> projected = Optional.empty();
  private Optional<RecursiveAccelerations> recursive = Optional.empty();

  /** Reason why the motion cannot continue from the last accepted state. */
  private Optional<Defect> broken = Optional.empty();

  /**
   * Makes a model of a mechanism whose loops are closed. Evaluations fail with N-023 if the start
   * is so singular that no independent coordinates can be chosen.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  public ProjectionModel(ClosedMechanism closed, UserForceSource userForces) {
    super(closed, userForces);
    String formulation = closed.description().formulation();
    completion = new Completion(work, closed.start(), formulation, this::note);
    if (work.isLarge()) {
      recursive = Optional.of(new RecursiveAccelerations(work, completion.ofVelocities()));
    }
    if (!completion.begin(closed.start().time(), closed.start().state())) {
      broken = Optional.of(completion.startsSingular());
    }
  }

  @Override
  public final boolean independent(int component) {
    return component >= work.furtherAt || completion.independent(component);
  }

  /** {@inheritDoc} Dependent components are tested too where drives or time move them. */
  @Override
  public final boolean tested(int component) {
    return movedByTime || independent(component);
  }

  @Override
  public final void enlarge(double[] sizes) {
    if (movedByTime) {
      completion.enlarge(sizes);
    }
  }

  @Override
  public final boolean complete(double t, double[] y) {
    return completion.complete(t, y);
  }

  @Override
  public final boolean accepted(double t, double[] y) {
    boolean other = completion.accepted(t, y);
    broken = completion.leftOutIsOpen(y);
    work.accepted(t);
    if (other) {
      note(new LoopFinding(LoopFinding.Kind.CHOSEN_ANEW, independentNames(), 0, "1", t));
    }
    return other;
  }

  @Override
  final void jumped(double t, double[] y, boolean closed) {
    completion.jumped(t, y, closed);
  }

  private String independentNames() {
    List<Variable> states = description().states();
    return IntStream.range(0, states.size())
        .filter(this::independent)
        .mapToObj(i -> states.get(i).name())
        .collect(Collectors.joining(", "));
  }

  @Override
  public final Optional<Defect> obstacle() {
    List<Variable> states = description().states();
    return broken.or(() -> completion.obstacle(position -> states.get(position).name()));
  }

  @Override
  public int stateLength() {
    return work.stateLength() + completion.stateLength();
  }

  @Override
  public void saveState(double[] state) {
    work.save(state, 0);
    completion.save(state, work.stateLength());
  }

  @Override
  public void restoreState(double[] state) {
    work.restore(state, 0);
    completion.restore(state, work.stateLength());
  }

  /** Returns whether the motion can continue from the last accepted state. */
  final boolean canContinue() {
    if (broken.isPresent()) {
      fail(broken.get());
    }
    return broken.isEmpty();
  }

  /** Returns the projected equations of motion. */
  final ProjectedMotion projected() {
    if (projected.isEmpty()) {
      projected = Optional.of(new ProjectedMotion(work.nv, completion.ofVelocities()));
    }
    return projected.get();
  }

  /** Forms R at the placed state. */
  final int formDirections() {
    if (!completion.ofVelocities().factor(work.loops.jacobian)) {
      return fail(completion.locked());
    }
    projected().formTransformation(work.loops.jacobian);
    return REGULAR;
  }

  @Override
  public final int derivative(double t, double[] y, double[] yDot) {
    if (!canContinue()) {
      return DEFECT;
    }
    int solved =
        recursive.isPresent() ? solveByRecursion(t, y, yDot) : solveInFreeDirections(t, y, yDot);
    if (solved == REGULAR) {
      work.coordinates.rates(y, 0, y, work.nq, yDot, 0);
      work.furtherRates(t, yDot, work.furtherAt);
    }
    return solved;
  }

  private int solveInFreeDirections(double t, double[] y, double[] yDot) {
    work.placeEquations(t, y);
    int begun = formDirections();
    if (begun != REGULAR) {
      return begun;
    }
    if (!work.formBias(t)) {
      return fail(work.forces.defect());
    }
    work.formMass();
    int singular = projected().reduce(work.mass());
    if (singular != ProjectedMotion.REGULAR) {
      return closed.jointOfVelocity(singular);
    }
    projected().accelerations(work.mass(), work.bias(), work.loops.acceleration, yDot, work.nq);
    return REGULAR;
  }

  /** Solves with the sparsity of the tree, or with R if M is singular. */
  private int solveByRecursion(double t, double[] y, double[] yDot) {
    if (work.accelerations(t, y, yDot, work.nq)) {
      return REGULAR;
    }
    work.placeRates(t, y);
    if (!work.formBias(t)) {
      return fail(work.forces.defect());
    }
    RecursiveAccelerations.Solved solved = recursive.get().solve(t, yDot, work.nq);
    if (solved == RecursiveAccelerations.Solved.WITHOUT_INERTIA) {
      return solveInFreeDirections(t, y, yDot);
    }
    return solved == RecursiveAccelerations.Solved.LOCKED ? fail(completion.locked()) : REGULAR;
  }
}
