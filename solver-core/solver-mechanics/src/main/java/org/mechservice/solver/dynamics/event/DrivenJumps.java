package org.mechservice.solver.dynamics.event;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelEvents.Action;
import org.mechservice.solver.api.capability.ModelEvents.Direction;
import org.mechservice.solver.api.capability.ModelEvents.Kind;
import org.mechservice.solver.dynamics.SemiRecursive;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.MotionJump;

/**
 * The jumps of prescribed motions as events of a run. A jump of a position ends the run. A jump
 * Δv_d of a velocity changes the free velocities by the impulse of the drive,
 *
 * <pre>M_ff Δv_f = −M_fd Δv_d,</pre>
 *
 * <p>which is the change of least kinetic energy among all with Δv_d (Gauss's principle for
 * impulses). The loops are closed afterwards by the least change in the same metric, which gives
 * the change of least kinetic energy among those that the loops allow.
 *
 * <p>Each event function is the distance from the nearest jump of its joint, with a sign that
 * alternates from jump to jump.
 */
final class DrivenJumps {
  private final TreeMotion motion;
  private final SemiRecursive dynamics;
  private final List<Track> tracks = new ArrayList<>();
  private double wentOn = Double.NEGATIVE_INFINITY;
  private final double[] noForce;
  private final double[] held;
  private final double[] driven;

  /**
   * @param motion swept here
   * @param jumps of the run, in order of time
   */
  DrivenJumps(TreeMotion motion, List<MotionJump> jumps) {
    this.motion = motion;
    dynamics = new SemiRecursive(motion);
    noForce = new double[motion.tree().velocityCount];
    held = new double[motion.tree().stateVelocityCount];
    driven = new double[held.length];
    for (MotionJump jump : jumps) {
      Track track =
          tracks.stream()
              .filter(t -> t.holds(jump))
              .findFirst()
              .orElseGet(() -> new Track(new ArrayList<>()));
      if (track.jumps().isEmpty()) {
        tracks.add(track);
      }
      track.jumps().add(jump);
    }
  }

  /** The jumps of one coordinate or of its velocity, in order of time. */
  private record Track(List<MotionJump> jumps) {
    boolean holds(MotionJump jump) {
      MotionJump first = jumps.get(0);
      return first.joint().equals(jump.joint())
          && first.velocity() == jump.velocity()
          && first.ofPosition() == jump.ofPosition();
    }

    Kind kind() {
      MotionJump first = jumps.get(0);
      Action action = first.ofPosition() ? Action.BREAK : Action.IMPULSE;
      return new Kind(first.joint(), Direction.BOTH, action);
    }

    /** Returns the number of jumps before the present time. */
    int passed(double t) {
      int low = 0;
      int high = jumps.size();
      while (low < high) {
        int middle = (low + high) >>> 1;
        if (jumps.get(middle).time() <= t) {
          low = middle + 1;
        } else {
          high = middle;
        }
      }
      return low;
    }

    double distance(double t) {
      int passed = passed(t);
      double sinceLast = passed == 0 ? Double.MAX_VALUE : t - jumps.get(passed - 1).time();
      double toNext = passed == jumps.size() ? Double.MAX_VALUE : jumps.get(passed).time() - t;
      double nearest = Math.min(sinceLast, toNext);
      return passed % 2 == 0 ? -nearest : nearest;
    }

    MotionJump nearest(double t) {
      int passed = passed(t);
      boolean next = passed == 0 || (passed < jumps.size() && jumps.get(passed).ahead() <= t);
      return jumps.get(next ? passed : passed - 1);
    }

    MotionJump latest(double t) {
      return jumps.get(Math.max(0, passed(t) - 1));
    }
  }

  List<Kind> kinds() {
    return tracks.stream().map(Track::kind).toList();
  }

  /** Writes one function per kind from {@code at}. */
  void values(double t, double[] g, int at) {
    for (int i = 0; i < tracks.size(); i++) {
      g[at + i] = tracks.get(i).distance(t);
    }
  }

  /** Records that the run continues from a time, after the jumps up to it have been applied. */
  void continueFrom(double t) {
    wentOn = t;
  }

  /**
   * Returns a time on one side of the jump at {@code t}: after the jump once it has been applied,
   * before it until then; {@code t} itself away from jumps.
   */
  double evaluationTime(double t) {
    double beside = t;
    for (Track track : tracks) {
      MotionJump nearest = track.nearest(t);
      if (t > nearest.ahead() && t < nearest.behind()) {
        beside = wentOn >= nearest.time() ? nearest.behind() : nearest.ahead();
      }
    }
    return beside;
  }

  /** Returns the first time after the jumps that have occurred; {@code t} if there is none. */
  double after(boolean[] occurred, int at, double t) {
    double after = t;
    for (int i = 0; i < tracks.size(); i++) {
      if (occurred[at + i]) {
        after = Math.max(after, tracks.get(i).latest(t).behind());
      }
    }
    return after;
  }

  /**
   * Changes free velocities by the impulses of jumps of driven ones; sets NaN if one has no
   * inertia.
   *
   * @param at index of the first jump in {@code occurred}
   */
  void change(boolean[] occurred, int at, double t, double[] y) {
    int free = held.length;
    double[] jump = new double[noForce.length];
    boolean any = false;
    for (int i = 0; i < tracks.size(); i++) {
      MotionJump latest = tracks.get(i).latest(t);
      if (occurred[at + i] && !latest.ofPosition() && latest.velocity() >= 0) {
        jump[free + latest.velocity()] = latest.size();
        any = true;
      }
    }
    if (!any) {
      return;
    }
    motion.sweep(t, y);
    Arrays.fill(motion.a, free, noForce.length, 0);
    boolean regular = accelerate(held);
    System.arraycopy(jump, free, motion.a, free, noForce.length - free);
    regular &= accelerate(driven);
    int nq = motion.tree().statePositionCount;
    for (int k = 0; k < free; k++) {
      y[nq + k] += regular ? driven[k] - held[k] : Double.NaN;
    }
  }

  private boolean accelerate(double[] a) {
    return dynamics.accelerations(noForce, a) == ExplicitModel.REGULAR;
  }
}
