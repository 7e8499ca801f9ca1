package org.mechservice.solver.scenes;

import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** The forces of the scenes in the product's own descriptions. */
final class SceneForces {
  private final JsonSceneReader scene;

  SceneForces(JsonSceneReader scene) {
    this.scene = scene;
  }

  List<ForceElement> elements(JsonObject force) {
    return switch (force.get("type").getAsString()) {
      case "jointSpringDamper" -> List.of(jointSpring(force));
      case "springDamper" -> List.of(spring(force));
      case "belt" -> List.of(belt(force));
      case "bushing" -> List.of(bushing(force));
      case "plane" -> List.of(plane(force));
      case "fpsRoad" -> road(force);
      default -> throw new IllegalArgumentException(force.toString());
    };
  }

  static String name(JsonObject force) {
    return force.has("name") ? force.get("name").getAsString() : "spring";
  }

  private static Expression number(JsonObject force, String key) {
    return Expression.of(force.get(key).getAsDouble());
  }

  private ForceElement jointSpring(JsonObject force) {
    return new JointSpringDamper(
        name(force),
        new JointCoordinate(scene.jointIndex(force.get("joint").getAsString()), 0),
        number(force, "k"),
        number(force, "c"),
        number(force, "q0"),
        number(force, "tau"),
        Side.BOTH,
        Expression.ZERO,
        Origin.NONE);
  }

  private ForceElement spring(JsonObject force) {
    return new SpringDamper(
        name(force),
        scene.point(force, "1"),
        scene.point(force, "2"),
        number(force, "k"),
        number(force, "c"),
        number(force, "L0"),
        number(force, "F0"),
        Side.BOTH,
        Expression.ZERO,
        Origin.NONE);
  }

  private BodyPoint point(JsonObject force) {
    return new BodyPoint(
        scene.bodyIndex(force.get("body").getAsString()), JsonSceneReader.vector(force, "point"));
  }

