package org.mechservice.sim.scene;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.api.DependentStates;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.ProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.UserForceSource;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.standalone.ShortestDecimal;

/**
 * Says before a run that an explicit integrator will need very many steps: the fastest motion of
 * the equations linearised at the start, by powers of their Jacobian, times the length of the run.
 *
 * <p>A dominant pair of eigenvalues obeys λ² = a λ + b. Of three successive powers x, J x, J² x the
 * numbers a and b follow by least squares, whether the pair is real or complex.
 */
public final class StiffnessForecast {
  /** Steps from which the user is told; a run of this length takes from seconds to minutes. */
  private static final double MANY_STEPS = 1e6;

  private static final Set<String> EXPLICIT = Set.of("ode113", "DE");

  /** Below this part of critical, a motion swings for so long that every method must follow it. */
  private static final double DAMPED = 0.05;

  private static final int POWERS = 30;

  /** Relative size of a difference: balances rounding against curvature. */
  private static final double DIFFERENCE = 1e-7;

  /** Loops of more velocities take longer to assemble than the forecast is worth. */
  private static final int MOST_VELOCITIES = 1000;

  private final Mechanism mechanism;
  private final RunSettings settings;
  private final ExplicitModel model;
  private final double[] y;
  private final double[] moved;
  private final double[] slope;

  private StiffnessForecast(Mechanism mechanism, RunSettings settings) {
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

  /**
   * Forecasts a run.
   *
   * @param settings of the run, with its integrator
   * @return what to tell the user; empty if the run needs no very many steps, if its integrator is
   *     implicit, or if nothing can be said: of user forces, or where the equations have no
   *     derivative
   */
  public static Optional<Finding> of(Mechanism mechanism, RunSettings settings) {
    boolean user = mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance);
    boolean forceless = mechanism.forces().isEmpty();
    if (!EXPLICIT.contains(settings.integrator())
        || user
        || forceless
        || mechanism.velocityCount() == 0
        || mechanism.velocityCount() > MOST_VELOCITIES) {
      return Optional.empty();
    }
    try {
      return new StiffnessForecast(mechanism, settings).finding();
    } catch (IllegalArgumentException e) {
      // What cannot be built is refused by name when a run is asked for.
      return Optional.empty();
    }
  }

  private Optional<Finding> finding() {
    model.initialState(y);
    double[] x = new double[y.length];
    for (int i = 0; i < x.length; i++) {
      x[i] = isFree(i) ? Math.sin(1.0 + i) : 0;
    }
    double[] image = new double[y.length];
    double[] second = new double[y.length];
    for (int i = 0; i < POWERS; i++) {
      if (!multiply(x, image)) {
        return Optional.empty();
      }
      normalise(image);
      System.arraycopy(image, 0, x, 0, x.length);
    }
    if (!multiply(x, image) || !multiply(image, second)) {
      return Optional.empty();
    }
    return judged(x, image, second);
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

  private Optional<Finding> judged(double[] x, double[] image, double[] second) {
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
    double steps = modulus * (settings.tEnd() - settings.tStart());
    return steps < MANY_STEPS
        ? Optional.empty()
        : Optional.of(finding(swings, modulus, real, steps, jointOf(image)));
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

  private Finding finding(boolean swings, double modulus, double real, double steps, Joint joint) {
    boolean damped = !swings || -real > DAMPED * modulus;
    String motion =
        swings
            ? String.format(
                Locale.ROOT,
                "swings with %.3g rad/s, %.1e of critically damped",
                modulus,
                Math.max(0, -real / modulus))
            : String.format(Locale.ROOT, "decays with %.3g 1/s", modulus);
    String advice =
        damped
            ? "use integrator \"auto\", \"ode15s\" or \"ode15sR\", whose steps such a motion does"
                + " not limit once it has died away"
            : "hardly damped, it has to be followed by every method as long as it is excited: give"
                + " it damping and use integrator \"auto\", lower the stiffness, or make the part"
                + " rigid";
    return new Finding(
        "N-019",
        String.format(
            Locale.ROOT,
            "joint \"%s\" moves too fast for integrator %s: at the start it %s; to %s s the run will"
                + " take some %.0e steps; %s",
            joint.name(),
            settings.integrator(),
            motion,
            ShortestDecimal.format(settings.tEnd()),
            steps,
            advice),
        joint.origin());
  }
}
