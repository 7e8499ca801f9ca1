package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.Linkages.Hinge;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A five-bar whose cranks, at A and E, are geared: the loop leaves two freedoms, the gear one.
 *
 * <pre>
 *         C
 *       /   \
 *     B       D
 *    /       /
 *   A       E
 * </pre>
 */
class GearedLinkageTest {
  private static final double END = 1.5;
  private static final int AB = 0;
  private static final int BC = 1;
  private static final int CD = 2;
  private static final Vector3 CRANK = new Vector3(0.3, 0, 0.4);
  private static final Vector3 E = new Vector3(1, 0, 0);
  private static final Vector3 D = E.plus(CRANK);
  private static final Vector3 C = new Vector3(0.8, 0, 0.9);
  private static final List<Body> BARS =
      List.of(
          Linkages.bar("AB", Vector3.ZERO, CRANK, 1),
          Linkages.bar("BC", CRANK, C, 0.8),
          Linkages.bar("CD", C, D, 0.6),
          Linkages.bar("DE", D, E, 1.2));

  /** The crank at E turns by ratio times the angle of that at A. */
  private static Mechanism geared(double ratio, int cut) {
    Mechanism loop = fiveBar(cut);
    Expression turned = new Expression.Product(Expression.of(ratio), position(loop, "A"));
    return coupled(loop, loop.joints(), loop.closures(), turned);
  }

  /** The crank at E follows a disc on that at A, which moves already: −φ/2 + 0.4 φ². */
  private static Mechanism movingByDisc(int cut) {
    Mechanism loop = fiveBar(cut);
    Expression angle = position(loop, "A");
    Expression turned =
        new Expression.Sum(
            new Expression.Product(Expression.of(-0.5), angle),
            new Expression.Product(Expression.of(0.4), new Expression.Product(angle, angle)));
    List<Joint> joints = loop.joints().stream().map(GearedLinkageTest::started).toList();
    Joint cutJoint = started(((JointClosure) loop.closures().get(0)).joint());
    StartRole role = cutJoint.name().equals("A") ? StartRole.FIXED : StartRole.PREFERRED;
    return coupled(loop, joints, List.of(new JointClosure(cutJoint, role, List.of())), turned);
  }

  private static Joint started(Joint joint) {
    return joint.name().equals("A") && joint instanceof Revolute at
        ? new Revolute(at.name(), at.attachment(), at.axis(), 0, 3, Origin.NONE)
        : joint;
  }

  private static Mechanism coupled(
      Mechanism loop, List<Joint> joints, List<LoopClosure> closures, Expression turned) {
    Expression relation = new Expression.Sum(position(loop, "E"), new Expression.Negation(turned));
    List<LoopClosure> all = new ArrayList<>(closures);
    all.add(new CoordinateClosure("gear", relation, Origin.NONE));
    return Linkages.mechanism("geared five-bar", loop.bodies(), joints, all);
  }

  private static Mechanism fiveBar(int cut) {
    List<Hinge> hinges =
        List.of(
            hinge("A", -1, AB, Vector3.ZERO),
            hinge("B", AB, BC, CRANK),
            hinge("C", BC, CD, C),
            hinge("D", CD, 3, D),
            hinge("E", -1, 3, E));
    return Linkages.ring("five-bar", BARS, hinges, cut);
  }

  private static Hinge hinge(String name, int from, int to, Vector3 at) {
    return new Hinge(name, JointType.R, from, to, at, Linkages.Y);
  }

  /** Returns the angle of a joint, of the tree or the cut one. */
  private static Expression position(Mechanism mechanism, String joint) {
    return new Expression.CoordinatePosition(angle(mechanism, joint));
  }

  private static Coordinate angle(Mechanism mechanism, String joint) {
    return IntStream.range(0, mechanism.joints().size())
        .filter(j -> mechanism.joints().get(j).name().equals(joint))
        .<Coordinate>mapToObj(j -> new JointCoordinate(j, 0))
        .findFirst()
        .orElseGet(() -> new ClosureCoordinate(0, 0));
  }

  /** Poses of all bodies at every output time. */
  private static List<double[]> poses(
      Mechanism mechanism, String formulation, String integrator, double tolerance) {
    LoopModel model =
        LoopModels.of(mechanism, formulation, SceneRun.settings(END, 0.1, integrator, tolerance));
    SceneRun run = SceneRun.of(model);
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    List<double[]> all = new ArrayList<>();
    for (double[] row : run.rows) {
      double[] y = Arrays.copyOfRange(row, 1, 1 + model.description().stateCount());
      double[] poses = new double[BodyPoses.NUMBERS_PER_BODY * mechanism.bodies().size()];
      model.poses(row[0], y, poses);
      all.add(poses);
    }
    return all;
  }

