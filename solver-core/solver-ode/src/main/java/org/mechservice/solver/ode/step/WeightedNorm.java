package org.mechservice.solver.ode.step;

import org.mechservice.solver.ode.ErrorWeightGroups;

/**
 * Sets the error allowed in each component from its size. Components that share a weight have the
 * Euclidean norm of all of them for size; components that are not tested weigh nothing, but make a
 * norm NaN if they are not finite.
 */
abstract class WeightedNorm implements ErrorNorm {
  private double relativeTolerance;
  private double[] absoluteTolerance = {};
  private double[] size = {};
  private double[] largestSize = {};
  private int dimension;

  /** Whether nothing but its own size bears on the weight of a component. */
  private boolean bySizeAlone;

  private Manifold manifold = new Manifold(RightHandSide.none().system());

  /** Reciprocal of the error allowed, 0 where not tested. */
  double[] weight = {};

  @Override
  public final void begin(double relativeTolerance, double[] absoluteTolerance, Manifold manifold) {
    this.relativeTolerance = relativeTolerance;
    this.absoluteTolerance = absoluteTolerance;
    this.manifold = manifold;
    bySizeAlone = manifold.weighsBySizeAlone();
    dimension = absoluteTolerance.length;
    weight = new double[dimension];
    size = new double[dimension];
    largestSize = new double[dimension];
    for (int l = 0; l < dimension; l++) {
      largestSize[l] = manifold.groups().largestSize(l);
    }
  }

  /**
   * Returns the error allowed in a component.
   *
   * @param size its absolute value, or that of its group
   */
  abstract double allowed(double relativeTolerance, double size, double absoluteTolerance);

  @Override
  public final void weigh(double[] y) {
    weigh(y, y);
  }

  @Override
  public final void weigh(double[] y1, double[] y2) {
    if (bySizeAlone) {
      for (int l = 0; l < dimension; l++) {
        weight[l] = 1 / allowed(relativeTolerance, larger(y1[l], y2[l]), absoluteTolerance[l]);
      }
      return;
    }
    for (int l = 0; l < dimension; l++) {
      size[l] = larger(y1[l], y2[l]);
    }
    weighGroups(y1, y2);
    for (int l = 0; l < dimension; l++) {
      size[l] = Math.min(size[l], largestSize[l]);
    }
    manifold.enlarge(size);
    for (int l = 0; l < dimension; l++) {
      weight[l] =
          manifold.tested(l) ? 1 / allowed(relativeTolerance, size[l], absoluteTolerance[l]) : 0;
    }
  }

  /** Returns the larger magnitude; NaN if the second is NaN. */
  private static double larger(double first, double second) {
    double size1 = Math.abs(first);
    double size2 = Math.abs(second);
    return size2 <= size1 ? size1 : size2;
  }

  private void weighGroups(double[] y1, double[] y2) {
    ErrorWeightGroups groups = manifold.groups();
    for (int g = 0; g < groups.groupCount(); g++) {
      int start = groups.groupStart(g);
      int end = start + groups.groupSize(g);
      double shared = Math.max(norm(y1, start, end), norm(y2, start, end));
      for (int l = start; l < end; l++) {
        size[l] = shared;
      }
    }
  }

  private static double norm(double[] y, int start, int end) {
    double sum = 0;
    for (int l = start; l < end; l++) {
      sum += y[l] * y[l];
    }
    return Math.sqrt(sum);
  }

  @Override
  public final double weight(int component) {
    return weight[component];
  }
}
