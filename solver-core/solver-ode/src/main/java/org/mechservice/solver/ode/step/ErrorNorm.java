package org.mechservice.solver.ode.step;

/**
 * Measures vectors in units of the error allowed: a local error of norm 1 just passes.
 *
 * <p>Not sealed: a class file names what its type permits, and a JAR of one method would carry all
 * of them.
 */
public interface ErrorNorm {
  /**
   * Begins a problem.
   *
   * @param relativeTolerance error allowed relative to a component
   * @param absoluteTolerance error allowed in a small component, per component; kept, not modified
   * @param manifold which components are tested and which share a weight; asked anew by {@link
   *     #weigh}
   */
  void begin(double relativeTolerance, double[] absoluteTolerance, Manifold manifold);

  /**
   * Sets the error allowed in each component.
   *
   * @param y state the step starts from; not modified
   */
  void weigh(double[] y);

  /**
   * Sets the error allowed in each component by the larger of two states.
   *
   * @param y1 not modified
   * @param y2 not modified
   */
  void weigh(double[] y1, double[] y2);

  /** Returns the norm of a vector; NaN or infinite if a component is. */
  double of(double[] x);

  /** Returns the norm of the sum of two vectors. */
  double ofSum(double[] x1, double[] x2);

  /** Returns the reciprocal of the error allowed in a component; 0 if it is not tested. */
  double weight(int component);

  /** Returns the component that contributes most to the norm of a vector; −1 if there is none. */
  default int largest(double[] x) {
    int largest = -1;
    double most = -1;
    for (int l = 0; l < x.length; l++) {
      double part = Math.abs(x[l]) * weight(l);
      if (part > most && weight(l) > 0) {
        most = part;
        largest = l;
      }
    }
    return largest;
  }
}
