package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.equations.PrescribedPairMotion;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;

/**
 * Finds, after a failure, a function of time with an unbounded second derivative near the last
 * attempted steps. The motion √(1 − t) is an example: near t = 1 s no step is short enough, and the
 * state that the error test names merely follows the prescribed motion. Allocates memory; not for
 * use within a step.
 */
public final class PrescribedMotions {
  /** Acceleration in SI units below which a motion is regarded as regular. */
  private static final double LARGE = 1e6;

  /**
   * Relative change of an acceleration between neighbouring times that shows a singularity;
   * rounding causes 1e-15, a vibration of 1e6 rad/s after 10 s causes 1e-8.
   */
  private static final double NOTICEABLE = 1e-7;

  /** Distance of neighbouring times in units in the last place; the shortest steps are as long. */
  private static final double SPACINGS = 16;

  private final ClosedTree work;
  private final double[] atRest;

  private PrescribedMotions(ClosedTree work, double[] y) {
    this.work = work;
    atRest = y.clone();
    Arrays.fill(atRest, work.nq, work.nq + work.nv, 0);
  }

  /**
   * Returns the defect of a prescribed function that has no bounded acceleration near the end of a
   * run.
   *
   * @param t time that the run has reached, s
   * @param y state [q; v] there; not modified
   * @param tried the last steps
   */
  public static Optional<Defect> breakOff(
      ClosedTree work, double t, double[] y, List<Failure.Step> tried) {
    return new PrescribedMotions(work, y).search(t, tried);
  }

  private Optional<Defect> search(double t, List<Failure.Step> tried) {
    List<Double> times = new ArrayList<>(List.of(t));
    tried.forEach(step -> times.add(step.time()));
    Optional<Defect> found = Optional.empty();
    for (double time : times) {
      found = found.isPresent() ? found : ofJoints(time).or(() -> ofRelations(time));
    }
    return found;
  }

  /** Checks the driven coordinates of tree joints and cut joints. */
  private Optional<Defect> ofJoints(double t) {
    for (PrescribedMotion motion : work.tree.mechanism().motions()) {
      String joint = work.tree.mechanism().joints().get(motion.joint()).name();
      if (breaksOff(motion.coordinates(), t)) {
        return Optional.of(defect("drive of joint \"" + joint + "\"", t));
      }
    }
    for (int row = 0; row < work.loops.count(); row++) {
      if (work.loops.closure(row) instanceof JointClosure cut
          && !cut.motion().isEmpty()
          && breaksOff(cut.motion(), t)) {
        return Optional.of(defect("drive of joint \"" + cut.name() + "\"", t));
      }
    }
    return Optional.empty();
  }

  private boolean breaksOff(List<Expression> coordinates, double t) {
    PrescribedPairMotion motion = new PrescribedPairMotion(coordinates, work.loops.parameters());
    double[] here = new double[motion.count()];
    motion.evaluate(t);
    for (int i = 0; i < here.length; i++) {
      here[i] = motion.acceleration(i);
    }
    motion.evaluate(next(t));
    boolean any = false;
    for (int i = 0; i < here.length; i++) {
      any |= breaksOff(here[i], motion.acceleration(i));
    }
    return any;
  }

  /**
   * Checks couplings between coordinates and time with the mechanism at rest, where Φ'' equals
   * Φ_tt.
   */
  private Optional<Defect> ofRelations(double t) {
    double[] here = accelerations(t);
    double[] there = accelerations(next(t));
    for (int row = 0; row < here.length; row++) {
      boolean ofTime =
          work.loops.closure(row) instanceof CoordinateClosure relation
              && new Tape(List.of(relation.relation()))
                  .leaves().stream().anyMatch(Expression.Time.class::isInstance);
      if (ofTime && breaksOff(here[row], there[row])) {
        return Optional.of(defect(work.loops.name(row), t));
      }
    }
    return Optional.empty();
  }

  private double[] accelerations(double t) {
    work.placeData(t, atRest);
    work.formDataGamma(t);
    return work.loops.acceleration.clone();
  }

  private static double next(double t) {
    return t + SPACINGS * Math.ulp(t);
  }

  private static boolean breaksOff(double here, double there) {
    double size = Math.max(Math.abs(here), Math.abs(there));
    return !(size < LARGE) && !(Math.abs(there - here) <= NOTICEABLE * size);
  }

  private static Defect defect(String part, double t) {
    return new Defect(
        MessageCode.STEP_TOO_SMALL,
        part,
        String.format(
            Locale.ROOT,
            "No step is short enough: the acceleration that this prescribes as a function of time"
                + " has no bound near t = %.6g s.",
            t),
        "Write a motion whose velocity and acceleration stay finite, such as smoothStep, or end the"
            + " run before.");
  }
}
