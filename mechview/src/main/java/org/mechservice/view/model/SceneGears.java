package org.mechservice.view.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBelt;
import org.mechservice.view.scene.SceneGear;
import org.mechservice.view.scene.SceneJoint;

/**
 * The gear wheels and belts that couplings of turning joints stand for: two wheels on one body, or
 * the wheels of a planetary gear. Their radii are in the ratio of the factors of their angles, and
 * fit the distance of their axes. A belt drives a wheel that turns the same way as the one beside
 * it at another speed. At the same speed nothing is known of what joins them, and nothing is drawn.
 *
 * <p>Teeth of all wheels have one size, and at the start those of one wheel are in the gaps of the
 * other: with the pitch p, and a tooth of the first wheel at the angle α from the line to the
 * second centre, the second has one at ψ = −(α r₁ + p/2)/r₂ from the line back, and a ring around
 * the first one at (α r₁ + p/2)/r₂ from the same line.
 */
final class SceneGears {
  private static final double PARALLEL = 1e-6;

  /** Teeth of the smallest wheel. */
  private static final int FEWEST_TEETH = 18;

  /** Radius of the larger pulley of a belt, in parts of the distance of the axles. */
  private static final double PULLEY = 0.36;

  private final Mechanism mechanism;
  private final SceneParts parts;
  private final Map<Integer, Wheel> wheels = new LinkedHashMap<>();
  private final List<Mesh> meshes = new ArrayList<>();
  private final List<SceneBelt> belts = new ArrayList<>();

  /** A turning joint with the factor of its angle; point and axis in world axes. */
  private record Turning(SceneJoint joint, Point3 point, Point3 axis, double factor) {}

  /** A wheel in world axes at the start. */
  private record Wheel(SceneGear.Kind kind, int body, Point3 centre, Point3 axis, double radius) {}

  /** Two bodies whose wheels mesh, the second perhaps a ring around the first. */
  private record Mesh(int first, int second) {}

  SceneGears(Mechanism mechanism, SceneParts parts) {
    this.mechanism = mechanism;
    this.parts = parts;
  }