  /** A belt between a point and an anchor of the ground, by the law of the scenes. */
  private ForceElement belt(JsonObject force) {
    BodyPoint held = point(force);
    RelativePoint motion =
        new RelativePoint(
            new BodyFrame(
                BodyPoint.ROOT, JsonSceneReader.vector(force, "anchor"), Rotation.IDENTITY),
            new BodyFrame(held.body(), held.position(), Rotation.IDENTITY));
    Expression squares = Expression.ZERO;
    Expression along = Expression.ZERO;
    for (int i = 0; i < 3; i++) {
      squares = plus(squares, times(motion.place(i), motion.place(i)));
      along = plus(along, times(motion.place(i), motion.rate(i)));
    }
    Expression length = new Expression.Call(MathFunction.SQRT, List.of(squares));
    Expression elongation = minus(length, number(force, "L0"));
    Expression tension =
        oneSided(
            elongation,
            new Expression.Quotient(along, length),
            number(force, "k"),
            number(force, "c"),
            number(force, "eps"));
    List<Expression> pull = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      Expression share = new Expression.Quotient(motion.place(i), length);
      pull.add(new Expression.Negation(times(tension, share)));
    }
    return motion.force(name(force), pull);
  }

  /**
   * Returns k pos(x) + c x' pos'(x), pos(x) = (x + √(x² + ε²))/2: the law of the scenes, with which
   * their references were computed. Its damper can turn the force around; the one-sided elements of
   * the product are bounded at zero.
   */
  private static Expression oneSided(
      Expression x, Expression rate, Expression k, Expression c, Expression eps) {
    Expression root =
        new Expression.Call(MathFunction.SQRT, List.of(plus(times(x, x), times(eps, eps))));
    Expression positive = times(Expression.of(0.5), plus(x, root));
    Expression slope =
        times(Expression.of(0.5), plus(Expression.of(1), new Expression.Quotient(x, root)));
    return plus(times(k, positive), times(times(c, rate), slope));
  }

  /**
   * The motion of a point relative to a frame.
   *
   * @param frame1 the frame
   * @param frame2 at the point
   */
  private record RelativePoint(BodyFrame frame1, BodyFrame frame2) {
    Expression place(int axis) {
      return new Expression.RelativeMotion(frame1, frame2, axis);
    }

    Expression rate(int axis) {
      return new Expression.RelativeMotion(frame1, frame2, Expression.RelativeMotion.RATE + axis);
    }

    /** Returns a force on the point, by its components in the axes of the frame. */
    ForceElement force(String name, List<Expression> components) {
      List<Expression> wrench = new ArrayList<>(Collections.nCopies(3, Expression.ZERO));
      wrench.addAll(components);
      return new PairForce(
          name,
          "force of a scene",
          frame1,
          frame2,
          wrench,
          Expression.ZERO,
          Expression.ZERO,
          List.of(),
          Expression.ZERO,
          PairForce.Shape.POINT,
          Origin.NONE);
    }
  }

  private ForceElement bushing(JsonObject force) {
    BodyPoint held = point(force);
    return new Bushing(
        name(force),
        new BodyFrame(BodyPoint.ROOT, JsonSceneReader.vector(force, "target"), Rotation.IDENTITY),
        new BodyFrame(held.body(), held.position(), Rotation.IDENTITY),
        diagonal(JsonSceneReader.numbers(force, "K")),
        diagonal(JsonSceneReader.numbers(force, "C")),
        Collections.nCopies(6, Expression.ZERO),
        Bushing.Law.LINEAR,
        Origin.NONE);
  }

  private static List<Expression> diagonal(double[] first) {
    List<Expression> matrix = new ArrayList<>(Collections.nCopies(36, Expression.ZERO));
    for (int i = 0; i < first.length; i++) {
      matrix.set(7 * i, Expression.of(first[i]));
    }
    return matrix;
  }

  private ForceElement plane(JsonObject force) {
    Vector3 z = JsonSceneReader.vector(force, "normal").normalized();
    BodyFrame surface =
        new BodyFrame(
            BodyPoint.ROOT,
            z.times(force.get("offset").getAsDouble()),
            Rotation.least(new Vector3(0, 0, 1), z));
    BodyPoint held = point(force);
    RelativePoint motion =
        new RelativePoint(surface, new BodyFrame(held.body(), held.position(), Rotation.IDENTITY));
    Expression push =
        oneSided(
            new Expression.Negation(motion.place(2)),
            new Expression.Negation(motion.rate(2)),
            number(force, "k"),
            number(force, "c"),
            number(force, "eps"));
    return motion.force(name(force), List.of(Expression.ZERO, Expression.ZERO, push));
  }

  /**
   * Road and tyre at the wheel's centre, and the car that pulls the frame (README.md beside the
   * scenes).
   */
  private List<ForceElement> road(JsonObject force) {
    String wheel = force.get("wheel").getAsString();
    BodyPoint center =
        new BodyPoint(scene.bodyIndex(wheel), JsonSceneReader.vector(force, "pointWheel"));
    BodyPoint frame =
        new BodyPoint(scene.bodyIndex(force.get("frame").getAsString()), Vector3.ZERO);
    Expression spin =
        new Expression.CoordinateVelocity(
            new JointCoordinate(scene.jointIndex(scene.jointOf(wheel)), 0));
    Expression loadedRadius = number(force, "Rl");
    Expression longitudinal =
        times(
            number(force, "cx"),
            minus(times(loadedRadius, spin), new Expression.PointVelocity(center, 0)));
    Expression none = Expression.ZERO;
    // the force acts Rl below the centre: moment (0, 0, −Rl) × F
    Expression moment = new Expression.Negation(times(loadedRadius, longitudinal));
    return List.of(
        new ForceTorque(
            "road",
            center,
            ForceTorque.Axes.WORLD,
            List.of(longitudinal, none, push(force, center), none, moment, none),
            Origin.NONE),
        new ForceTorque(
            "car",
            frame,
            ForceTorque.Axes.WORLD,
            List.of(pull(force), none, none, none, none, none),
            Origin.NONE));
  }

  /** kt pos(d) + ct d' pos'(d), d = R0 − (c_z + Rl − h(c_x)). */
  private static Expression push(JsonObject force, BodyPoint center) {
    Expression x = new Expression.PointPosition(center, 0);
    Expression height = Expression.ZERO;
    Expression slope = Expression.ZERO;
    double half = force.get("H").getAsDouble() / 2;
    Expression width = number(force, "w");
    for (double at : JsonSceneReader.numbers(force, "xs")) {
      Expression tanh =
          new Expression.Call(
              MathFunction.TANH,
              List.of(new Expression.Quotient(minus(x, Expression.of(at)), width)));
      height = plus(height, times(Expression.of(half), plus(Expression.of(1), tanh)));
      Expression steepness = minus(Expression.of(1), times(tanh, tanh));
      slope = plus(slope, new Expression.Quotient(times(Expression.of(half), steepness), width));
    }
    Expression d =
        minus(
            plus(minus(number(force, "R0"), number(force, "Rl")), height),
            new Expression.PointPosition(center, 2));
    Expression rate =
        minus(
            times(slope, new Expression.PointVelocity(center, 0)),
            new Expression.PointVelocity(center, 2));
    return oneSided(d, rate, number(force, "kt"), number(force, "ct"), number(force, "eps"));
  }

  /** kd (v0 t − x) + cd (v0 − x') of the frame's guide. */
  private Expression pull(JsonObject force) {
    int guide = scene.jointIndex(scene.jointOf(force.get("frame").getAsString()));
    Expression x = new Expression.CoordinatePosition(new JointCoordinate(guide, 0));
    Expression rate = new Expression.CoordinateVelocity(new JointCoordinate(guide, 0));
    Expression v0 = number(force, "v0");
    return plus(
        times(number(force, "kd"), minus(times(v0, new Expression.Time()), x)),
        times(number(force, "cd"), minus(v0, rate)));
  }

  private static Expression plus(Expression a, Expression b) {
    return new Expression.Sum(a, b);
  }

  private static Expression minus(Expression a, Expression b) {
    return new Expression.Sum(a, new Expression.Negation(b));
  }

  private static Expression times(Expression a, Expression b) {
    return new Expression.Product(a, b);
  }
}
