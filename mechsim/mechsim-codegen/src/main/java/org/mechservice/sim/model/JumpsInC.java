package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.mechservice.sim.emit.c.CEvents;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.MotionJump;
import org.mechservice.solver.mechanism.Parameter;

/** The times at which equations in C jump, which are written into the code as numbers. */
final class JumpsInC {
  /** How many times the length of the file's run the times are known for. */
  private static final int RUNS = 10;

  /** Relative change of a parameter by which its influence on the times is seen. */
  private static final double CHANGE = 1e-3;

  /** Units in the last place between times that are one. */
  private static final double MARGIN = 8;

  /** Most free velocities whose change by an impulse is solved for in C, on the stack. */
  private static final int MOST_PUSHED = 100;

  private JumpsInC() {}

  private static double end(RunSettings run) {
    return run.tStart() + RUNS * (run.tEnd() - run.tStart());
  }

  /** Returns the jumps after the start, ascending. */
  static List<CEvents.Jump> of(Mechanism mechanism, RunSettings run) {
    List<CEvents.Jump> jumps = new ArrayList<>();
    for (MotionJump jump : motionJumps(mechanism, run)) {
      jumps.add(new CEvents.Jump(jump.time(), true));
    }
    for (double time : mechanism.timeJumps(run.tStart(), end(run))) {
      if (time > run.tStart() && jumps.stream().noneMatch(jump -> isSame(jump.time(), time))) {
        jumps.add(new CEvents.Jump(time, false));
      }
    }
    jumps.sort(Comparator.comparingDouble(CEvents.Jump::time));
    return jumps;
  }

  /** Returns the jumps of prescribed motions, sought in each of the runs by itself. */
  private static List<MotionJump> motionJumps(Mechanism mechanism, RunSettings run) {
    double length = run.tEnd() - run.tStart();
    List<MotionJump> jumps = new ArrayList<>();
    for (int i = 0; i < RUNS && mechanism.mayJump(); i++) {
      double from = run.tStart() + i * length;
      for (MotionJump jump : mechanism.motionJumps(from, from + length)) {
        if (jump.time() > run.tStart()
            && jumps.stream().noneMatch(other -> isSame(other.time(), jump.time()))) {
          jumps.add(jump);
        }
      }
    }
    return jumps;
  }

  private static boolean isSame(double one, double other) {
    return Math.abs(one - other) <= MARGIN * Math.ulp(one);
  }

  private static List<Double> times(Mechanism mechanism, RunSettings run) {
    return of(mechanism, run).stream().map(CEvents.Jump::time).toList();
  }

  /** Returns what cannot be exported, in words. */
  static List<String> notExported(Mechanism mechanism, RunSettings run) {
    List<String> beyond = new ArrayList<>();
    if (!mechanism.mayJump()) {
      return beyond;
    }
    for (MotionJump jump : motionJumps(mechanism, run)) {
      if (!jump.ofPosition() && !jump.roundedAway()) {
        continue;
      }
      beyond.add(
          "a prescribed "
              + (jump.ofPosition() ? "position" : "velocity")
              + " that jumps so that no mechanism can follow (joint \""
              + jump.joint()
              + "\" at "
              + jump.time()
              + " s)");
    }
    if (mechanism.velocityCount() > MOST_PUSHED && !motionJumps(mechanism, run).isEmpty()) {
      beyond.add(
          "prescribed velocities that jump beside more than " + MOST_PUSHED + " free velocities");
    }
    List<Double> times = times(mechanism, run);
    double[] values = mechanism.parameters().stream().mapToDouble(Parameter::value).toArray();
    for (int i = 0; i < values.length; i++) {
      double[] other = values.clone();
      other[i] += CHANGE * Math.max(1, Math.abs(values[i]));
      if (!times(mechanism.with(other), run).equals(times)) {
        beyond.add(
            "times of jumps that depend on the tunable parameter or input \""
                + mechanism.parameters().get(i).name()
                + "\"");
      }
    }
    return beyond;
  }
}
