package org.mechservice.view.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

/** Lengths of the lines are those of the strings that they show, by closed forms. */
class RopeWayTest {
  private static final SceneRope.Frame PLANE = new SceneRope.Frame(Anchor.ROOT, BodyPose.WORLD);

  private static Anchor at(double x, double y, double z) {
    return new Anchor(Anchor.ROOT, new Point3(x, y, z));
  }

  /** Returns by how much the chords of an arc on the unit circle are shorter at most. */
  private static Offset<Double> chords(double arc) {
    return within(Math.pow(arc, 3) / (24 * RopeWay.PARTS * RopeWay.PARTS));
  }

  private static double length(SceneRope.Stop... stops) {
    SceneRope rope = new SceneRope("rope", false, List.of(stops), PLANE);
    List<List<Point3>> lines = RopeWay.of(rope, body -> BodyPose.WORLD);
    assertThat(lines).hasSize(1);
    List<Point3> line = lines.get(0);
    return IntStream.range(1, line.size())
        .mapToDouble(i -> line.get(i).minus(line.get(i - 1)).norm())
        .sum();
  }

  private static SceneRope.Eye eye(double x, double y, double z) {
    return new SceneRope.Eye(at(x, y, z));
  }

  private static SceneRope.Around around(Point3 axis, boolean inside, Anchor... sides) {
    return new SceneRope.Around(at(0, 0, 0), axis, 1, List.of(sides), inside);
  }

  /** The ends are at 2 R, half a turn apart: tangents of √3 and an arc of π − 2 π/3. */
  @Test
  void stringOverASphereHasTwoTangentsAndAnArc() {
    double way = 2 * Math.sqrt(3) + Math.PI - 2 * Math.PI / 3;
    assertThat(length(eye(-2, 1e-9, 0), around(Point3.ZERO, false), eye(2, 1e-9, 0)))
        .isCloseTo(way, chords(Math.PI / 3 + 1e-3));
  }

  @Test
  void stringOverACylinderRisesEvenly() {
    double way = 2 * Math.sqrt(3) + Math.PI - 2 * Math.PI / 3;
    Point3 axis = new Point3(0, 0, 1);
    assertThat(length(eye(-2, 1e-9, 0), around(axis, false), eye(2, 1e-9, 3)))
        .isCloseTo(Math.hypot(way, 3), chords(Math.PI / 3 + 1e-3));
  }

  @Test
  void stringBesideTheShapeIsStraightUnlessASideIsOpposite() {
    Point3 axis = new Point3(0, 0, 1);
    assertThat(length(eye(-2, 1.5, 0), around(axis, false), eye(2, 1.5, 0)))
        .isCloseTo(4, within(1e-12));
    // the long way round, below
    double distance = Math.hypot(2, 1.5);
    double psi = 2 * Math.atan2(2, 1.5);
    double beta = Math.acos(1 / distance);
    double way = 2 * Math.sqrt(distance * distance - 1) + 2 * Math.PI - psi - 2 * beta;
    assertThat(length(eye(-2, 1.5, 0), around(axis, false, at(0, -2, 0)), eye(2, 1.5, 0)))
        .isCloseTo(way, chords(2 * Math.PI - psi - 2 * beta));
  }

  @Test
  void stringInARingTouchesItAtItsMiddle() {
    Point3 axis = new Point3(0, 0, 1);
    assertThat(length(eye(-2, 3, 0), around(axis, true), eye(2, 3, 0)))
        .isCloseTo(2 * Math.hypot(2, 2), within(1e-9));
  }

  @Test
  void ropeOverAPulleyLeavesItWhenItIsLifted() {
    SceneRope.Pulley below = new SceneRope.Pulley(at(0, 0, 0), 1, false, false);
    assertThat(length(eye(-2, -3, 0), below, eye(2, -3, 0)))
        .isCloseTo(2 * Math.sqrt(12) + arc(), chords(arc()));
    assertThat(length(eye(-2, 3, 0), below, eye(2, 3, 0))).isCloseTo(4, within(1e-9));
  }

  /** The arc between the tangents from (∓2, −3) over the top of the unit circle. */
  private static double arc() {
    double between = 2 * Math.PI - 2 * Math.atan2(2, 3);
    return between - 2 * Math.acos(1 / Math.sqrt(13));
  }

  @Test
  void branchBeginsAnew() {
    SceneRope rope =
        new SceneRope(
            "rope",
            false,
            List.of(eye(0, 0, 0), eye(1, 0, 0), new SceneRope.Branch(), eye(1, 0, 0), eye(1, 1, 0)),
            PLANE);
    assertThat(RopeWay.of(rope, body -> BodyPose.WORLD))
        .containsExactly(
            List.of(new Point3(0, 0, 0), new Point3(1, 0, 0)),
            List.of(new Point3(1, 0, 0), new Point3(1, 1, 0)));
  }
}