  /** Cranks that turn alike carry the bars without turning them: masses at the crank's end. */
  private static Mechanism pendulum() {
    double l = CRANK.norm();
    double onTip = BARS.get(BC).mass() + BARS.get(CD).mass();
    double mass = onTip;
    double moment = onTip * l;
    double inertia = onTip * l * l;
    for (Body crank : List.of(BARS.get(AB), BARS.get(3))) {
      mass += crank.mass();
      moment += crank.mass() * l / 2;
      inertia += crank.inertia().yy() + crank.mass() * l * l / 4;
    }
    double center = moment / mass;
    double about = inertia - mass * center * center;
    InertiaTensor tensor = new InertiaTensor(about, about, about, 0, 0, 0);
    Body body = new Body("AB", mass, CRANK.times(center / l), tensor, Origin.NONE);
    return Linkages.mechanism(
        "pendulum", List.of(body), List.of(hinge("A", -1, 0, Vector3.ZERO).joint()), List.of());
  }

  private static final List<double[]> PENDULUM = poses(pendulum(), "DSR", "ode113", 1e-12);

  static Stream<Arguments> cutsAndMethods() {
    return IntStream.range(0, 5)
        .boxed()
        .flatMap(
            cut ->
                Stream.of(
                    Arguments.of(cut, "DSR", "ode113", 1e-12, 1e-9),
                    Arguments.of(cut, "DSR penalty", "ode113", 1e-11, 1e-8),
                    Arguments.of(cut, "RR", "ode15sR", 1e-8, 1e-5),
                    Arguments.of(cut, "RR-JF", "ode15sR", 1e-8, 1e-5)));
  }

  @MethodSource("cutsAndMethods")
  @ParameterizedTest
  void cranksGearedOneToOneSwingAsAPendulumWhicheverJointIsCut(
      int cut, String formulation, String integrator, double tolerance, double bound) {
    List<double[]> actual = poses(geared(1, cut), formulation, integrator, tolerance);
    assertThat(actual).hasSameSizeAs(PENDULUM);
    for (int row = 0; row < PENDULUM.size(); row++) {
      double[] pendulum = PENDULUM.get(row);
      double angle = 2 * Math.atan2(pendulum[5], pendulum[3]);
      double cos = Math.cos(angle);
      double sin = Math.sin(angle);
      double[] expected = {
        CRANK.x() * cos + CRANK.z() * sin - CRANK.x(),
        0,
        CRANK.z() * cos - CRANK.x() * sin - CRANK.z()
      };
      for (int bar : new int[] {BC, CD}) {
        double[] pose = actual.get(row);
        int at = BodyPoses.NUMBERS_PER_BODY * bar;
        for (int i = 0; i < 3; i++) {
          assertThat(pose[at + i]).as("place of bar %s", bar).isCloseTo(expected[i], within(bound));
        }
        assertThat(Math.hypot(Math.hypot(pose[at + 4], pose[at + 5]), pose[at + 6]))
            .as("turn of bar %s", bar)
            .isCloseTo(0, within(bound));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 3, 4})
  void aGearOfAnyRatioMovesTheLoopTheSameWhicheverJointIsCut(int cut) {
    assertSame(
        poses(geared(-0.5, cut), "DSR", "ode113", 1e-12),
        poses(geared(-0.5, 2), "DSR", "ode113", 1e-12),
        1e-9);
  }

  @CsvSource({
    "DSR penalty, ode113, 1e-11, 1e-8",
    "RR, ode15sR, 1e-8, 1e-5",
    "RR-JF, ode15sR, 1e-8, 1e-5",
    "RR penalty, ode15sR, 1e-8, 1e-5",
    "RR-JF penalty, ode15sR, 1e-8, 1e-5"
  })
  @ParameterizedTest
  void aGearOfAnyRatioMovesTheLoopTheSameInEveryFormulation(
      String formulation, String integrator, double tolerance, double bound) {
    assertSame(
        poses(geared(-0.5, 2), formulation, integrator, tolerance),
        poses(geared(-0.5, 2), "DSR", "ode113", 1e-12),
        bound);
  }

  /** Without reactions: those do not tell what a gear does to the bodies it couples. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4})
  void accelerationsAreThoseOfMaximalCoordinatesWhicheverJointIsCut(int cut) {
    for (Mechanism mechanism : List.of(geared(1, cut), geared(3, cut), movingByDisc(cut))) {
      LoopComparison compared = LoopComparison.of(mechanism);
      assertThat(compared.freedom()).isEqualTo(1);
      compared
          .forward()
          .forEach(
              (formulation, error) ->
                  assertThat(error).as(formulation).isLessThan(compared.forwardBound()));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4})
  void aDiscMovesFromTheStart(int cut) {
    Mechanism mechanism = movingByDisc(cut);
    double[] y =
        new ClosedMechanism(mechanism, "DSR", SceneRun.settings(END, END, "ode113", 1e-6))
            .start()
            .state();
    double[] v = Arrays.copyOfRange(y, mechanism.positionCount(), y.length);
    assertThat(Arrays.stream(v).map(Math::abs).max().orElseThrow()).isGreaterThan(0.5);
  }

  private static void assertSame(List<double[]> actual, List<double[]> expected, double bound) {
    assertThat(actual).hasSameSizeAs(expected);
    for (int row = 0; row < actual.size(); row++) {
      double[] numbers = expected.get(row);
      for (int i = 0; i < numbers.length; i++) {
        assertThat(actual.get(row)[i])
            .as("row %s, number %s", row, i)
            .isCloseTo(numbers[i], within(bound * (1 + Math.abs(numbers[i]))));
      }
    }
  }
}
