package org.mechservice.solver.scenes;

import com.google.gson.JsonObject;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.oracle.OracleForce;
import org.mechservice.solver.oracle.TaylorPose;
import org.mechservice.solver.oracle.TaylorVector;
import org.mechservice.solver.spatial.Vector3;

/**
 * The forces of the scenes once more, written for the oracle from the README.md beside the scenes.
 */
final class OracleForces {
  private final JsonSceneReader scene;

  OracleForces(JsonSceneReader scene) {
    this.scene = scene;
  }

  OracleForce force(JsonObject force) {
    return switch (force.get("type").getAsString()) {
      case "jointSpringDamper" -> jointSpring(force);
      case "springDamper" -> spring(force);
      case "fpsRoad" -> road(force);
      default ->
          (t, pose, loads) -> {
            throw new IllegalStateException("the oracle does not know " + force);
          };
    };
  }

  private static double number(JsonObject of, String key) {
    return of.get(key).getAsDouble();
  }

  /** A couple about the axis of a turning joint. */
  private OracleForce jointSpring(JsonObject force) {
    JsonObject joint = scene.jointNamed(force.get("joint").getAsString());
    if (number(force, "k") != 0 || number(force, "c") != 0) {
      return (t, pose, loads) -> {
        throw new IllegalStateException("the oracle knows constant torques alone, not " + force);
      };
    }
    int inner = scene.bodyIndex(joint.get("body1").getAsString());
    int outer = scene.bodyIndex(joint.get("body2").getAsString());
    Vector3 axis = JsonSceneReader.vector(joint, "axis").normalized();
    return (t, pose, loads) -> {
      Vector3 torque = pose.apply(inner).rotation().apply(axis).value().times(number(force, "tau"));
      loads.moment(outer, torque);
      loads.moment(inner, torque.negated());
    };
  }

  private OracleForce spring(JsonObject force) {
    BodyPoint p1 = scene.point(force, "1");
    BodyPoint p2 = scene.point(force, "2");
    return (t, pose, loads) -> {
      TaylorVector line =
          pose.apply(p2.body()).at(p2.position()).minus(pose.apply(p1.body()).at(p1.position()));
      double length = line.value().norm();
      Vector3 direction = line.value().times(1 / length);
      double rate = direction.dot(line.rate());
      double tension =
          number(force, "F0")
              + number(force, "k") * (length - number(force, "L0"))
              + number(force, "c") * rate;
      loads.force(p1, direction.times(tension));
      loads.force(p2, direction.times(-tension));
    };
  }

  private OracleForce road(JsonObject force) {
    int wheel = scene.bodyIndex(force.get("wheel").getAsString());
    int carrier = scene.bodyIndex(force.get("carrier").getAsString());
    int frame = scene.bodyIndex(force.get("frame").getAsString());
    JsonObject spinJoint = scene.jointNamed(scene.jointOf(force.get("wheel").getAsString()));
    Vector3 axis = JsonSceneReader.vector(spinJoint, "axis").normalized();
    Vector3 hub = JsonSceneReader.vector(force, "pointWheel");
    return (t, pose, loads) -> {
      TaylorPose onWheel = pose.apply(wheel);
      TaylorVector center = onWheel.at(hub);
      Vector3 relative =
          onWheel
              .rotation()
              .angularVelocity()
              .minus(pose.apply(carrier).rotation().angularVelocity());
      double spin = relative.dot(pose.apply(carrier).rotation().apply(axis).value());
      double rl = number(force, "Rl");
      Vector3 tyre =
          new Vector3(
              number(force, "cx") * (rl * spin - center.rate().x()), 0, push(force, center));
      loads.force(new BodyPoint(wheel, hub), tyre);
      loads.moment(wheel, new Vector3(0, 0, -rl).cross(tyre));
      // the frame's guide is along x from its place at the start
      TaylorVector origin = pose.apply(frame).at(Vector3.ZERO);
      Vector3 start =
          JsonSceneReader.vector(
              scene.jointNamed(scene.jointOf(force.get("frame").getAsString())), "point1");
      double v0 = number(force, "v0");
      double pull =
          number(force, "kd") * (v0 * t - (origin.value().x() - start.x()))
              + number(force, "cd") * (v0 - origin.rate().x());
      loads.force(new BodyPoint(frame, Vector3.ZERO), new Vector3(pull, 0, 0));
    };
  }

  private static double push(JsonObject force, TaylorVector center) {
    double h = 0;
    double slope = 0;
    for (double at : JsonSceneReader.numbers(force, "xs")) {
      double tanh = StrictMath.tanh((center.value().x() - at) / number(force, "w"));
      h += number(force, "H") / 2 * (1 + tanh);
      slope += number(force, "H") / 2 * (1 - tanh * tanh) / number(force, "w");
    }
    double d = number(force, "R0") - (center.value().z() + number(force, "Rl") - h);
    double rate = -(center.rate().z() - slope * center.rate().x());
    double root = Math.sqrt(d * d + number(force, "eps") * number(force, "eps"));
    return number(force, "kt") * (d + root) / 2 + number(force, "ct") * rate * (1 + d / root) / 2;
  }
}
