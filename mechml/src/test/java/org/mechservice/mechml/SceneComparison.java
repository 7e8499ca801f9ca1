package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.mechml.JsonScene.number;
import static org.mechservice.mechml.JsonScene.numbers;
import static org.mechservice.mechml.JsonScene.text;
import static org.mechservice.mechml.JsonScene.vector;

import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Compares a mechanism with a reference scene.
 *
 * @param mechanism what a file says
 */
record SceneComparison(Mechanism mechanism) {
  /** A few roundings: decimals of the scenes are expressions in the files, as 1/12. */
  private static final double ROUNDING = 4e-16;

  /** Vectors of the paper are unit to 3e-8 only; its wheel's inertia carries nine digits. */
  private static final double OF_THE_PAPER = 1e-15;

  /** Asserts that bodies, joints and constraints are the scene's, and no others. */
  void assertMechanism(JsonScene scene) {
    assertVector(mechanism.gravity(), vector(scene.object(), "gravity"));
    assertBodies(scene.list("bodies"));
    assertJoints(scene.list("joints"));
    assertClosures(scene.list("constraints"));
  }

  private void assertBodies(List<JsonObject> expected) {
    assertThat(mechanism.bodies()).hasSameSizeAs(expected);
    for (int i = 0; i < expected.size(); i++) {
      Body body = mechanism.bodies().get(i);
      JsonObject e = expected.get(i);
      assertThat(body.name()).isEqualTo(text(e, "name"));
      assertNumber(body.mass(), number(e, "mass"));
      assertVector(body.centerOfMass(), vector(e, "cog"));
      InertiaTensor inertia = body.inertia();
      List<Double> actual =
          List.of(
              inertia.xx(), inertia.yy(), inertia.zz(), inertia.xy(), inertia.xz(), inertia.yz());
      assertNumbers(actual, numbers(e, "inertia"));
    }
  }

  private void assertJoints(List<JsonObject> expected) {
    assertThat(mechanism.joints()).hasSameSizeAs(expected);
    for (int i = 0; i < expected.size(); i++) {
      Joint joint = mechanism.joints().get(i);
      JsonObject e = expected.get(i);
      assertThat(joint.name()).isEqualTo(text(e, "name"));
      assertThat(joint.type().name()).isEqualTo(text(e, "type"));
      BodyPoint point1 =
          new BodyPoint(joint.attachment().parent(), joint.attachment().parentPoint());
      BodyPoint point2 = new BodyPoint(joint.attachment().child(), joint.attachment().childPoint());
      assertPoint(point1, e, "body1", "point1");
      assertPoint(point2, e, "body2", "point2");
      assertRotation(joint.attachment().zeroRotation());
      if (e.has("axis")) {
        assertVector(axis(joint), vector(e, "axis").normalized());
      }
      double[] q = new double[joint.type().positionCount()];
      double[] v = new double[joint.type().velocityCount()];
      joint.initialPositions(q, 0);
      joint.initialVelocities(v, 0);
      assertNumbers(Arrays.stream(q).boxed().toList(), numbers(e, "q0"));
      assertNumbers(Arrays.stream(v).boxed().toList(), numbers(e, "v0"));
    }
  }

  private static Vector3 axis(Joint joint) {
    if (joint instanceof Revolute revolute) {
      return revolute.axis();
    }
    return ((Prismatic) joint).axis();
  }

  private void assertClosures(List<JsonObject> expected) {
    assertThat(mechanism.closures()).hasSameSizeAs(expected);
    for (int i = 0; i < expected.size(); i++) {
      LoopClosure closure = mechanism.closures().get(i);
      JsonObject e = expected.get(i);
      assertThat(closure.name()).isEqualTo(text(e, "name"));
      if (closure instanceof DistanceClosure distance) {
        assertThat(text(e, "type")).isEqualTo("DIST");
        assertPoint(distance.point1(), e, "body1", "point1");
        assertPoint(distance.point2(), e, "body2", "point2");
        assertNumber(distance.distance(), Math.sqrt(number(e, "distSquared")));
        assertNumber(distance.rodMass(), number(e, "rodMass"));
      } else if (closure instanceof PointOnLineClosure line) {
        assertPoint(line.point(), e, "body1", "point1");
        assertPoint(line.line(), e, "body2", "point2");
        assertVector(line.direction(), text(e, "coords").equals("xy") ? unit(2) : unit(1));
      } else if (closure instanceof PointOnPlaneClosure plane) {
        assertPoint(plane.point(), e, "body1", "point1");
        assertPoint(plane.plane(), e, "body2", "point2");
        assertVector(plane.normal(), unit("xyz".indexOf(text(e, "coords"))));
      } else {
        Revolute cut = (Revolute) ((JointClosure) closure).joint();
        BodyPoint point1 = new BodyPoint(cut.attachment().parent(), cut.attachment().parentPoint());
        BodyPoint point2 = new BodyPoint(cut.attachment().child(), cut.attachment().childPoint());
        assertPoint(point1, e, "body1", "point1");
        assertPoint(point2, e, "body2", "point2");
        assertVector(cut.axis(), vector(e, "axis1"));
      }
    }
  }

  private static Vector3 unit(int axis) {
    return new Vector3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
  }