  /** Finds the wheels, one at most for each body, and the belts. */
  void find() {
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof CoordinateClosure one && one.points().isEmpty()) {
        add(one.relation());
      }
    }
    for (ForceElement force : mechanism.forces()) {
      if (force instanceof CouplingSpringDamper one && one.points().isEmpty()) {
        add(one.along());
      }
    }
  }

  /** Returns the belts. */
  List<SceneBelt> belts() {
    return List.copyOf(belts);
  }

  /** Returns the wheels. */
  List<SceneGear> wheels() {
    double smallest = wheels.values().stream().mapToDouble(Wheel::radius).min().orElse(1);
    double pitch = 2 * Math.PI * smallest / FEWEST_TEETH;
    Map<Integer, Point3> teeth = teeth(pitch);
    return wheels.values().stream()
        .map(
            wheel -> {
              BodyPose pose = parts.pose(wheel.body());
              return new SceneGear(
                  wheel.kind(),
                  wheel.body(),
                  pose.turnBack(wheel.centre().minus(pose.position())),
                  pose.turnBack(wheel.axis()),
                  pose.turnBack(teeth.getOrDefault(wheel.body(), across(wheel.axis()))),
                  wheel.radius(),
                  wheel.kind() == SceneGear.Kind.PULLEY
                      ? 0
                      : (int) Math.round(2 * Math.PI * wheel.radius() / pitch));
            })
        .toList();
  }

  /** Returns the direction of one tooth of each wheel that meshes. */
  private Map<Integer, Point3> teeth(double pitch) {
    Map<Integer, Point3> teeth = new HashMap<>();
    for (Mesh mesh : meshes) {
      Wheel first = wheels.get(mesh.first());
      if (first != null && !teeth.containsKey(first.body())) {
        teeth.put(first.body(), across(first.axis()));
        spread(teeth, pitch);
      }
    }
    return teeth;
  }

  /** Adds the teeth of all wheels that mesh with known ones, directly or by others. */
  private void spread(Map<Integer, Point3> teeth, double pitch) {
    int before;
    do {
      before = teeth.size();
      for (Mesh mesh : meshes) {
        Wheel one = wheels.get(mesh.first());
        Wheel other = wheels.get(mesh.second());
        if (one == null || other == null) {
          continue;
        }
        Point3 first = teeth.get(one.body());
        Point3 second = teeth.get(other.body());
        if (first != null && second == null) {
          teeth.put(other.body(), opposite(one, first, other, pitch));
        } else if (second != null && first == null) {
          teeth.put(one.body(), opposite(other, second, one, pitch));
        }
      }
    } while (teeth.size() > before);
  }

  /** Returns the direction of a tooth of the other wheel beside the teeth of one. */
  private static Point3 opposite(Wheel one, Point3 tooth, Wheel other, double pitch) {
    boolean inside = one.kind() == SceneGear.Kind.RING || other.kind() == SceneGear.Kind.RING;
    Point3 axis = one.axis();
    Point3 between = other.centre().minus(one.centre());
    Point3 level = between.minus(axis.times(between.dot(axis)));
    Point3 line = level.times(1 / level.norm());
    // from a ring the line goes on beyond the centre of the wheel in it
    Point3 out = other.kind() == SceneGear.Kind.RING ? line.times(-1) : line;
    double angle = Math.atan2(axis.dot(out.cross(tooth)), out.dot(tooth));
    double turn = (angle * one.radius() + pitch / 2) / other.radius();
    Point3 from = inside ? out : out.times(-1);
    double signed = inside ? turn : -turn;
    return from.times(Math.cos(signed)).plus(axis.cross(from).times(Math.sin(signed)));
  }

  private static Point3 across(Point3 axis) {
    Point3 other = Math.abs(axis.x()) < 0.8 ? new Point3(1, 0, 0) : new Point3(0, 1, 0);
    Point3 side = axis.cross(other);
    return side.times(1 / side.norm());
  }

  private void add(Expression relation) {
    List<Turning> turns = turns(relation);
    if (turns.size() == 2) {
      Turning one = turns.get(0);
      Turning other = turns.get(1);
      if (one.joint().first().body() == other.joint().first().body()) {
        pair(one, other);
      } else if (other.joint().first().body() == one.joint().second().body()) {
        ring(one, other);
      } else if (one.joint().first().body() == other.joint().second().body()) {
        ring(other, one);
      }
    } else if (turns.size() == 3) {
      for (Turning planet : turns) {
        planetary(planet, turns.stream().filter(turn -> !turn.equals(planet)).toList());
      }
    }
  }

  /** The planet turns in a carrier; the sun turns about the carrier's axis. */
  private void planetary(Turning planet, List<Turning> others) {
    for (int i = 0; i < 2; i++) {
      Turning carrier = others.get(i);
      Turning sun = others.get(1 - i);
      if (planet.joint().first().body() == carrier.joint().second().body()
          && sun.joint().first().body() == carrier.joint().first().body()
          && Math.abs(sun.factor() + carrier.factor()) < 1e-9 * Math.abs(sun.factor())) {
        pair(sun, planet);
      }
    }
  }

  private void pair(Turning one, Turning other) {
    double distance = distance(one, other);
    double first = Math.abs(one.factor());
    double second = Math.abs(other.factor());
    if (!(distance > 0)) {
      return;
    }
    boolean outside = one.factor() * other.factor() * one.axis().dot(other.axis()) > 0;
    if (outside) {
      double scale = distance / (first + second);
      put(SceneGear.Kind.WHEEL, one, scale * first);
      put(SceneGear.Kind.WHEEL, other, scale * second);
      meshes.add(new Mesh(one.joint().second().body(), other.joint().second().body()));
    } else if (Math.abs(first - second) > 1e-9 * first) {
      double scale = PULLEY * distance / Math.max(first, second);
      put(SceneGear.Kind.PULLEY, one, scale * first);
      put(SceneGear.Kind.PULLEY, other, scale * second);
      belt(one, other, scale);
    }
  }

  private void belt(Turning one, Turning other, double scale) {
    int body = one.joint().first().body();
    BodyPose pose = parts.pose(body);
    Point3 way = other.point().minus(one.point());
    Point3 level = way.minus(one.axis().times(way.dot(one.axis())));
    double distance = level.norm();
    Point3 x = pose.turnBack(level.times(1 / distance));
    Point3 z = pose.turnBack(one.axis());
    Point3 y = z.cross(x);
    double[] rows = {x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z()};
    belts.add(
        new SceneBelt(
            body,
            BodyPose.of(pose.turnBack(one.point().minus(pose.position())), rows, 0),
            scale * Math.abs(one.factor()),
            scale * Math.abs(other.factor()),
            distance));
  }

  /** A planet runs in a ring of the body that the carrier turns on. */
  private void ring(Turning carrier, Turning planet) {
    double distance = distance(carrier, planet);
    double larger = Math.abs(carrier.factor());
    double smaller = Math.abs(planet.factor());
    if (!(distance > 0) || larger <= smaller) {
      return;
    }
    double scale = distance / (larger - smaller);
    put(SceneGear.Kind.WHEEL, planet, scale * smaller);
    int fixed = carrier.joint().first().body();
    wheels.putIfAbsent(
        fixed,
        new Wheel(SceneGear.Kind.RING, fixed, carrier.point(), carrier.axis(), scale * larger));
    meshes.add(new Mesh(planet.joint().second().body(), fixed));
  }

  private void put(SceneGear.Kind kind, Turning turn, double radius) {
    int body = turn.joint().second().body();
    wheels.putIfAbsent(body, new Wheel(kind, body, turn.point(), turn.axis(), radius));
  }

  /** Returns how far two parallel axes are from each other, m; 0 if they are not parallel. */
  private static double distance(Turning one, Turning other) {
    if (Math.abs(one.axis().dot(other.axis())) < 1 - PARALLEL) {
      return 0;
    }
    Point3 between = other.point().minus(one.point());
    return between.minus(one.axis().times(between.dot(one.axis()))).norm();
  }

  /** Returns the turning joints of a linear relation; none if it has other coordinates too. */
  private List<Turning> turns(Expression relation) {
    FormulaEvaluation formula = new FormulaEvaluation(List.of(relation));
    List<Turning> turns = new ArrayList<>();
    for (int leaf = 0; leaf < formula.leaves().size(); leaf++) {
      Expression kind = formula.leaves().get(leaf);
      if (kind instanceof Expression.CoordinatePosition position) {
        Joint joint = mechanism.jointOf(position.coordinate());
        if (joint.type() != JointType.R) {
          return List.of();
        }
        SceneJoint shown = SceneParts.joint(joint, false, false);
        BodyPose parent = parts.pose(shown.first().body());
        double factor = value(formula, leaf, 1) - value(formula, leaf, 0);
        if (Math.abs(value(formula, leaf, 2) - value(formula, leaf, 0) - 2 * factor)
            > 1e-9 * Math.abs(factor)) {
          return List.of();
        }
        turns.add(
            new Turning(
                shown, parent.toWorld(shown.first().point()), parent.turn(shown.axis()), factor));
      } else if (!(kind instanceof Expression.ParameterValue)) {
        return List.of();
      }
    }
    return turns;
  }

  /** Returns a relation with one coordinate at a value and the others at 0. */
  private double value(FormulaEvaluation formula, int chosen, double coordinate) {
    for (int leaf = 0; leaf < formula.leaves().size(); leaf++) {
      Expression kind = formula.leaves().get(leaf);
      formula.setLeaf(
          leaf,
          leaf == chosen
              ? coordinate
              : kind instanceof Expression.ParameterValue parameter
                  ? mechanism.parameters().get(parameter.index()).value()
                  : 0);
    }
    formula.values();
    return formula.value(0);
  }
}
