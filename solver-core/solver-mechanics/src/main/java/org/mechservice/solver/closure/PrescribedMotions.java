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
 * Looks after a failure for what is prescribed as a function of time and has no finite acceleration
 * where the last steps tried to go, as the motion √(1 − t) has none at t = 1 s: no step leads there
 * however short it is, and the state that an error test names is one that had to follow. Allocates
 * freely.
 */
public final class PrescribedMotions {
  /** Accelerations below this, in SI units, are not those of a motion that comes to its end. */
  private static final double LARGE = 1e6;

  /**
   * Relative change between times next to each other: rounding makes 1e-15, a vibration of 1e6
   * rad/s makes 1e-8 after 10 s.
   */
  private static final double NOTICEABLE = 1e-7;

  /** Times next to each other are apart by as many of their spacings, as the shortest steps are. */
  private static final double SPACINGS = 16;

  private final ClosedTree work;
  private final double[] atRest;

  private PrescribedMotions(ClosedTree work, double[] y) {
    this.work = work;
    atRest = y.clone();
    Arrays.fill(atRest, work.nq, work.nq + work.nv, 0);
  }

  /**
   * Returns what is prescribed and breaks off near the end of a run, if anything is.
   *
   * @param t time the run stands at, s
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

  /** Looks at the coordinates of joints that are driven, in the tree and where it is cut. */
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

  /** Looks at relations between coordinates and time while the mechanism rests: Φ'' is Φ_tt. */
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
