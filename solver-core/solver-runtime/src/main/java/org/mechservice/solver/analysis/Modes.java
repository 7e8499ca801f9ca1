package org.mechservice.solver.analysis;

import java.util.Arrays;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.linear.spectrum.Eigenvalues;

/**
 * Eigenvalues λ and shapes of small motions e^(λt): the slowest first, one mode for each pair of
 * conjugates, two for the real pair of an overdamped motion. A motion without restoring force, such
 * as that of a body in free flight, has modes with λ = 0: two of them without damping.
 */
final class Modes {
  /**
   * Eigenvalues below this part of the largest are zero: a double one at zero is found to half the
   * digits.
   */
  static final double ZERO = 1e-6;

  /** Part of the change of further states below which the mechanism stands still in a mode. */
  private static final double STILL = 1e-12;

  private final Linearisation linear;
  private final int ns;
  private final Eigenvalues eigen;
  private final int[] mode;
  private final double zero;

  /**
   * @param system as {@link Linearisation#changing} returned it, not empty
   */
  Modes(Linearisation linear, double[] system) {
    this.linear = linear;
    ns = linear.changingCount();
    int size = linear.order() - linear.furtherCount() + ns;
    eigen = new Eigenvalues(size, system);
    int[] found = new int[size];
    int count = 0;
    double largest = 0;
    for (int i = 0; i < size && eigen.converged(); i++) {
      largest = Math.max(largest, StrictMath.hypot(eigen.real(i), eigen.imaginary(i)));
      if (eigen.imaginary(i) >= 0) {
        found[count++] = i;
      }
    }
    mode = Arrays.copyOf(found, count);
    zero = ZERO * largest;
  }

  /** Returns whether all eigenvalues were found. */
  boolean converged() {
    return eigen.converged();
  }

  int count() {
    return mode.length;
  }

  private double modulus(int k) {
    return StrictMath.hypot(eigen.real(mode[k]), eigen.imaginary(mode[k]));
  }

  private boolean isZero(int k) {
    return modulus(k) <= zero;
  }

  /** Returns Re λ, 1/s. */
  double growth(int k) {
    return isZero(k) ? 0 : eigen.real(mode[k]);
  }

  /** Returns Im λ ≥ 0, rad/s. */
  double angularFrequency(int k) {
    return isZero(k) ? 0 : eigen.imaginary(mode[k]);
  }

  /** Returns |λ| / 2π, Hz: the frequency without its damping. */
  double frequency(int k) {
    return isZero(k) ? 0 : modulus(k) / (2 * Math.PI);
  }

  /**
   * Returns −Re λ / |λ|: 0 of an undamped mode, 1 of one that does not oscillate, negative of one
   * that grows; 0 where λ is.
   */
  double dampingRatio(int k) {
    return isZero(k) ? 0 : -eigen.real(mode[k]) / modulus(k);
  }

  /**
   * Writes the displacement of each velocity's coordinate, rad or m, with the largest equal to 1 (1
   * rad or one length of the mechanism), and the change of each further state. In a mode of further
   * states alone the largest of these is 1.
   *
   * @param unit of each velocity
   * @param re real parts, those of the further states after those of the velocities; overwritten
   * @param im imaginary parts, likewise; overwritten
   */
  void shape(int k, double[] unit, double[] re, double[] im) {
    double[] vr = new double[linear.order() - linear.furtherCount() + ns];
    double[] vi = new double[vr.length];
    eigen.vector(mode[k], vr, vi);
    linear.expandPlaces(vr, re);
    linear.expandPlaces(vi, im);
    System.arraycopy(vr, vr.length - ns, re, unit.length, ns);
    System.arraycopy(vi, vi.length - ns, im, unit.length, ns);
    int largest = largest(re, im, unit, 0, unit.length);
    if (ns > 0) {
      int ofStates = largest(re, im, unit, unit.length, re.length);
      boolean still =
          unit.length == 0 || size(re, im, unit, largest) <= STILL * size(re, im, unit, ofStates);
      largest = still ? ofStates : largest;
    }
    double of = largest < unit.length ? unit[largest] : 1;
    double dr = re[largest] / of;
    double di = im[largest] / of;
    double square = dr * dr + di * di;
    for (int i = 0; i < re.length; i++) {
      double r = (re[i] * dr + im[i] * di) / square;
      im[i] = eigen.imaginary(mode[k]) == 0 ? 0 : (im[i] * dr - re[i] * di) / square;
      re[i] = r;
    }
  }

  private static int largest(double[] re, double[] im, double[] unit, int from, int to) {
    int largest = from;
    for (int i = from + 1; i < to; i++) {
      if (size(re, im, unit, i) > size(re, im, unit, largest) * (1 + 1e-9)) {
        largest = i;
      }
    }
    return largest;
  }

  private static double size(double[] re, double[] im, double[] unit, int i) {
    return StrictMath.hypot(re[i], im[i]) / (i < unit.length ? unit[i] : 1);
  }
}
