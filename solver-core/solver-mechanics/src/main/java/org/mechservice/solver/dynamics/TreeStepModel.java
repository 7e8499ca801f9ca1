package org.mechservice.solver.dynamics;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.dynamics.derivative.FurtherDerivatives;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.derivative.TreeStep;
import org.mechservice.solver.dynamics.tree.TreeMatrix;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.kinematics.StateCoordinates;

/**
 * Superclass of generated RR-JF models, whose code evaluates the residual and its derivatives. This
 * class solves the equations of an implicit step along the tree and checks their pivots.
 */
public abstract class TreeStepModel implements LinearisedModel, RunNotes {
  final TreeMatrix mass;
  final TreeSquare byVelocity;
  final TreeSquare byPosition;
  private final FurtherDerivatives further;
  private final TreeStep step;

  /** Argument of {@link #derivatives}; elements that are never written are zero. */
  private final double[] values;

  /** Destinations of the values, in order. */
  private final double[][] parts;

  /**
   * @param types of the joints that have states, separated by blanks
   * @param tree velocity of the state and place nearer the root (−1: none) of each place of the
   *     {@link TreePattern}, separated by blanks
   * @param coupled places of elements beyond those of the tree, two for each, separated by blanks
   */
  protected TreeStepModel(String types, String tree, String coupled) {
    this(types, tree, coupled, "0");
  }

  /**
   * Makes a model with further states.
   *
   * @param furtherStates their number
   */
  protected TreeStepModel(String types, String tree, String coupled, String furtherStates) {
    int[] places = numbers(tree);
    int[] velocityAt = new int[places.length / 2];
    int[] parent = new int[velocityAt.length];
    for (int place = 0; place < parent.length; place++) {
      velocityAt[place] = places[2 * place];
      parent[place] = places[2 * place + 1];
    }
    TreePattern pattern = new TreePattern(velocityAt, parent, numbers(coupled));
    mass = new TreeMatrix(pattern);
    byVelocity = new TreeSquare(pattern);
    byPosition = new TreeSquare(pattern);
    StateCoordinates coordinates = new StateCoordinates(typesOf(types));
    further =
        new FurtherDerivatives(
            coordinates.positionCount(), pattern.size, Integer.parseInt(furtherStates));
    step =
        new TreeStep(
            new TreeIteration(coordinates, pattern, mass, byVelocity, byPosition), further);
    parts =
        new double[][] {
          mass.diagonal(),
          mass.lower(),
          byVelocity.diagonal,
          byVelocity.lower,
          byVelocity.upper,
          byPosition.diagonal,
          byPosition.lower,
          byPosition.upper
        };
    values =
        new double
            [3 * pattern.size
                + 5 * pattern.elementCount()
                + FurtherDerivatives.numbers(pattern.size, further.count())];
  }

  private static List<JointType> typesOf(String text) {
    return text.isEmpty()
        ? List.of()
        : Arrays.stream(text.split(" ", -1)).map(JointType::valueOf).toList();
  }

  private static int[] numbers(String text) {
    return text.isEmpty()
        ? new int[0]
        : Arrays.stream(text.split(" ", -1)).mapToInt(Integer::parseInt).toArray();
  }

  /**
   * Evaluates the derivatives of the residual's second part by v', v and q, along the tangent for
   * Euler parameters.
   *
   * @param t time, s
   * @param y state; not modified
   * @param yDot its derivative; not modified
   * @param values elements that are not always zero are overwritten: the diagonal and what is below
   *     it of M; diagonal, below and above of ∂F/∂v; the same of ∂F/∂q; each by place, or in the
   *     order of the pattern; then the {@link FurtherDerivatives}, if there are further states
   * @return as {@link #residual}
   */
  public abstract int derivatives(double t, double[] y, double[] yDot, double[] values);

  @Override
  public final boolean linearise(double t, double[] y, double[] yDot) {
    if (derivatives(t, y, yDot, values) != REGULAR) {
      return false;
    }
    int at = 0;
    for (double[] part : parts) {
      System.arraycopy(values, at, part, 0, part.length);
      at += part.length;
    }
    further.take(values, at);
    step.setState(y);
    return byPosition.isFinite() && byVelocity.isFinite() && further.isFinite();
  }

  @Override
  public final boolean factor(double hGamma) {
    return step.factor(hGamma);
  }

  @Override
  public final void solve(double[] r) {
    step.solve(r);
  }

  @Override
  public final boolean solveForDerivative(double[] r) {
    return step.solveForDerivative(r);
  }

  @Override
  public final int singularUnknown() {
    return step.singularUnknown();
  }

  /** Returns the derivatives of the last {@link #linearise} that further states add. */
  final FurtherDerivatives further() {
    return further;
  }

  @Override
  public List<Note> notes() {
    return step.notes();
  }
}
