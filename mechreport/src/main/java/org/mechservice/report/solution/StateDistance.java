package org.mechservice.report.solution;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;

/**
 * The distance of two states of a model, with one definition for all methods and references: the
 * largest |x − x_ref| / (1 + |x_ref|) in SI units, Euler parameters normalised and up to their
 * sign.
 */
public final class StateDistance {
  private static final int EULER_PARAMETERS = 4;

  private final int positions;
  private final int states;
  private final int[] eulerParameters;

  public StateDistance(ModelDescription description) {
    positions = description.positionCount();
    states = description.stateCount();
    eulerParameters = starts(description.joints());
  }

  private static int[] starts(List<JointVariables> joints) {
    java.util.stream.IntStream.Builder starts = java.util.stream.IntStream.builder();
    int position = 0;
    for (JointVariables joint : joints) {
      JointType type = joint.type();
      if (type.hasEulerParameters()) {
        starts.add(position);
      }
      position += type.positionCount();
    }
    return starts.build().toArray();
  }

  /** Returns the distance of the positions. */
  public double ofPositions(double[] y, double[] reference) {
    return largest(aligned(y, reference), reference, 0, positions);
  }

  /** Returns the distance of the velocities. */
  public double ofVelocities(double[] y, double[] reference) {
    return largest(y, reference, positions, states);
  }

  /** Returns the larger of both. */
  public double of(double[] y, double[] reference) {
    return Math.max(ofPositions(y, reference), ofVelocities(y, reference));
  }

  /** The state with Euler parameters of norm 1 on the side of the reference's. */
  private double[] aligned(double[] y, double[] reference) {
    if (eulerParameters.length == 0) {
      return y;
    }
    double[] turned = y.clone();
    for (int start : eulerParameters) {
      double norm = 0;
      double product = 0;
      for (int i = start; i < start + EULER_PARAMETERS; i++) {
        norm += y[i] * y[i];
        product += y[i] * reference[i];
      }
      double factor = Math.copySign(1 / Math.sqrt(norm), product);
      for (int i = start; i < start + EULER_PARAMETERS; i++) {
        turned[i] *= factor;
      }
    }
    return turned;
  }

  private static double largest(double[] y, double[] reference, int from, int to) {
    double largest = 0;
    for (int i = from; i < to; i++) {
      double distance = Math.abs(y[i] - reference[i]) / (1 + Math.abs(reference[i]));
      largest = distance >= 0 ? Math.max(largest, distance) : Double.POSITIVE_INFINITY;
    }
    return largest;
  }
}
