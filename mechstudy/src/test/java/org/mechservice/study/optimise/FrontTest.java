package org.mechservice.study.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Fronts that are known in closed form. */
class FrontTest {
  private static final OptimiserSettings SETTINGS = OptimiserSettings.DEFAULT;

  private static final List<Aim> TWO =
      List.of(new Aim(Aim.Kind.MINIMISE, "f"), new Aim(Aim.Kind.MINIMISE, "g"));

  private static final List<DesignVariable> PLANE =
      List.of(new DesignVariable("x", -4, 4, 3), new DesignVariable("y", -4, 4, -2));

  /**
   * Schaffer 1985, in the plane: the squares of the distances to (0, 0) and to (2, 0) have the
   * front sqrt(f) + sqrt(g) = 2, on the line between. A search ends where the objective changes by
   * 1e-10 of itself, which is 1e-5 of a distance.
   */
  @Test
  void frontOfTwoDistancesLiesBetweenTheirPoints() throws Exception {
    Front front =
        Front.of(
            new DesignProblem(
                PLANE, TWO, p -> new double[] {square(p[0], p[1]), square(p[0] - 2, p[1])}),
            SETTINGS,
            7);
    assertThat(front.points()).hasSizeGreaterThanOrEqualTo(7);
    for (Front.Point point : front.points()) {
      assertThat(Math.sqrt(point.values()[0]) + Math.sqrt(point.values()[1]))
          .isCloseTo(2, within(1e-4));
      assertThat(point.point()[1]).isCloseTo(0, within(1e-2));
    }
  }

  /**
   * Fonseca and Fleming 1995, two variables: a front that is not convex, on x = y between plus and
   * minus 1/sqrt(2). Weighted sums would find its ends alone.
   */
  @Test
  void frontThatIsNotConvexHasAllItsPoints() throws Exception {
    double c = Math.sqrt(0.5);
    Front front =
        Front.of(
            new DesignProblem(
                PLANE,
                TWO,
                p ->
                    new double[] {
                      1 - Math.exp(-square(p[0] - c, p[1] - c)),
                      1 - Math.exp(-square(p[0] + c, p[1] + c))
                    }),
            SETTINGS.with(Method.BOBYQA),
            9);
    assertThat(front.points()).hasSizeGreaterThanOrEqualTo(9);
    for (Front.Point point : front.points()) {
      double x = (point.point()[0] + point.point()[1]) / 2;
      assertThat(point.values()[0]).isCloseTo(1 - Math.exp(-2 * Math.pow(x - c, 2)), within(1e-4));
      assertThat(point.values()[1]).isCloseTo(1 - Math.exp(-2 * Math.pow(x + c, 2)), within(1e-4));
    }
  }

  /** The second objective knows nothing of y: its end is where the first one is least. */
  @Test
  void whatAnEndLeavesOpenIsSettledByTheOtherObjective() throws Exception {
    Front front =
        Front.of(
            new DesignProblem(
                PLANE, TWO, p -> new double[] {square(p[0], p[1] - 1), square(p[0] - 2, 0)}),
            SETTINGS,
            3);
    Front.Point last = front.points().get(front.points().size() - 1);
    assertThat(last.point()[1]).isCloseTo(1, within(1e-3));
    assertThat(last.values()[0]).isCloseTo(4, within(0.05)); // (2 - 2 sqrt(1e-5))²
  }

  /** With x >= 1 only the part of the front beyond it is left. */
  @Test
  void constraintsCutTheFrontOff() throws Exception {
    Front front =
        Front.of(
            new DesignProblem(
                PLANE,
                List.of(TWO.get(0), TWO.get(1), new Aim(Aim.Kind.AT_MOST_ZERO, "x >= 1", 1)),
                p -> new double[] {square(p[0], p[1]), square(p[0] - 2, p[1]), 1 - p[0]}),
            SETTINGS,
            5);
    assertThat(front.points()).isNotEmpty();
    assertThat(front.points().get(0).values()[0]).isCloseTo(1, within(1e-4));
    assertThat(front.points()).allSatisfy(p -> assertThat(p.point()[0]).isGreaterThan(1 - 1e-5));
  }

  @Test
  void whatIsNoFrontIsRefused() {
    DesignProblem one =
        new DesignProblem(
            PLANE, List.of(new Aim(Aim.Kind.MINIMISE, "f")), p -> new double[] {p[0]});
    assertThatThrownBy(() -> Front.of(one, SETTINGS, 5)).hasMessageContaining("two objectives");
    DesignProblem two = new DesignProblem(PLANE, TWO, double[]::clone);
    assertThatThrownBy(() -> Front.of(two, SETTINGS, 2)).hasMessageContaining("3 or more");
    assertThatThrownBy(() -> Optimiser.minimise(two, SETTINGS)).hasMessageContaining("front");
  }

  private static double square(double x, double y) {
    return x * x + y * y;
  }
}
