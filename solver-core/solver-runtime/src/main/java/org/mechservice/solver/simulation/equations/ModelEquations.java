package org.mechservice.solver.simulation.equations;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.LongToDoubleFunction;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.StateVariable;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.DirectedForces;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.api.capability.StateJumps;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.PiecewiseSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SavedSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.UnitNormGroups;

/**
 * Common part of all forms of a model's equations: groups of Euler parameters, error scales, times
 * of jumps, and the defect of the last failed evaluation.
 */
public abstract class ModelEquations implements UnitNormGroups, PiecewiseSystem, SavedSystem {
  /** Last places of time within which a step ends behind a change of the equations. */
  private static final double BESIDE_CHANGES = 512;

  private static final int EULER_PARAMETERS = 4;

  private final ExplicitModel model;
  private final int dimension;
  private final int[] groupStarts;
  private final boolean[] angle;
  private List<Double> breakpoints = List.of();
  private Optional<LongToDoubleFunction> sequence = Optional.empty();
  private boolean endsBehindChanges;
  private RunEvents events = new RunEvents();
  private int result = ExplicitModel.REGULAR;

  ModelEquations(ExplicitModel model, int dimension) {
    this.model = model;
    this.dimension = dimension;
    this.groupStarts = groupStarts(model.description());
    angle = new boolean[dimension];
    List<Variable> states = model.description().states();
    int ofJoints = states.size() - model.description().furtherStates().size();
    for (int i = 0; i < ofJoints; i++) {
      angle[i] = states.get(i).unit().equals("rad");
    }
  }

  private static int[] groupStarts(ModelDescription description) {
    List<Integer> starts = new ArrayList<>();
    int position = 0;
    for (JointVariables joint : description.joints()) {
      if (joint.type().hasEulerParameters()) {
        starts.add(position);
      }
      position += joint.type().positionCount();
    }
    return starts.stream().mapToInt(Integer::intValue).toArray();
  }

  /**
   * Returns the absolute tolerance of each unknown; that of displacements for multipliers.
   *
   * @param settings with tolerances by kind of state
   */
  public final List<Double> absoluteTolerances(RunSettings settings) {
    List<Variable> states = model.description().states();
    List<Double> tolerances = new ArrayList<>();
    for (int i = 0; i < dimension; i++) {
      String unit = i < states.size() ? states.get(i).unit() : "m";
      tolerances.add(settings.absoluteTolerance(unit));
    }
    int at = states.size() - model.description().furtherStates().size();
    for (StateVariable state : model.description().furtherStates()) {
      double own = state.absoluteTolerance();
      tolerances.set(at++, own > 0 ? own : settings.angleTolerance());
    }
    return tolerances;
  }

  /**
   * {@inheritDoc} An angle counts as a whole turn at most
   * (docs/theory/integrators.md#error-control).
   */
  @Override
  public final double largestSize(int component) {
    return angle[component] ? 2 * Math.PI : Double.POSITIVE_INFINITY;
  }

  /** Returns the number of unknowns: states, and multipliers if the form has them. */
  public final int dimension() {
    return dimension;
  }

  /**
   * Begins to integrate.
   *
   * @param y0 unknowns at the start, the states being given; multipliers are overwritten
   */
  public abstract StepResult start(Integrator integrator, double t0, double[] y0, double tEnd);

  /** Resumes a saved integration of these equations. */
  public abstract StepResult resume(Integrator integrator, byte[] saved);

  /** Saves or restores the model's internal state, if it has one. */
  @Override
  public final void transfer(SavedState state) {
    if (model instanceof ModelState own) {
      transfer(own, state);
    }
  }

  /** Saves or restores an internal state. */
  public static void transfer(ModelState own, SavedState state) {
    double[] numbers = new double[own.stateLength()];
    own.saveState(numbers);
    state.numbers(numbers);
    if (state.restoring()) {
      own.restoreState(numbers);
    }
  }

  /**
   * Closes the loops at an interpolated state.
   *
   * @param y unknowns; overwritten
   * @return false if the loops cannot be closed there
   */
  public final boolean closeLoops(double t, double[] y) {
    if (model instanceof DependentStates loops) {
      return loops.complete(evaluationTime(t), y);
    }
    return !(model instanceof ProjectedStates loops) || loops.project(evaluationTime(t), y);
  }

