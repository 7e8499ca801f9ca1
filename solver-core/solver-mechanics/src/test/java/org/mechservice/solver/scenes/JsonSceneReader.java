package org.mechservice.solver.scenes;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.oracle.OracleForce;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Makes a mechanism of a scene's JSON form (README.md beside the scenes). */
final class JsonSceneReader {
  private final JsonObject scene;
  private final List<String> bodyNames = new ArrayList<>();
  private final List<String> jointNames = new ArrayList<>();

  JsonSceneReader(JsonObject scene) {
    this.scene = scene;
    scene
        .getAsJsonArray("bodies")
        .forEach(b -> bodyNames.add(b.getAsJsonObject().get("name").getAsString()));
    scene
        .getAsJsonArray("joints")
        .forEach(j -> jointNames.add(j.getAsJsonObject().get("name").getAsString()));
  }

  Mechanism mechanism() {
    List<ForceElement> forces = new ArrayList<>();
    SceneForces sceneForces = new SceneForces(this);
    for (JsonObject force : objects("forces")) {
      forces.addAll(sceneForces.elements(force));
    }
    return new Mechanism(
        scene.get("name").getAsString(),
        new Root("Ground", Vector3.ZERO, Rotation.IDENTITY),
        vector(scene, "gravity"),
        objects("bodies").stream().map(JsonSceneReader::body).toList(),
        objects("joints").stream().map(this::joint).toList(),
        List.of(),
        Collections.nCopies(jointNames.size(), StartRole.PREFERRED),
        objects("constraints").stream().map(this::closure).toList(),
        forces,
        List.of());
  }

  List<OracleForce> oracleForces() {
    OracleForces oracle = new OracleForces(this);
    return objects("forces").stream().map(oracle::force).toList();
  }

  private List<JsonObject> objects(String key) {
    List<JsonObject> objects = new ArrayList<>();
    if (scene.has(key)) {
      scene.getAsJsonArray(key).forEach(element -> objects.add(element.getAsJsonObject()));
    }
    return objects;
  }

  private static Body body(JsonObject body) {
    double[] i = numbers(body, "inertia");
    return new Body(
        body.get("name").getAsString(),
        body.get("mass").getAsDouble(),
        vector(body, "cog"),
        new InertiaTensor(i[0], i[1], i[2], i[3], i[4], i[5]),
        Origin.NONE);
  }

  private Attachment attachment(JsonObject between) {
    return new Attachment(
        bodyIndex(between.get("body1").getAsString()),
        vector(between, "point1"),
        bodyIndex(between.get("body2").getAsString()),
        vector(between, "point2"),
        Rotation.IDENTITY);
  }

  private Joint joint(JsonObject joint) {
    String name = joint.get("name").getAsString();
    Attachment attachment = attachment(joint);
    double[] q = numbers(joint, "q0");
    double[] v = numbers(joint, "v0");
    return switch (joint.get("type").getAsString()) {
      case "R" ->
          new Revolute(
              name, attachment, vector(joint, "axis").normalized(), q[0], v[0], Origin.NONE);
      case "P" ->
          new Prismatic(
              name, attachment, vector(joint, "axis").normalized(), q[0], v[0], Origin.NONE);
      case "S" -> new Spherical(name, attachment, start(q, v), false, Origin.NONE);
      case "F" -> new Free(name, attachment, start(q, v), false, Origin.NONE);
      default -> throw new IllegalArgumentException("joint " + name);
    };
  }

  private static JointStart start(double[] q, double[] v) {
    List<Double> positions = new ArrayList<>();
    List<Double> velocities = new ArrayList<>();
    for (double value : q) {
      positions.add(value);
    }
    for (double value : v) {
      velocities.add(value);
    }
    return new JointStart(positions, velocities);
  }

  private LoopClosure closure(JsonObject closure) {
    String name = closure.get("name").getAsString();
    return switch (closure.get("type").getAsString()) {
      case "DIST" ->
          new DistanceClosure(
              name,
              point(closure, "1"),
              point(closure, "2"),
              Math.sqrt(closure.get("distSquared").getAsDouble()),
              closure.has("rodMass") ? closure.get("rodMass").getAsDouble() : 0,
              Origin.NONE);
      case "REVOLUTE" ->
          new JointClosure(
              new Revolute(
                  name,
                  attachment(closure),
                  vector(closure, "axis1").normalized(),
                  0,
                  0,
                  Origin.NONE));
      case "POINT" -> pointClosure(closure, name);
      default -> throw new IllegalArgumentException("constraint " + name);
    };
  }

  /**
   * Points that agree in the listed world coordinates: on a line or in a plane of body 2. The axes
   * of body 2 that matter are those of the world in these scenes, which are planar.
   */
  private LoopClosure pointClosure(JsonObject closure, String name) {
    BodyPoint point = point(closure, "1");
    BodyPoint on = point(closure, "2");
    Vector3 x = new Vector3(1, 0, 0);
    Vector3 y = new Vector3(0, 1, 0);
    Vector3 z = new Vector3(0, 0, 1);
    return switch (closure.get("coords").getAsString()) {
      case "xy" -> new PointOnLineClosure(name, point, on, z, Origin.NONE);
      case "xz" -> new PointOnLineClosure(name, point, on, y, Origin.NONE);
      case "yz" -> new PointOnLineClosure(name, point, on, x, Origin.NONE);
      case "y" -> new PointOnPlaneClosure(name, point, on, y, Origin.NONE);
      default -> throw new IllegalArgumentException("constraint " + name);
    };
  }

  BodyPoint point(JsonObject of, String number) {
    return new BodyPoint(
        bodyIndex(of.get("body" + number).getAsString()), vector(of, "point" + number));
  }

  int bodyIndex(String name) {
    int index = bodyNames.indexOf(name);
    if (index < 0 && !name.equals("Ground")) {
      throw new IllegalArgumentException("body " + name);
    }
    return index;
  }

  int jointIndex(String name) {
    return jointNames.indexOf(name);
  }

  /** Returns a joint's JSON form. */
  JsonObject jointNamed(String name) {
    return objects("joints").get(jointIndex(name));
  }

  /** Returns the name of the joint whose outer body has a name. */
  String jointOf(String body) {
    for (JsonObject joint : objects("joints")) {
      if (joint.get("body2").getAsString().equals(body)) {
        return joint.get("name").getAsString();
      }
    }
    throw new IllegalArgumentException("body " + body);
  }

  static Vector3 vector(JsonObject of, String key) {
    double[] v = numbers(of, key);
    return new Vector3(v[0], v[1], v[2]);
  }

  static double[] numbers(JsonObject of, String key) {
    JsonArray array = of.getAsJsonArray(key);
    double[] numbers = new double[array.size()];
    int i = 0;
    for (JsonElement element : array) {
      numbers[i++] = element.getAsDouble();
    }
    return numbers;
  }
}
