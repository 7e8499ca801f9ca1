package org.mechservice.view.model;

import java.util.ArrayList;
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
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneGear;
import org.mechservice.view.scene.SceneJoint;

/**
 * The gear wheels that couplings of turning joints stand for: two wheels on one body, or the wheels
 * of a planetary gear. Their radii are in the ratio of the factors of their angles, and fit the
 * distance of their axes. What turns the same way as the wheel beside it and is as fast is no gear.
 */
final class SceneGears {
  private static final double PARALLEL = 1e-6;

  private final Mechanism mechanism;
  private final SceneParts parts;
  private final Map<Integer, SceneGear> gears = new LinkedHashMap<>();

  /** A turning joint with the factor of its angle. */
  private record Turning(SceneJoint joint, Point3 point, Point3 axis, double factor) {}

  SceneGears(Mechanism mechanism, SceneParts parts) {
    this.mechanism = mechanism;
    this.parts = parts;
  }

  /** Returns the wheels, one at most for each body. */
  List<SceneGear> all() {
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
    return List.copyOf(gears.values());
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
    boolean outside = one.factor() * other.factor() * one.axis().dot(other.axis()) > 0;
    if (!(distance > 0) || !outside) {
      return;
    }
    double scale = distance / (first + second);
    put(one, scale * first, false);
    put(other, scale * second, false);
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
    put(planet, scale * smaller, false);
    SceneJoint joint = carrier.joint();
    gears.putIfAbsent(
        joint.first().body(),
        new SceneGear(
            joint.first().body(), joint.first().point(), joint.axis(), scale * larger, true));
  }

  private void put(Turning turn, double radius, boolean ring) {
    Anchor at = turn.joint().second();
    Point3 axis = parts.pose(at.body()).turnBack(turn.axis());
    gears.putIfAbsent(at.body(), new SceneGear(at.body(), at.point(), axis, radius, ring));
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