  /**
   * Closes the loops after unknowns have been set, by an event or from outside.
   *
   * @param y unknowns; overwritten
   * @param set whether each of them was set, which holds it if the loops permit; not modified
   * @return false if the loops cannot be closed
   */
  public final boolean closeLoopsAfterJump(double t, double[] y, boolean[] set) {
    return model instanceof StateJumps loops ? loops.jump(t, y, set) : closeLoops(t, y);
  }

  /** Sets the events of the run. */
  final void follow(RunEvents along) {
    events = along;
  }

  /** Returns the time for evaluations at {@code t}, at which a prescribed motion may jump. */
  public final double evaluationTime(double t) {
    return events.evaluationTime(t);
  }

  /** Sets the times at which the equations jump. */
  final void breakAt(List<Double> times) {
    breakpoints = List.copyOf(times);
  }

  /**
   * Adds times at which steps end and begin anew.
   *
   * @param times as {@link #sequence} has them
   */
  public final void alsoBreakAt(LongToDoubleFunction times) {
    sequence = Optional.of(times);
  }

  @Override
  public final LongToDoubleFunction sequence() {
    return sequence.orElseGet(PiecewiseSystem.super::sequence);
  }

  @Override
  public final List<Double> breakpoints() {
    return breakpoints;
  }

  /** Takes note that steps end just behind changes of the equations' form over the state. */
  final void endStepsBehindChanges() {
    endsBehindChanges = true;
  }

  /**
   * Returns how far inside a step its ends have to be looked at to see the form of the equations
   * that holds in it, s: at the end they may have the next one.
   *
   * @param t where a step ends, s
   */
  public final double inset(double t) {
    boolean breaks = endsBehindChanges || !breakpoints.isEmpty() || sequence.isPresent();
    return breaks ? BESIDE_CHANGES * Math.ulp(t) : 0;
  }

  /** Returns the name of an unknown. */
  public final String name(int unknown) {
    List<Variable> states = model.description().states();
    return unknown < states.size()
        ? states.get(unknown).name()
        : "multiplier " + (unknown - states.size());
  }

  /** Returns the model. */
  public final ExplicitModel model() {
    return model;
  }

  /** Stores the result of an evaluation; the values of a failed one are set to NaN. */
  final void note(int evaluated, double[] values) {
    result = evaluated;
    if (evaluated != ExplicitModel.REGULAR) {
      Arrays.fill(values, Double.NaN);
    }
  }

  /**
   * Returns the joint at which the last evaluation was singular, or {@link ExplicitModel#REGULAR}.
   */
  public final int singularJoint() {
    return result >= 0 ? result : ExplicitModel.REGULAR;
  }

  /**
   * Returns why a run failed, if the model gives a reason; for the arguments see {@link
   * Defects#withoutValue}.
   */
  public final Optional<Defects.Defect> defect(
      double t, double[] y, double[] yDot, List<Failure.Step> tried) {
    Optional<Defects.Defect> formula =
        model instanceof Defects able ? able.withoutValue(t, y, yDot, tried) : Optional.empty();
    return formula.isPresent() ? formula : defect();
  }

  /** Returns why the last evaluation failed, if the model gives a reason. */
  public Optional<Defects.Defect> defect() {
    if (result <= DirectedForces.FIRST && model instanceof DirectedForces forces) {
      return Optional.of(withoutDirection(forces, result));
    }
    return result == Defects.DEFECT && model instanceof Defects able
        ? Optional.of(able.lastDefect())
        : Optional.empty();
  }

  /** Explains an evaluation of generated code at which a force lost its direction. */
  private static Defects.Defect withoutDirection(DirectedForces forces, int result) {
    return new Defects.Defect(
        MessageCode.FORCE_WITHOUT_DIRECTION,
        "force " + forces.directedForce(DirectedForces.force(result)),
        "It has no direction: its two points coincide, or its frames are turned by half a turn.",
        "Move a point or turn a frame, or use an element that suits the motion.");
  }

  /** Returns why the integration could not continue, if the model gives a reason. */
  public final Optional<Defects.Defect> obstacle() {
    return model instanceof Defects able ? able.obstacle() : Optional.empty();
  }

  @Override
  public final int groupCount() {
    return groupStarts.length;
  }

  @Override
  public final int groupStart(int group) {
    return groupStarts[group];
  }

  @Override
  public final int groupSize(int group) {
    return EULER_PARAMETERS;
  }
}
