package org.mechservice.report.method;

import java.util.Optional;
import org.mechservice.report.reference.Phases;
import org.mechservice.report.reference.Problem;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ProjectedStates;

/**
 * A model's y' = f(t, y) for the reference codes and for differences. Dependent components are
 * computed from the loops at every evaluation.
 */
public final class ModelProblem implements Problem {
  /** The start and two times behind it show whether an error grows. */
  private static final int FEWEST_TIMES = 3;

  private final ExplicitModel model;
  private final int dimension;
  private final double[] closed;
  private final Optional<ModelPhases> phases;
  private int fewestTimes = Integer.MAX_VALUE;

  /** Creates a problem without events. */
  public ModelProblem(ExplicitModel model) {
    this(model, Optional.empty());
  }

  /**
   * @param events events along the solution, made for this object
   */
  public ModelProblem(ExplicitModel model, ModelEvents events) {
    this(model, Optional.of(events));
  }

  private ModelProblem(ExplicitModel model, Optional<ModelEvents> events) {
    this.model = model;
    ModelDescription description = model.description();
    dimension = description.stateCount();
    closed = new double[dimension];
    phases = events.map(some -> new ModelPhases(some, this));
  }

  @Override
  public Phases phases() {
    return phases.isPresent() ? phases.get() : Phases.NONE;
  }

  /** Returns the phases of the last solution; empty if the model has no events. */
  public Optional<ModelPhases> course() {
    return phases;
  }

  @Override
  public int dimension() {
    return dimension;
  }

  /** Returns the state at the start, with the samples of that time. */
  public double[] start() {
    double[] y = new double[dimension];
    model.initialState(y);
    phases.ifPresent(some -> some.sample(y));
    return y;
  }

  /** Returns the model. */
  public ExplicitModel model() {
    return model;
  }

  /** Returns whether a component is free to be chosen, the loops determining the others. */
  public boolean independent(int component) {
    return !(model instanceof DependentStates loops) || loops.independent(component);
  }

  /** Takes a part of the interval from codes whose time ends, for a mechanism that is large. */
  public void takePart() {
    fewestTimes = FEWEST_TIMES;
  }

  @Override
  public int fewestTimes() {
    return fewestTimes;
  }

  @Override
  public boolean matters(int component) {
    return independent(component);
  }

  /** {@inheritDoc} As for runs, it is the scene's. */
  @Override
  public double longestStep() {
    double most = model.description().defaults().maxStep();
    return most > 0 ? most : Double.POSITIVE_INFINITY;
  }

  @Override
  public boolean derivative(double t, double[] y, double[] yDot) {
    System.arraycopy(y, 0, closed, 0, dimension);
    double moment = moment(t);
    if (model instanceof DependentStates loops && !loops.complete(moment, closed)) {
      return false;
    }
    if (model.derivative(moment, closed, yDot) != ExplicitModel.REGULAR) {
      return false;
    }
    for (double slope : yDot) {
      if (!Double.isFinite(slope)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public boolean stepEnded(double t, double[] y) {
    if (!close(t, y)) {
      return false;
    }
    if (model instanceof DependentStates loops) {
      loops.accepted(moment(t), y);
    }
    return true;
  }

  /** Moves a state onto the constraints. */
  public boolean close(double t, double[] y) {
    if (model instanceof DependentStates loops) {
      return loops.complete(moment(t), y);
    }
    return !(model instanceof ProjectedStates loops) || loops.project(moment(t), y);
  }

  /** Returns the time for evaluations at a jump of the equations. */
  private double moment(double t) {
    return phases.isPresent() ? phases.get().within(t) : t;
  }
}
