package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.solver.api.JointType.C;
import static org.mechservice.solver.api.JointType.P;
import static org.mechservice.solver.api.JointType.R;
import static org.mechservice.solver.api.JointType.S;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.Linkages.Hinge;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Spatial linkages of the textbooks, some of which move only because of their proportions. */
class SpatialLinkagesTest {
  private static final double END = 0.6;

  /** Bodies and hinges that form a ring, and the degrees of freedom that it has. */
  private record Linkage(String name, List<Body> bodies, List<Hinge> hinges, int freedom) {
    Mechanism cutAt(int hinge) {
      return Linkages.ring(name, bodies, hinges, hinge);
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** A ring of bars between points, with hinges of given types and axes there. */
  private static Linkage ring(
      String name, List<JointType> types, List<Vector3> points, List<Vector3> axes, int freedom) {
    List<Body> bars = new ArrayList<>();
    List<Hinge> hinges = new ArrayList<>();
    int last = points.size() - 1;
    for (int i = 0; i <= last; i++) {
      if (i < last) {
        bars.add(Linkages.bar("bar" + i, points.get(i), points.get(i + 1), 1 + 0.3 * i));
      }
      int after = i < last ? i : -1;
      hinges.add(new Hinge("h" + i, types.get(i), i - 1, after, points.get(i), axes.get(i)));
    }
    return new Linkage(name, bars, hinges, freedom);
  }

  /**
   * Four hinges that are neither parallel nor meet: opposite bars are alike, and sin α / a = sin β
   * / b (Bennett 1903).
   */
  private static Linkage bennett() {
    double a = 1;
    double alpha = 0.6;
    double beta = 1.2;
    double b = a * Math.sin(beta) / Math.sin(alpha);
    double first = 1.1;
    double second =
        2
            * Math.atan(
                Math.sin((beta + alpha) / 2)
                    / (Math.sin((beta - alpha) / 2) * Math.tan(first / 2)));
    double[] angle = {first, second, -first, -second};
    double[] length = {a, b, a, b};
    double[] twist = {alpha, beta, alpha, beta};
    List<Vector3> points = new ArrayList<>();
    List<Vector3> axes = new ArrayList<>();
    Rotation axesOfLink = Rotation.IDENTITY;
    Vector3 place = Vector3.ZERO;
    for (int i = 0; i < 4; i++) {
      points.add(place);
      axes.add(axesOfLink.apply(Linkages.Z));
      axesOfLink = axesOfLink.times(Rotation.about(Linkages.Z, angle[i]));
      place = place.plus(axesOfLink.apply(Linkages.X).times(length[i]));
      axesOfLink = axesOfLink.times(Rotation.about(Linkages.X, twist[i]));
    }
    assertThat(place.norm()).isLessThan(1e-14);
    return ring("Bennett", List.of(R, R, R, R), points, axes, 1);
  }

  private static Vector3 v(double x, double y, double z) {
    return new Vector3(x, y, z);
  }

  /** Crank, coupler with two balls that may spin, rocker. */
  private static Linkage crankAndBalls() {
    return ring(
        "RSSR",
        List.of(R, S, S, R),
        List.of(v(0, 0, 0), v(0.3, 0.2, 0.1), v(1.1, 0.9, 0.7), v(1.2, 0, 0)),
        List.of(v(0, 0, 1), v(1, 0, 0), v(1, 0, 0), v(0, 1, 0)),
        2);
  }

  /** Two Hooke joints, each with a cross of its own, between shafts in one plane. */
  private static Linkage hookeJoints() {
    double c = Math.cos(0.4);
    double s = Math.sin(0.4);
    return ring(
        "two Hooke joints",
        List.of(R, R, R, R, R, C),
        List.of(
            v(0, 0, 0),
            v(0.5, 0, 0),
            v(0.5, 0, 0.001),
            v(0.5 + c, s, 0),
            v(0.5 + c, s, 0.001),
            v(1 + c, s, 0)),
        List.of(v(1, 0, 0), v(0, 1, 0), v(0, 0, 1), v(0, 0, 1), v(-s, c, 0), v(c, s, 0)),
        1);
  }

  /** A slide whose way and crank are askew. */
  private static Linkage skewSlider() {
    return ring(
        "RSCP",
        List.of(R, S, C, P),
        List.of(v(0, 0, 0), v(0.2, 0.3, 0), v(1, 0.1, 0.4), v(1, 0.1, 0.4)),
        List.of(v(0, 0.6, 0.8), v(1, 0, 0), v(0, 1, 0), v(1, 0, 0)),
        1);
  }

  static Stream<Arguments> linkagesAndCuts() {
    return Stream.of(bennett(), crankAndBalls(), hookeJoints(), skewSlider())
        .flatMap(
            linkage ->
                Stream.iterate(0, cut -> cut + 1)
                    .limit(linkage.hinges().size())
                    .map(cut -> Arguments.of(linkage, cut)));
  }

  @MethodSource("linkagesAndCuts")
  @ParameterizedTest
  void accelerationsAreThoseOfMaximalCoordinatesWhereverItIsCut(Linkage linkage, int cut) {
    Mechanism mechanism = linkage.cutAt(cut);
    assertThat(LoopComparison.leftOut(mechanism)).isEmpty();
    LoopComparison compared = LoopComparison.of(mechanism);
    assertThat(compared.freedom()).isEqualTo(linkage.freedom());
    compared
        .forward()
        .forEach(
            (formulation, error) ->
                assertThat(error).as(formulation).isLessThan(compared.forwardBound()));
    assertThat(compared.missing()).isLessThan(LoopComparison.MISSING);
  }

  static Stream<Arguments> linkagesAndMethods() {
    return Stream.of(bennett(), crankAndBalls(), hookeJoints(), skewSlider())
        .flatMap(
            linkage ->
                Stream.of(
                    Arguments.of(linkage, "DSR", "DE", 1e-9),
                    Arguments.of(linkage, "DSR", "ode15s", 1e-8),
                    Arguments.of(linkage, "DSR penalty", "ode113", 1e-9),
                    Arguments.of(linkage, "RR", "ode15sR", 1e-8),
                    Arguments.of(linkage, "RR-JF", "ode15sR", 1e-8),
                    Arguments.of(linkage, "RR penalty", "ode15sR", 1e-7),
                    Arguments.of(linkage, "RR-JF penalty", "ode15sR", 1e-7)));
  }

  /** Errors of integration grow with the motion; a thousand tolerances is what references allow. */
  @MethodSource("linkagesAndMethods")
  @ParameterizedTest
  void movesTheSameInEveryFormulation(
      Linkage linkage, String formulation, String integrator, double tolerance) {
    Mechanism mechanism = linkage.cutAt(linkage.hinges().size() - 1);
    double[] expected = last(mechanism, "DSR", "ode113", 1e-11);
    double[] actual = last(mechanism, formulation, integrator, tolerance);
    for (int i = 0; i < mechanism.positionCount(); i++) {
      assertThat(actual[1 + i])
          .as("position %s", i)
          .isCloseTo(expected[1 + i], within(1000 * tolerance * (1 + Math.abs(expected[1 + i]))));
    }
  }

  /**
   * Its four hinges lie so that three of the six equations repeat the others, on the loop alone.
   */
  @ValueSource(strings = {"RR penalty", "RR-JF penalty"})
  @ParameterizedTest
  void equationsThatRepeatOthersCostNoShortSteps(String formulation) {
    Mechanism mechanism = bennett().cutAt(3);
    // 272; before they were left out, the run came to a standstill.
    assertThat(steps(mechanism, formulation)).isLessThan(2 * steps(mechanism, "DSR penalty"));
  }

  private static long steps(Mechanism mechanism, String formulation) {
    SceneRun run = LoopModels.run(mechanism, formulation, SceneRun.settings(4, 4, "ode15sR", 1e-6));
    assertThat(run.report.outcome()).isEqualTo(new Outcome.Completed());
    return run.report.steps();
  }

  private static double[] last(
      Mechanism mechanism, String formulation, String integrator, double tolerance) {
    SceneRun run =
        LoopModels.run(mechanism, formulation, SceneRun.settings(END, END, integrator, tolerance));
    assertThat(run.report.outcome()).isEqualTo(new Outcome.Completed());
    return run.at(END);
  }
}
