package org.mechservice.solver.analysis.equation;

import java.util.Optional;
import java.util.stream.IntStream;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.Stiffness;
import org.mechservice.solver.linear.spectrum.Eigenvalues;

/**
 * Fastest eigenvalues of a model's equations y' = f(t, y), linearised in a state: of the Jacobian J
 * by central differences in the independent components.
 *
 * <p>Small models have all eigenvalues decomposed. Of larger ones the fastest are found by powers
 * of J, which tell eigenvalues of nearly the same modulus badly apart. A dominant pair of
 * eigenvalues obeys λ² = a λ + b. The numbers a and b follow by least squares from three successive
 * powers x, J x, J² x, whether the pair is real or complex (Wilkinson 1965, ch. 9).
 *
 * <p>Allocates; not for a hot loop. Evaluates the model, whose internal state may change.
 */
public final class FastSpectrum {
  private static final int COUNT = 30;

  /** Largest number of states of which all eigenvalues are found: it takes some milliseconds. */
  private static final int MOST_DECOMPOSED = 60;

  /** Relative size of a difference: balances rounding against curvature. */
  private static final double DIFFERENCE = 1e-7;

  /** Below this sin² of their angle, two powers are parallel: one real eigenvalue alone. */
  private static final double PARALLEL = 1e-12;

  private final ExplicitModel model;
  private final int positions;
  private final int endOfVelocities;
  private final double[] y;
  private final double[] moved;
  private final double[] slope;
  private double t;

  /** Creates the workspace for the spectra of a model. */
  public FastSpectrum(ExplicitModel model) {
    this.model = model;
    positions = model.description().positionCount();
    endOfVelocities = positions + model.description().velocityCount();
    y = new double[model.description().stateCount()];
    moved = new double[y.length];
    slope = new double[y.length];
  }

  /**
   * Eigenvalues, at least those of the fastest motion.
   *
   * @param real Re λ, 1/s
   * @param imaginary Im λ, rad/s
   * @param deciding index of the one that decides on stiffness
   * @param shape size of each component of the state in that motion
   */
  @SuppressWarnings("ArrayRecordComponent") // read at once and not compared
  public record Found(double[] real, double[] imaginary, int deciding, double[] shape) {}

  /**
   * Finds the eigenvalues in a state.
   *
   * @param t time, s
   * @param state y; dependent components are starting values; not modified
   * @return empty if nothing is independent, or if the equations have no derivative there
   */
  public Optional<Found> at(double t, double[] state) {
    this.t = t;
    System.arraycopy(state, 0, y, 0, y.length);
    int[] free = IntStream.range(0, y.length).filter(this::isFree).toArray();
    if (free.length == 0) {
      return Optional.empty();
    }
    return free.length <= MOST_DECOMPOSED ? ofAll(free) : ofPowers();
  }

  private boolean isFree(int component) {
    return !(model instanceof DependentStates loops) || loops.independent(component);
  }

  /** Finds all eigenvalues of J in the free components. */
  private Optional<Found> ofAll(int[] free) {
    int n = free.length;
    double[] jacobian = new double[n * n];
    double[] x = new double[y.length];
    double[] image = new double[y.length];
    for (int column = 0; column < n; column++) {
      x[free[column]] = 1;
      if (!multiply(x, image)) {
        return Optional.empty();
      }
      x[free[column]] = 0;
      for (int row = 0; row < n; row++) {
        jacobian[row * n + column] = image[free[row]];
      }
    }
    double unit = inUnitsOfTime(jacobian, free);
    if (!Double.isFinite(unit)) {
      return Optional.empty();
    }
    Eigenvalues all = new Eigenvalues(n, jacobian);
    if (!all.converged()) {
      return Optional.empty();
    }
    double[] real = new double[n];
    double[] imaginary = new double[n];
    for (int i = 0; i < n; i++) {
      real[i] = all.real(i) * unit;
      imaginary[i] = all.imaginary(i) * unit;
    }
    int deciding = Stiffness.deciding(real, imaginary);
    double[] re = new double[n];
    double[] im = new double[n];
    all.vector(deciding, re, im);
    for (int row = 0; row < n; row++) {
      x[free[row]] = Math.hypot(re[row], im[row]);
    }
    return Optional.of(new Found(real, imaginary, deciding, x));
  }

