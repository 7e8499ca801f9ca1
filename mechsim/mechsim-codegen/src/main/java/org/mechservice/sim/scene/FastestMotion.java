package org.mechservice.sim.scene;

import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.DependentStates;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.UserForceElement;

/**
 * The fastest motion of a mechanism's equations linearised at the start, found by powers of their
 * Jacobian.
 *
 * <p>A dominant pair of eigenvalues obeys λ² = a λ + b. Of three successive powers x, J x, J² x the
 * numbers a and b follow by least squares, whether the pair is real or complex.
 *
 * @param swings whether it oscillates
 * @param modulus |λ|, rad/s
 * @param real Re λ, 1/s
 * @param joint whose velocity takes part in it most
 */
record FastestMotion(boolean swings, double modulus, double real, Joint joint) {
  /** Below this part of critical, a motion swings for so long that every method must follow it. */
  private static final double DAMPED = 0.05;

  /** Loops of more velocities take longer to assemble than the spectrum is worth. */
  private static final int MOST_VELOCITIES = 1000;

  /**
   * Finds it.
   *
   * @param settings of the run: its start
   * @return empty if nothing can be said: of user forces, or where the equations have no derivative
   */
  static Optional<FastestMotion> of(Mechanism mechanism, RunSettings settings) {
    boolean user = mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance);
    if (user || mechanism.velocityCount() == 0 || mechanism.velocityCount() > MOST_VELOCITIES) {
      return Optional.empty();
    }
    try {
      return new Powers(mechanism, settings).found();
    } catch (IllegalArgumentException e) {
      // What cannot be built is refused by name when a run is asked for.
      return Optional.empty();
    }
  }

  /** Returns whether it dies away soon, so that an implicit method need not follow it. */
  boolean isDamped() {
    return !swings || -real > DAMPED * modulus;
  }

  /** Says how it moves, as a predicate. */
  String text() {
    return swings
        ? String.format(
            Locale.ROOT,
            "swings with %.3g rad/s, %.1e of critically damped",
            modulus,
            Math.max(0, -real / modulus))
        : String.format(Locale.ROOT, "decays with %.3g 1/s", modulus);
  }

  /** Powers of the Jacobian at the start. */
  private static final class Powers {
    private static final int COUNT = 30;

    /** Relative size of a difference: balances rounding against curvature. */
    private static final double DIFFERENCE = 1e-7;

    private final Mechanism mechanism;
    private final RunSettings settings;
    private final ExplicitModel model;
    private final double[] y;
    private final double[] moved;
    private final double[] slope;

    Powers(Mechanism mechanism, RunSettings settings) {
      this.mechanism = mechanism;
      this.settings = settings;
      model =
          mechanism.closures().isEmpty()
              ? new DataDrivenModel(mechanism, settings)
              : new ProjectionModel(
                  new ClosedMechanism(mechanism, "DSR", settings), UserForceSource.NONE);
      y = new double[model.description().stateCount()];
      moved = new double[y.length];
      slope = new double[y.length];
    }

    Optional<FastestMotion> found() {
      model.initialState(y);
      double[] x = new double[y.length];
      for (int i = 0; i < x.length; i++) {
        // Strictly the same start on every machine: what is chosen by it must not differ.
        x[i] = isFree(i) ? StrictMath.sin(1.0 + i) : 0;
      }
      double[] image = new double[y.length];
      double[] second = new double[y.length];
      for (int i = 0; i < COUNT; i++) {
        if (!multiply(x, image)) {
          return Optional.empty();
        }
        normalise(image);
        System.arraycopy(image, 0, x, 0, x.length);
      }
      return multiply(x, image) && multiply(image, second)
          ? Optional.of(judged(x, image, second))
          : Optional.empty();
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

    private static void normalise(double[] x) {
      double square = 0;
      for (double element : x) {
        square += element * element;
      }
      double factor = square > 0 ? 1 / Math.sqrt(square) : 0;
      for (int i = 0; i < x.length; i++) {
        x[i] *= factor;
      }
    }

    private FastestMotion judged(double[] x, double[] image, double[] second) {
      double xx = dot(x, x);
      double xz = dot(x, image);
      double zz = dot(image, image);
      double xw = dot(x, second);
      double zw = dot(image, second);
      double determinant = xx * zz - xz * xz;
      double a = xz / xx;
      double b = 0;
      // Parallel images: one real eigenvalue alone.
      if (determinant > 1e-12 * xx * zz) {
        a = (xx * zw - xz * xw) / determinant;
        b = (zz * xw - xz * zw) / determinant;
      }
      double discriminant = a * a / 4 + b;
      boolean swings = discriminant < 0;
      double real = swings ? a / 2 : a / 2 - Math.sqrt(discriminant);
      double modulus =
          swings ? Math.sqrt(-b) : Math.abs(a / 2) + Math.sqrt(Math.max(0, discriminant));
      return new FastestMotion(swings, modulus, real, jointOf(image));
    }

    private static double dot(double[] a, double[] b) {
      double sum = 0;
      for (int i = 0; i < a.length; i++) {
        sum += a[i] * b[i];
      }
      return sum;
    }

    /** The joint whose velocity takes part most. */
    private Joint jointOf(double[] image) {
      int positions = mechanism.positionCount();
      int largest = 0;
      for (int i = 0; i < mechanism.velocityCount(); i++) {
        if (Math.abs(image[positions + i]) > Math.abs(image[positions + largest])) {
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
