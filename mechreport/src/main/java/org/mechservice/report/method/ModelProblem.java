package org.mechservice.report.method;

import org.mechservice.report.reference.Problem;
import org.mechservice.solver.api.DependentStates;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.ProjectedStates;

/**
 * A model's y' = f(t, y) for the reference codes and for differences. Components that follow from
 * the loops are found anew at every evaluation.
 */
public final class ModelProblem implements Problem {
  private final ExplicitModel model;
  private final int dimension;
  private final double[] closed;

  public ModelProblem(ExplicitModel model) {
    this.model = model;
    ModelDescription description = model.description();
    dimension = description.stateCount();
    closed = new double[dimension];
  }

  @Override
  public int dimension() {
    return dimension;
  }

  /** Returns the state at the start. */
  public double[] start() {
    double[] y = new double[dimension];
    model.initialState(y);
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

  @Override
  public boolean derivative(double t, double[] y, double[] yDot) {
    System.arraycopy(y, 0, closed, 0, dimension);
    if (model instanceof DependentStates loops && !loops.complete(t, closed)) {
      return false;
    }
    if (model.derivative(t, closed, yDot) != ExplicitModel.REGULAR) {
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
      loops.accepted(t, y);
    }
    return true;
  }

  /** Moves a state onto the constraints. */
  public boolean close(double t, double[] y) {
    if (model instanceof DependentStates loops) {
      return loops.complete(t, y);
    }
    return !(model instanceof ProjectedStates loops) || loops.project(t, y);
  }
}