  /**
   * Takes time in a unit in which positions and velocities have the same size, so that the
   * decomposition loses no digits of a stiff spring, whose J has elements of λ² and 1.
   *
   * @return 1 / unit, 1/s
   */
  private double inUnitsOfTime(double[] jacobian, int[] free) {
    int n = free.length;
    double rate = 1;
    for (int row = 0; row < n; row++) {
      for (int column = 0; column < n; column++) {
        double size = Math.abs(jacobian[row * n + column]);
        boolean ofSpring = isVelocity(free[row]) && !isVelocity(free[column]);
        rate = Math.max(rate, ofSpring ? Math.sqrt(size) : size);
      }
    }
    for (int row = 0; row < n; row++) {
      for (int column = 0; column < n; column++) {
        boolean ofSpring = isVelocity(free[row]) && !isVelocity(free[column]);
        boolean ofMotion = !isVelocity(free[row]) && isVelocity(free[column]);
        jacobian[row * n + column] /= ofSpring ? rate * rate : ofMotion ? 1 : rate;
      }
    }
    return rate;
  }

  private boolean isVelocity(int component) {
    return component >= positions && component < endOfVelocities;
  }

  private Optional<Found> ofPowers() {
    double[] x = new double[y.length];
    for (int i = 0; i < x.length; i++) {
      // StrictMath gives the same start on every machine, so the choice that follows is the same.
      x[i] = isFree(i) ? StrictMath.sin(1.0 + i) : 0;
    }
    double[] image = new double[y.length];
    double[] second = new double[y.length];
    for (int i = 0; i < COUNT; i++) {
      if (!multiply(x, image)) {
        return Optional.empty();
      }
      double norm = Math.sqrt(product(image, image));
      for (int k = 0; k < x.length; k++) {
        x[k] = norm > 0 ? image[k] / norm : 0;
      }
    }
    return multiply(x, image) && multiply(image, second)
        ? judged(x, image, second)
        : Optional.empty();
  }

  private static double product(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  /** result = J x by a central difference in the free components. */
  private boolean multiply(double[] x, double[] result) {
    double size = 0;
    for (int i = 0; i < x.length; i++) {
      size = Math.max(size, Math.abs(x[i]) / (1 + Math.abs(y[i])));
    }
    double step = DIFFERENCE / size;
    boolean defined = size > 0 && derivative(x, step);
    System.arraycopy(slope, 0, result, 0, result.length);
    defined &= defined && derivative(x, -step);
    for (int i = 0; i < result.length; i++) {
      result[i] = isFree(i) ? (result[i] - slope[i]) / (2 * step) : 0;
      defined &= Double.isFinite(result[i]);
    }
    return defined;
  }

  private boolean derivative(double[] x, double step) {
    for (int i = 0; i < moved.length; i++) {
      moved[i] = y[i] + step * x[i];
    }
    boolean closed = !(model instanceof DependentStates loops) || loops.complete(t, moved);
    return closed && model.derivative(t, moved, slope) == ExplicitModel.REGULAR;
  }

  /** Returns the pair of three powers x, J x and J² x; empty if their products overflow. */
  private static Optional<Found> judged(double[] x, double[] image, double[] second) {
    double xx = product(x, x);
    double along = product(image, x) / xx;
    double imageSquare = product(image, image);
    double across = imageSquare - along * along * xx;
    double a = along;
    double b = 0;
    if (across > PARALLEL * imageSquare) {
      // J² x = a J x + b x, J x taken as its part along x and that across it.
      double ofX = product(second, x) / xx;
      a = (product(second, image) - along * product(second, x)) / across;
      b = ofX - a * along;
    }
    if (!Double.isFinite(a) || !Double.isFinite(b)) {
      return Optional.empty();
    }
    double discriminant = 0.25 * a * a + b;
    double[] real = {0.5 * a, 0.5 * a};
    double[] imaginary = {0, 0};
    if (discriminant < 0) {
      imaginary[0] = Math.sqrt(-discriminant);
      imaginary[1] = -imaginary[0];
    } else {
      real[0] += Math.copySign(Math.sqrt(discriminant), a);
      real[1] = real[0] == 0 ? 0 : -b / real[0];
    }
    return Optional.of(new Found(real, imaginary, Stiffness.deciding(real, imaginary), image));
  }
}
