package org.mechservice.sim.scene.forecast;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Warns before a run if formulas of time accelerate a joint only during a short pulse. An
 * integrator that chooses its steps cannot foresee such a pulse, and a long step may skip it.
 *
 * <p>The accelerations at the start state are evaluated at many times. Pulses that begin or end
 * with {@code step} or {@code floor} are not reported: their times are known, and steps end there.
 * The acceleration of a driven joint counts as the cause of a pulse.
 */
public final class ShortPulseCheck {
  /** Number of times that are sampled; fewer if a sample is expensive. */
  private static final int SAMPLES = 20_000;

  private static final int COST = 200_000;

  /** Deviation from the median, as a fraction of the range, above which a joint is in a pulse. */
  private static final double PUSHED = 0.05;

  /** Fraction of the run above which a pulse is long enough for an integrator to notice. */
  private static final double SHORT = 0.02;

  private final Mechanism mechanism;
  private final RunSettings settings;
  private final double[] times;

  private ShortPulseCheck(Mechanism mechanism, RunSettings settings) {
    this.mechanism = mechanism;
    this.settings = settings;
    times = new double[Math.min(SAMPLES, COST / mechanism.velocityCount())];
    double length = settings.tEnd() - settings.tStart();
    for (int i = 0; i < times.length; i++) {
      times[i] = settings.tStart() + length * i / (times.length - 1.0);
    }
  }

  /**
   * Finds a short pulse.
   *
   * @param settings settings of the run: start, end and largest step
   * @return the warning; empty if there is no short pulse, or the largest step is shorter than it.
   *     User forces are not examined
   */
  public static Optional<Finding> of(Mechanism mechanism, RunSettings settings) {
    boolean user = mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance);
    boolean timed = formulas(mechanism).anyMatch(ShortPulseCheck::dependsOnTime);
    if (user
        || !timed
        || mechanism.velocityCount() == 0
        || mechanism.velocityCount() > COST / 100
        || !(settings.tEnd() > settings.tStart())) {
      return Optional.empty();
    }
    try {
      return new ShortPulseCheck(opened(mechanism), settings).found();
    } catch (IllegalArgumentException e) {
      // A mechanism that cannot be built is refused, with the reason, when the run starts.
      return Optional.empty();
    }
  }

  private static Stream<Expression> formulas(Mechanism mechanism) {
    return Stream.concat(
        mechanism.forces().stream().flatMap(ShortPulseCheck::formulas),
        mechanism.motions().stream().flatMap(motion -> motion.coordinates().stream()));
  }

  /** Returns the tree without closures; a pulse acts in it as well as in closed loops. */
  private static Mechanism opened(Mechanism closed) {
    Mechanism open =
        new Mechanism(
            closed.name(),
            closed.root(),
            closed.gravity(),
            closed.bodies(),
            closed.joints(),
            closed.motions(),
            closed.startRoles(),
            List.of(),
            closed.forces(),
            closed.parameters());
    return open.withFurtherStates(closed.furtherStates());
  }

  /** Returns the formulas of a force. */
  static Stream<Expression> formulas(ForceElement force) {
    return force.formulas().stream().map(ForceElement.Formula::expression);
  }

  private static boolean dependsOnTime(Expression formula) {
    return parts(formula).stream().anyMatch(Time.class::isInstance);
  }

  /** Returns an expression and all of its parts, each object once: formulas may share parts. */
  static Set<Expression> parts(Expression formula) {
    Set<Expression> parts = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<Expression> open = new ArrayDeque<>(List.of(formula));
    while (!open.isEmpty()) {
      Expression next = open.pop();
      if (parts.add(next)) {
        open.addAll(Expression.operands(next));
      }
    }
    return parts;
  }

  private Optional<Finding> found() {
    DataDrivenModel model = new DataDrivenModel(mechanism, settings);
    int nq = mechanism.positionCount();
    double[][] acceleration = new double[mechanism.velocityCount()][times.length];
    double[] y = new double[model.description().stateCount()];
    double[] yDot = new double[y.length];
    model.initialState(y);
    for (int i = 0; i < times.length; i++) {
      if (model.derivative(times[i], y, yDot) != ExplicitModel.REGULAR) {
        return Optional.empty();
      }
      for (int k = 0; k < acceleration.length; k++) {
        acceleration[k][i] = yDot[nq + k];
      }
    }
    for (int k = 0; k < acceleration.length; k++) {
      Optional<Finding> brief = brief(acceleration[k], k);
      if (brief.isPresent()) {
        return brief;
      }
    }
    return Optional.empty();
  }

  private Optional<Finding> brief(double[] a, int velocity) {
    double[] sorted = a.clone();
    Arrays.sort(sorted);
    double middle = sorted[sorted.length / 2];
    double range = sorted[sorted.length - 1] - sorted[0];
    if (!(range > 1e-9 * (1 + Math.abs(middle)))) {
      return Optional.empty();
    }
    int count = 0;
    int first = -1;
    int last = -1;
    for (int i = 0; i < a.length; i++) {
      if (Math.abs(a[i] - middle) > PUSHED * range) {
        first = first < 0 ? i : first;
        last = i;
        count++;
      }
    }
    double step = (settings.tEnd() - settings.tStart()) / (a.length - 1.0);
    double lasts = count * step;
    double from = times[Math.max(0, first - 1)];
    double to = times[Math.min(times.length - 1, last + 1)];
    boolean bounded = settings.maxStep() <= lasts;
    return count > SHORT * a.length || bounded || !mechanism.timeJumps(from, to).isEmpty()
        ? Optional.empty()
        : Optional.of(finding(velocity, times[first], lasts));
  }

  private Finding finding(int velocity, double at, double lasts) {
    Joint joint = mechanism.joints().get(0);
    for (int j = 0; j < mechanism.joints().size(); j++) {
      boolean moves =
          !mechanism.isDriven(j) && mechanism.joints().get(j).type().velocityCount() > 0;
      if (moves && mechanism.velocityOffset(j) <= velocity) {
        joint = mechanism.joints().get(j);
      }
    }
    return new Finding(
        MessageCode.SHORT_PULSE,
        String.format(
            Locale.ROOT,
            "a formula of time pushes joint \"%s\" for some %.1e s only, first at t = %.6g s; a"
                + " long step of the integrator may pass over it: give the integrator a maxStep of"
                + " %.1e s, or begin and end the push with step(), whose times are known",
            joint.name(),
            lasts,
            at,
            lasts / 2),
        joint.origin());
  }
}
