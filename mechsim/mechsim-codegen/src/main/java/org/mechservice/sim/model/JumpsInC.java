package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
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

  private JumpsInC() {}

  private static double end(RunSettings run) {
    return run.tStart() + RUNS * (run.tEnd() - run.tStart());
  }

  /** Returns the times after the start, ascending. */
  static List<Double> times(Mechanism mechanism, RunSettings run) {
    return mechanism.timeJumps(run.tStart(), end(run)).stream()
        .filter(time -> time > run.tStart())
        .toList();
  }

  /** Returns what cannot be exported, in words. */
  static List<String> notExported(Mechanism mechanism, RunSettings run) {
    List<String> beyond = new ArrayList<>();
    if (!mechanism.mayJump()) {
      return beyond;
    }
    for (MotionJump jump : mechanism.motionJumps(run.tStart(), run.tEnd())) {
      beyond.add(
          "a prescribed "
              + (jump.ofPosition() ? "position" : "velocity")
              + " that jumps (joint \""
              + jump.joint()
              + "\" at "
              + jump.time()
              + " s)");
    }
    List<Double> times = times(mechanism, run);
    double[] values = mechanism.parameters().stream().mapToDouble(Parameter::value).toArray();
    for (int i = 0; i < values.length; i++) {
      double[] other = values.clone();
      other[i] += CHANGE * Math.max(1, Math.abs(values[i]));
      if (!times(mechanism.with(other), run).equals(times)) {
        beyond.add(
            "times of jumps that depend on the tunable parameter \""
                + mechanism.parameters().get(i).name()
                + "\"");
      }
    }
    return beyond;
  }
}