  /** Asserts that the forces are the scene's, and no others. */
  void assertForces(List<JsonObject> expected) {
    List<ForceElement> left = new ArrayList<>(mechanism.forces());
    for (JsonObject e : expected) {
      switch (text(e, "type")) {
        case "jointSpringDamper" -> assertJointSpring(e, left);
        case "springDamper" -> assertSpring(e, "point1", "point2", take(e, left));
        case "belt" -> assertBelt(e, (SpringDamper) take(e, left));
        case "bushing" -> assertBushing(e, (Bushing) take(e, left));
        case "plane" -> assertPlane(e, (Contact) take(e, left));
        default -> {
          // The road of the suspension: compared where it runs.
          assertThat(text(e, "type")).isEqualTo("fpsRoad");
          left.removeIf(f -> List.of("tyre", "traction", "car").contains(f.name()));
        }
      }
    }
    assertThat(left).isEmpty();
  }

  private static ForceElement take(JsonObject e, List<ForceElement> left) {
    String name = e.has("name") ? text(e, "name") : "spring";
    ForceElement force = left.stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
    left.remove(force);
    return force;
  }

  private void assertJointSpring(JsonObject e, List<ForceElement> left) {
    String joint = text(e, "joint");
    for (ForceElement force : List.copyOf(left)) {
      if (force instanceof JointSpringDamper spring && isOf(spring.coordinate(), joint)) {
        assertValue(spring.stiffness(), number(e, "k"));
        assertValue(spring.damping(), number(e, "c"));
        assertValue(spring.position0(), number(e, "q0"));
        left.remove(force);
        return;
      }
      if (force instanceof JointForce drive && isOf(drive.coordinate(), joint)) {
        assertValue(drive.force(), number(e, "tau"));
        assertThat(number(e, "k")).isZero();
        left.remove(force);
        return;
      }
    }
    throw new AssertionError("no spring at " + joint);
  }

  private boolean isOf(Coordinate coordinate, String joint) {
    return mechanism.joints().get(((JointCoordinate) coordinate).joint()).name().equals(joint);
  }

  private void assertSpring(JsonObject e, String point1, String point2, ForceElement force) {
    SpringDamper spring = (SpringDamper) force;
    assertPoint(spring.point1(), e, "body1", point1);
    assertPoint(spring.point2(), e, "body2", point2);
    assertValue(spring.stiffness(), number(e, "k"));
    assertValue(spring.damping(), number(e, "c"));
    assertValue(spring.length0(), number(e, "L0"));
    assertValue(spring.force0(), number(e, "F0"));
    assertThat(spring.side()).isEqualTo(Side.BOTH);
  }

  private void assertBelt(JsonObject e, SpringDamper belt) {
    assertPoint(belt.point2(), e, "body", "point");
    assertVector(world(belt.point1()), vector(e, "anchor"));
    assertValue(belt.stiffness(), number(e, "k"));
    assertValue(belt.damping(), number(e, "c"));
    assertValue(belt.length0(), number(e, "L0"));
    assertValue(belt.smoothing(), number(e, "eps"));
    assertThat(belt.side()).isEqualTo(Side.ABOVE);
  }

  private void assertBushing(JsonObject e, Bushing bushing) {
    assertPoint(bushing.frame2().origin(), e, "body", "point");
    assertVector(world(bushing.frame1().origin()), vector(e, "target"));
    for (int i = 0; i < 36; i++) {
      boolean displacement = i % 7 == 0 && i < 18;
      assertValue(bushing.stiffness().get(i), displacement ? numbers(e, "K").get(i / 7) : 0);
      assertValue(bushing.damping().get(i), displacement ? numbers(e, "C").get(i / 7) : 0);
    }
  }

  private void assertPlane(JsonObject e, Contact contact) {
    assertPoint(contact.center(), e, "body", "point");
    BodyFrame surface = contact.surface();
    Vector3 normal = surface.axes().apply(unit(2));
    assertVector(normal, vector(e, "normal"));
    assertThat(normal.dot(world(surface.origin())))
        .isCloseTo(number(e, "offset"), within(OF_THE_PAPER));
    assertValue(contact.stiffness(), number(e, "k"));
    assertValue(contact.damping(), number(e, "c"));
    assertValue(contact.smoothing(), number(e, "eps"));
    assertValue(contact.radius(), 0);
    assertValue(contact.friction(), 0);
    assertValue(contact.exponent(), 1);
  }

  private void assertPoint(BodyPoint actual, JsonObject e, String body, String point) {
    String name =
        actual.body() == Mechanism.ROOT
            ? mechanism.root().name()
            : mechanism.bodies().get(actual.body()).name();
    assertThat(name).isEqualTo(text(e, body));
    assertVector(world(actual), vector(e, point));
  }

  /** Points of the root in the world, which is where the scenes give them; others stay. */
  private Vector3 world(BodyPoint point) {
    Root root = mechanism.root();
    return point.body() == Mechanism.ROOT
        ? root.position().plus(root.orientation().apply(point.position()))
        : point.position();
  }

  private static void assertRotation(Rotation rotation) {
    assertVector(rotation.apply(unit(0)), unit(0));
    assertVector(rotation.apply(unit(1)), unit(1));
    assertVector(rotation.apply(unit(2)), unit(2));
  }

  private static void assertVector(Vector3 actual, Vector3 expected) {
    assertThat(actual.minus(expected).norm())
        .as("%s, expected %s", actual, expected)
        .isLessThanOrEqualTo(OF_THE_PAPER * Math.max(1, expected.norm()));
  }

  private static void assertNumbers(List<Double> actual, List<Double> expected) {
    assertThat(actual).hasSameSizeAs(expected);
    for (int i = 0; i < expected.size(); i++) {
      assertNumber(actual.get(i), expected.get(i));
    }
  }

  private static void assertNumber(double actual, double expected) {
    assertThat(actual).isCloseTo(expected, within(ROUNDING * Math.abs(expected)));
  }

  private static void assertValue(Expression actual, double expected) {
    assertNumber(((Expression.Constant) actual).value(), expected);
  }
}
