package org.mechservice.sim.model;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** The scenes of the tests: reference scenes as JSON, timing models as tables. */
public final class Scenes {
  /** Settings of the five-bar pendulum's file. */
  public static final RunSettings SETTINGS = new RunSettings(0, 3, 0.01, "DE", 1e-5, 1e-5);

  /** Scenes and timing models that the solver's tests read as well. */
  private static final String SOLVER = "/org/mechservice/solver/";

  private static final Root ROOT = new Root("Ground", Vector3.ZERO, Rotation.IDENTITY);

  private Scenes() {}

  /** Returns a model with the default settings. */
  public static MechmlModel model(Mechanism mechanism) {
    return new MechmlModel(mechanism, new SimulationSettings(SETTINGS, "auto"), List.of());
  }

  /** Returns the text of a test resource that stands beside this class. */
  public static String text(String name) {
    try (InputStream stream = Scenes.class.getResourceAsStream(name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns a reference scene or its solution as JSON. */
  public static JsonObject json(String name) {
    return JsonParser.parseString(text(SOLVER + "scenes/" + name)).getAsJsonObject();
  }

  /** Returns the mechanism of a reference scene, under another name if one is given. */
  public static Mechanism scene(String resource, String name) {
    JsonObject scene = json(resource);
    List<Body> bodies = new ArrayList<>();
    Map<String, Integer> index = new HashMap<>(Map.of("Ground", Mechanism.ROOT));
    for (JsonElement element : scene.getAsJsonArray("bodies")) {
      JsonObject body = element.getAsJsonObject();
      index.put(body.get("name").getAsString(), bodies.size());
      bodies.add(
          new Body(
              body.get("name").getAsString(),
              body.get("mass").getAsDouble(),
              vector(body.getAsJsonArray("cog")),
              inertia(numbers(body.getAsJsonArray("inertia")), 0),
              Origin.NONE));
    }
    List<Joint> joints = new ArrayList<>();
    for (JsonElement element : scene.getAsJsonArray("joints")) {
      joints.add(joint(element.getAsJsonObject(), index));
    }
    return new Mechanism(name, ROOT, vector(scene.getAsJsonArray("gravity")), bodies, joints);
  }

  private static Joint joint(JsonObject joint, Map<String, Integer> index) {
    Attachment attachment =
        new Attachment(
            body(index, joint.get("body1")),
            vector(joint.getAsJsonArray("point1")),
            body(index, joint.get("body2")),
            vector(joint.getAsJsonArray("point2")),
            Rotation.IDENTITY);
    return joint(
        joint.get("name").getAsString(),
        joint.get("type").getAsString(),
        attachment,
        vector(joint.getAsJsonArray("axis")),
        numbers(joint.getAsJsonArray("q0"))[0],
        numbers(joint.getAsJsonArray("v0"))[0]);
  }

  private static int body(Map<String, Integer> index, JsonElement name) {
    return Objects.requireNonNull(index.get(name.getAsString()), "no such body");
  }

  /** Returns a turning (R) or sliding (P) joint. */
  public static Joint joint(
      String name, String type, Attachment attachment, Vector3 axis, double q, double v) {
    Vector3 unit = axis.normalized();
    return type.equals("R")
        ? new Revolute(name, attachment, unit, q, v, Origin.NONE)
        : new Prismatic(name, attachment, unit, q, v, Origin.NONE);
  }

  /** The five-bar pendulum of the paper. */
  public static Mechanism pendulum() {
    return scene("pendulum5.json", "FiveBarPendulum");
  }

  /**
   * A timing model: one body a line, with the state and the joint forces it is to be evaluated at.
   *
   * @param mechanism the model
   * @param input q, v and joint forces
   * @param accelerations joint accelerations computed by Pinocchio
   */
  @SuppressWarnings("ArrayRecordComponent") // read by the tests, never changed
  public record TimingModel(Mechanism mechanism, double[] input, double[] accelerations) {}

  /** Reads a timing model. */
  public static TimingModel timingModel(String name) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    List<String[]> lines =
        text(SOLVER + "dynamics/" + name + ".csv")
            .lines()
            .filter(line -> !line.startsWith("#"))
            .map(Scenes::cells)
            .toList();
    double[] input = new double[3 * lines.size()];
    for (String[] cells : lines) {
      double[] x = new double[cells.length];
      for (int i = 3; i < x.length; i++) {
        x[i] = Double.parseDouble(cells[i]);
      }
      int i = bodies.size();
      bodies.add(
          new Body(cells[0], x[9], new Vector3(x[10], x[11], x[12]), inertia(x, 13), Origin.NONE));
      Attachment attachment =
          new Attachment(
              Integer.parseInt(cells[1]),
              new Vector3(x[6], x[7], x[8]),
              i,
              Vector3.ZERO,
              Rotation.IDENTITY);
      joints.add(
          joint(
              "j_" + cells[0], cells[2], attachment, new Vector3(x[3], x[4], x[5]), x[19], x[20]));
      input[i] = x[19];
      input[lines.size() + i] = x[20];
      input[2 * lines.size() + i] = x[21];
    }
    double[] reference =
        text(SOLVER + "dynamics/" + name + ".ref")
            .lines()
            .mapToDouble(Double::parseDouble)
            .toArray();
    Vector3 gravity = new Vector3(0, 0, -9.81);
    return new TimingModel(new Mechanism(name, ROOT, gravity, bodies, joints), input, reference);
  }

  private static String[] cells(String line) {
    return line.split(" ", -1);
  }

  private static InertiaTensor inertia(double[] x, int offset) {
    return new InertiaTensor(
        x[offset], x[offset + 1], x[offset + 2], x[offset + 3], x[offset + 4], x[offset + 5]);
  }

  private static Vector3 vector(JsonArray array) {
    double[] x = numbers(array);
    return new Vector3(x[0], x[1], x[2]);
  }

  /** Returns the numbers of a JSON array. */
  public static double[] numbers(JsonArray array) {
    double[] numbers = new double[array.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = array.get(i).getAsDouble();
    }
    return numbers;
  }
}
