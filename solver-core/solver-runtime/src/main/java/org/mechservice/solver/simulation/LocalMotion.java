package org.mechservice.solver.simulation;

import java.util.Arrays;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.simulation.equations.ModelEquations;

/**
 * Motion of one velocity coordinate with its position, with the other independent ones constant: s²
 * + c s + k = 0, with c = −∂a/∂v and k = −∂a/∂q of its acceleration a. It explains the short steps
 * of a failed run.
 *
 * @param damping c, 1/s
 * @param stiffness k, 1/s²
 */
record LocalMotion(double damping, double stiffness) {
  /** Change of a coordinate as a part of it, and the size from which it counts, SI units. */
  private static final double INCREMENT = Math.sqrt(Math.ulp(1.0));

  private static final double SMALL = 1e-3;

  private static final LocalMotion UNKNOWN = new LocalMotion(Double.NaN, Double.NaN);

  /**
   * Returns the motion of a state, by differences; NaN if the equations have no value or the state
   * is not an independent coordinate.
   *
   * @param unknown unknown of the equations
   * @param y state; not modified
   */
  static LocalMotion of(ModelEquations equations, int unknown, double t, double[] y) {
    ModelDescription model = equations.model().description();
    int v = velocity(model, unknown);
    if (v < 0) {
      return UNKNOWN;
    }
    int positions = model.positionCount();
    double[] slope = slope(equations, t, y);
    double[] moved = y.clone();
    moved[v] += INCREMENT * Math.max(SMALL, Math.abs(y[v]));
    double faster = moved[v] - y[v];
    double[] slopeFaster = slope(equations, t, moved);
    System.arraycopy(y, 0, moved, 0, moved.length);
    double size = 0;
    double change = 0;
    for (int i = 0; i < positions; i++) {
      size = Math.max(size, Math.abs(y[i]));
      change = Math.max(change, Math.abs(slopeFaster[i] - slope[i]) / faster);
    }
    double farther = INCREMENT * Math.max(SMALL, size) / change;
    for (int i = 0; i < positions; i++) {
      moved[i] += farther * (slopeFaster[i] - slope[i]) / faster;
    }
    double[] slopeFarther = slope(equations, t, moved);
    return new LocalMotion(
        (slope[v] - slopeFaster[v]) / faster, (slope[v] - slopeFarther[v]) / farther);
  }

  /** Returns the velocity that belongs to an unknown, by its place; −1 if none is its own. */
  private static int velocity(ModelDescription model, int unknown) {
    if (unknown < 0 || unknown >= model.stateCount()) {
      return -1;
    }
    if (unknown >= model.positionCount()) {
      int end = model.positionCount() + model.velocityCount();
      return unknown < end ? unknown : -1;
    }
    int q = 0;
    int v = model.positionCount();
    for (JointVariables joint : model.joints()) {
      int next = q + joint.type().positionCount();
      if (unknown < next) {
        return joint.type().hasEulerParameters() ? -1 : v + unknown - q;
      }
      q = next;
      v += joint.type().velocityCount();
    }
    return -1;
  }

  /** Returns the derivative with closed loops; NaN if there is none. */
  private static double[] slope(ModelEquations equations, double t, double[] y) {
    double[] closed = y.clone();
    double[] slope = new double[y.length];
    boolean known =
        equations.closeLoops(t, closed)
            && equations.model().derivative(equations.evaluationTime(t), closed, slope)
                == ExplicitModel.REGULAR;
    if (!known) {
      Arrays.fill(slope, Double.NaN);
    }
    return slope;
  }

  /** Returns the motion as a sentence followed by a space; empty if it is zero or unknown. */
  String sentence() {
    double discriminant = damping * damping - 4 * stiffness;
    String rate;
    if (discriminant < 0) {
      double natural = Math.sqrt(stiffness);
      rate =
          "swings at "
              + rounded(natural / (2 * Math.PI))
              + " Hz, damping ratio "
              + rounded(damping / (2 * natural));
    } else {
      double root = Math.sqrt(discriminant);
      double growth = (root - damping) / 2;
      double decay = (root + damping) / 2;
      if (!(growth > 0 || decay > 0) || Double.isInfinite(root)) {
        return "";
      }
      rate =
          growth > 0
              ? "grows at " + rounded(growth) + " 1/s"
              : "decays at " + rounded(decay) + " 1/s";
    }
    return "By itself it " + rate + " there. ";
  }

  /** Returns a number to seven digits, or to all of them if it is too large for that. */
  private static String rounded(double number) {
    float seven = (float) number;
    return Float.isInfinite(seven) ? Double.toString(number) : Float.toString(seven);
  }
}
