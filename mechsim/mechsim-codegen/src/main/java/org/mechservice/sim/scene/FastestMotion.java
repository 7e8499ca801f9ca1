package org.mechservice.sim.scene;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.apache.commons.math3.exception.MathArithmeticException;
import org.apache.commons.math3.exception.MaxCountExceededException;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * The fastest motion of a mechanism's equations linearised at the start.
 *
 * <p>It is one of the eigenvalues of their Jacobian J, of which small mechanisms have all
 * decomposed. Of larger ones it is found by powers of J, which tell eigenvalues of nearly the same
 * modulus badly apart. A dominant pair of eigenvalues obeys λ² = a λ + b. The numbers a and b
 * follow by least squares from three successive powers x, J x, J² x, whether the pair is real or
 * complex (Wilkinson 1965, ch. 9); the pair is the spectrum of the companion matrix [a b; 1 0].
 * Least squares and spectrum are those of Commons Math.
 *
 * @param swings whether it oscillates
 * @param modulus |λ|, rad/s
 * @param real Re λ, 1/s
 * @param growth largest real part of the eigenvalues known that are at least half as fast, 1/s: a
 *     spring whose preload buckles it has λ and −λ, and does not decay
 * @param joint the joint with the largest velocity in it
 */
public record FastestMotion(
    boolean swings, double modulus, double real, double growth, Joint joint) {
  /** Smallest damping ratio at which a motion decays before a method must follow it. */
  private static final double DAMPED = 0.05;

  /** Part of the largest modulus from which another motion counts as fast, too. */
  private static final double FAST = 0.5;

  /**
   * Largest number of velocities of a scene that is examined: 62 evaluations of larger ones take
   * too long.
   */
  private static final int MOST_VELOCITIES = 1000;

  /**
   * Finds the fastest motion at the start of a run.
   *
   * @param settings settings of the run
   * @param start its closed start, asked for if the mechanism has loops
   * @return empty with user forces, with more than 1000 velocities, and if the equations have no
   *     derivative
   */
  public static Optional<FastestMotion> of(
      Mechanism mechanism, RunSettings settings, Supplier<ClosedStart> start) {
    boolean user = mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance);
    if (user || mechanism.velocityCount() == 0 || mechanism.velocityCount() > MOST_VELOCITIES) {
      return Optional.empty();
    }
    try {
      return new Linearised(mechanism, settings, start).fastest();
    } catch (IllegalArgumentException e) {
      // A mechanism that cannot be built is refused, with the reason, when the run starts.
      return Optional.empty();
    }
  }

  /** Returns whether the motion decays soon, so that an implicit method need not resolve it. */
  public boolean isDamped() {
    return growth < FAST * modulus && (!swings || -real > DAMPED * modulus);
  }

  /** Returns the motion in words, as a predicate. */
  public String text() {
    return swings
        ? String.format(
            Locale.ROOT,
            "swings with %.3g rad/s, %.1e of critically damped",
            modulus,
            Math.max(0, -real / modulus))
        : String.format(
            Locale.ROOT, "%s with %.3g 1/s", isDamped() ? "decays" : "moves away", modulus);
  }

  /** The equations linearised at the start. */
  private static final class Linearised {
    private static final int COUNT = 30;

    /** Largest number of states of which all eigenvalues are found: it takes some milliseconds. */
    private static final int MOST_DECOMPOSED = 60;

    /** Relative size of a difference: balances rounding against curvature. */
    private static final double DIFFERENCE = 1e-7;

    /** Below this sin² of their angle, two powers are parallel: one real eigenvalue alone. */
    private static final double PARALLEL = 1e-12;

    private final Mechanism mechanism;
    private final RunSettings settings;
    private final ExplicitModel model;
    private final double[] y;
    private final double[] moved;
    private final double[] slope;

    Linearised(Mechanism mechanism, RunSettings settings, Supplier<ClosedStart> start) {
      this.mechanism = mechanism;
      this.settings = settings;
      model =
          mechanism.closures().isEmpty()
              ? new DataDrivenModel(mechanism, settings)
              : new ProjectionModel(
                  new ClosedMechanism(mechanism, Formulation.DSR.label(), settings, start.get()),
                  UserForceSource.NONE);
      y = new double[model.description().stateCount()];
      moved = new double[y.length];
      slope = new double[y.length];
    }

    Optional<FastestMotion> fastest() {
      model.initialState(y);
      int[] free = IntStream.range(0, y.length).filter(this::isFree).toArray();
      return free.length <= MOST_DECOMPOSED ? ofAll(free) : ofPowers();
    }

    /** Finds all eigenvalues of J in the free components. */
    private Optional<FastestMotion> ofAll(int[] free) {
      int n = free.length;
      double[][] jacobian = new double[n][n];
      double[] x = new double[y.length];
      double[] image = new double[y.length];
      for (int column = 0; column < n; column++) {
        x[free[column]] = 1;
        if (!multiply(x, image)) {
          return Optional.empty();
        }
        x[free[column]] = 0;
        for (int row = 0; row < n; row++) {
          jacobian[row][column] = image[free[row]];
        }
      }
      double unit = inUnitsOfTime(jacobian, free);
      if (n == 0 || !Double.isFinite(unit)) {
        return Optional.empty();
      }
      EigenDecomposition all;
      try {
        all = new EigenDecomposition(new Array2DRowRealMatrix(jacobian, false));
      } catch (MaxCountExceededException | MathArithmeticException e) {
        return Optional.empty();
      }
      double[] real = all.getRealEigenvalues();
      double[] imaginary = all.getImagEigenvalues();
      int fastest = 0;
      for (int i = 1; i < n; i++) {
        boolean faster =
            Math.hypot(real[i], imaginary[i]) > Math.hypot(real[fastest], imaginary[fastest]);
        fastest = faster ? i : fastest;
      }
      double modulus = Math.hypot(real[fastest], imaginary[fastest]);
      boolean swings = imaginary[fastest] != 0;
      // A pair stands in two columns, real part and imaginary part.
      int first = swings && imaginary[fastest] < 0 ? fastest - 1 : fastest;
      RealVector shape = vector(x);
      for (int row = 0; row < n; row++) {
        double part = all.getV().getEntry(row, first);
        double other = swings ? all.getV().getEntry(row, first + 1) : 0;
        shape.setEntry(free[row], Math.hypot(part, other));
      }
      return Optional.of(
          new FastestMotion(
              swings,
              modulus * unit,
              real[fastest] * unit,
              growth(real, imaginary, modulus) * unit,
              jointOf(shape)));
    }

    /**
     * Takes time in a unit in which positions and velocities have the same size, so that the
     * decomposition loses no digits of a stiff spring, whose J has elements of λ² and 1.
     *
     * @return 1 / unit, 1/s
     */
    private double inUnitsOfTime(double[][] jacobian, int[] free) {
      double rate = 1;
      for (int row = 0; row < free.length; row++) {
        for (int column = 0; column < free.length; column++) {
          double size = Math.abs(jacobian[row][column]);
          boolean ofSpring = isVelocity(free[row]) && !isVelocity(free[column]);
          rate = Math.max(rate, ofSpring ? Math.sqrt(size) : size);
        }
      }
      for (int row = 0; row < free.length; row++) {
        for (int column = 0; column < free.length; column++) {
          boolean ofSpring = isVelocity(free[row]) && !isVelocity(free[column]);
          boolean ofMotion = !isVelocity(free[row]) && isVelocity(free[column]);
          jacobian[row][column] /= ofSpring ? rate * rate : ofMotion ? 1 : rate;
        }
      }
      return rate;
    }

    private boolean isVelocity(int component) {
      return component >= mechanism.positionCount()
          && component < mechanism.positionCount() + mechanism.velocityCount();
    }

    private Optional<FastestMotion> ofPowers() {
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
        double norm = vector(image).getNorm();
        for (int k = 0; k < x.length; k++) {
          x[k] = norm > 0 ? image[k] / norm : 0;
        }
      }
      return multiply(x, image) && multiply(image, second)
          ? judged(vector(x), vector(image), vector(second))
          : Optional.empty();
    }

    private static RealVector vector(double[] x) {
      return new ArrayRealVector(x, false);
    }

    private boolean isFree(int component) {
      return !(model instanceof DependentStates loops) || loops.independent(component);
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
      double t = settings.tStart();
      boolean closed = !(model instanceof DependentStates loops) || loops.complete(t, moved);
      return closed && model.derivative(t, moved, slope) == ExplicitModel.REGULAR;
    }

    /** Returns the motion of three powers x, J x and J² x; empty if their products overflow. */
    private Optional<FastestMotion> judged(RealVector x, RealVector image, RealVector second) {
      double[][] companion = {{image.dotProduct(x) / x.dotProduct(x), 0}, {1, 0}};
      double cosine = image.cosine(x);
      if (1 - cosine * cosine > PARALLEL) {
        RealMatrix powers = new Array2DRowRealMatrix(x.getDimension(), 2);
        powers.setColumnVector(0, image);
        powers.setColumnVector(1, x);
        companion[0] = new QRDecomposition(powers).getSolver().solve(second).toArray();
      }
      if (!Double.isFinite(companion[0][0]) || !Double.isFinite(companion[0][1])) {
        return Optional.empty();
      }
      EigenDecomposition pair = new EigenDecomposition(new Array2DRowRealMatrix(companion, false));
      double[] real = pair.getRealEigenvalues();
      double[] imaginary = pair.getImagEigenvalues();
      double modulus =
          Math.max(Math.hypot(real[0], imaginary[0]), Math.hypot(real[1], imaginary[1]));
      return Optional.of(
          new FastestMotion(
              pair.hasComplexEigenvalues(),
              modulus,
              Math.min(real[0], real[1]),
              growth(real, imaginary, modulus),
              jointOf(image)));
    }

    private static double growth(double[] real, double[] imaginary, double modulus) {
      double growth = Double.NEGATIVE_INFINITY;
      for (int i = 0; i < real.length; i++) {
        boolean fast = Math.hypot(real[i], imaginary[i]) >= FAST * modulus;
        growth = fast ? Math.max(growth, real[i]) : growth;
      }
      return growth;
    }

    /** Returns the joint with the largest velocity. */
    private Joint jointOf(RealVector image) {
      int positions = mechanism.positionCount();
      int largest = 0;
      for (int i = 0; i < mechanism.velocityCount(); i++) {
        if (Math.abs(image.getEntry(positions + i))
            > Math.abs(image.getEntry(positions + largest))) {
          largest = i;
        }
      }
      Joint found = mechanism.joints().get(0);
      for (int j = 0; j < mechanism.joints().size(); j++) {
        Joint joint = mechanism.joints().get(j);
        boolean moves = !mechanism.isDriven(j) && joint.type().velocityCount() > 0;
        if (moves && mechanism.velocityOffset(j) <= largest) {
          found = joint;
        }
      }
      return found;
    }
  }
}
