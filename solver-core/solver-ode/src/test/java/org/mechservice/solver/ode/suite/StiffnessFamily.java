package org.mechservice.solver.ode.suite;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Small problems that are stiff to a greater or lesser degree, or for a while: for methods that
 * change with stiffness.
 *
 * @param name what they have in common
 */
public record StiffnessFamily(String name, List<Member> members) {
  private static final double FAST = 1e5;

  /**
   * One problem.
   *
   * @param start at t = 0
   */
  @SuppressWarnings("ArrayRecordComponent") // compared by nobody
  public record Member(String name, FunctionOde ode, double[] start, double end) {}

  /** Returns all: 28 problems. */
  public static List<StiffnessFamily> all() {
    return List.of(
        new StiffnessFamily("rotation at 1e5, at rest, with decay", rotations(1)),
        new StiffnessFamily("rotation at 1e5, stirred up, with decay", rotations(1.1)),
        new StiffnessFamily("decay to a slow motion", decays()),
        new StiffnessFamily("Van der Pol", relaxations()),
        new StiffnessFamily("driven mass on a stiff damped spring", springs()));
  }

  /** Rotations about a circle that is followed slowly, from a point on it or off it. */
  private static List<Member> rotations(double start) {
    List<Member> members = new ArrayList<>();
    for (double decay : new double[] {1e2, 1e3, 1e4, 1e5, 1e6}) {
      FunctionOde ode =
          new FunctionOde(
              2,
              (t, y, yDot) -> {
                double x = y[0] - StrictMath.cos(t);
                double z = y[1] - StrictMath.sin(t);
                yDot[0] = -decay * x - FAST * z - StrictMath.sin(t);
                yDot[1] = FAST * x - decay * z + StrictMath.cos(t);
              });
      members.add(new Member(named(decay), ode, new double[] {start, 0}, 1));
    }
    return members;
  }

  private static List<Member> decays() {
    List<Member> members = new ArrayList<>();
    for (double rate : new double[] {1e2, 1e3, 1e4, 1e5, 1e6}) {
      FunctionOde ode =
          new FunctionOde(1, (t, y, yDot) -> yDot[0] = -rate * (y[0] - StrictMath.cos(t)));
      members.add(new Member(named(rate), ode, new double[] {0}, 10));
    }
    return members;
  }

  /** One period and a half. */
  private static List<Member> relaxations() {
    List<Member> members = new ArrayList<>();
    for (double mu : new double[] {10, 100, 1000, 1e4}) {
      FunctionOde ode =
          new FunctionOde(
              2,
              (t, y, yDot) -> {
                yDot[0] = y[1];
                yDot[1] = mu * (1 - y[0] * y[0]) * y[1] - y[0];
              });
      members.add(new Member(named(mu), ode, new double[] {2, 0}, 2.4 * mu));
    }
    return members;
  }

  /** Damping ratios of 0.1 and 1, and beyond. */
  private static List<Member> springs() {
    List<Member> members = new ArrayList<>();
    for (double stiffness : new double[] {1e4, 1e6, 1e8}) {
      for (double ratio : new double[] {0.1, 1, 10}) {
        double damping = 2 * ratio * Math.sqrt(stiffness);
        FunctionOde ode =
            new FunctionOde(
                2,
                (t, y, yDot) -> {
                  yDot[0] = y[1];
                  double apart = y[0] - StrictMath.sin(t);
                  yDot[1] = -stiffness * apart - damping * (y[1] - StrictMath.cos(t));
                });
        String name = named(stiffness) + ", damping ratio " + ratio;
        members.add(new Member(name, ode, new double[] {0.1, 0}, 5));
      }
    }
    return members;
  }

  private static String named(double value) {
    return String.format(Locale.ROOT, "%.0e", value);
  }
}
