package org.mechservice.view.player;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneRope;

/** The player as one HTML page that holds the run, its program and nothing to be fetched. */
public final class PlayerPage {
  /** The page's program, each module after those that it needs. */
  private static final List<String> MODULES =
      List.of("space", "recording", "surface", "rope", "scene", "curves", "player");

  /** The function that begins the program: with a recorded run, or with a model in the page. */
  private static final String RECORDED = "main";

  private static final String LIVE = "live";

  /** Escapes {@code < > & = '}, so that no text of a model can end the element that holds it. */
  private static final Gson JSON = new GsonBuilder().serializeSpecialFloatingPointValues().create();

  private final SceneDescription scene;
  private final Stage stage;
  private final Recording recording;
  private final Point3 origin;

  private PlayerPage(SceneDescription scene, Stage stage, Recording recording) {
    this.scene = scene;
    this.stage = stage;
    this.recording = recording;
    origin = scene.root().position();
  }

  /**
   * Writes a page.
   *
   * @param scene the mechanism
   * @param stage what it looks like
   * @param recording its motion
   * @param facts what the page tells about the run: label and text, in order
   * @param events times of events, s, and their names
   * @return the page in UTF-8
   */
  public static byte[] write(
      SceneDescription scene,
      Stage stage,
      Recording recording,
      Map<String, String> facts,
      List<Event> events) {
    PlayerPage page = new PlayerPage(scene, stage, recording);
    return page.page(page.data(facts, events), RECORDED, "");
  }

  /**
   * Writes a page that simulates the model itself, again with every move of a slider.
   *
   * @param live the model; its first row of results is time, states and outputs
   * @param facts what the page tells about the model: label and text, in order
   * @return the page in UTF-8
   */
  public static byte[] writeLive(
      SceneDescription scene, Stage stage, LiveModel live, Map<String, String> facts) {
    Recording recording = new Recording();
    recording.begin(live.columns());
    // the page's own first run takes the place of this row
    recording.row(new double[live.columns().size()]);
    PlayerPage page = new PlayerPage(scene, stage, recording);
    JsonObject data = page.data(facts, List.of());
    data.add("live", live.json());
    return page.page(data, LIVE, " 'wasm-unsafe-eval'");
  }

  /**
   * Returns what a page needs to draw a mechanism in any position: its surfaces, and the columns
   * that hold the poses of its bodies; positions are counted from {@code origin}.
   *
   * @param recording has the columns; frames it holds are told too
   */
  public static JsonObject sceneJson(SceneDescription scene, Stage stage, Recording recording) {
    return new PlayerPage(scene, stage, recording).data(Map.of(), List.of());
  }

  /**
   * An event of the run.
   *
   * @param time s
   * @param name what
   */
  public record Event(double time, String name) {}

  /**
   * @param begin module that begins the program
   * @param allowed what the program may do besides, as words of the page's policy
   */
  private byte[] page(JsonObject data, String begin, String allowed) {
    String style = resource("/org/mechservice/orb/http/pages.css") + resource("player.css");
    String script =
        Stream.concat(
                Stream.of(inPage(ThreeLibrary.module())),
                Stream.concat(MODULES.stream(), Stream.of(begin))
                    .map(name -> inPage(resource(name + ".js"))))
            .collect(Collectors.joining("\n"));
    String page =
        resource("player.html")
            .replace("{{policy}}", policy(style, script, allowed))
            .replace("{{style}}", style)
            .replace("{{script}}", script)
            // last: what it holds is not looked through
            .replace("{{data}}", JSON.toJson(data));
    return page.getBytes(StandardCharsets.UTF_8);
  }

  private static String policy(String style, String script, String allowed) {
    return "default-src 'none'; script-src '"
        + hash(script)
        + "'"
        + allowed
        + "; style-src '"
        + hash(style)
        + "'; base-uri 'none'; form-action 'none'";
  }

  private static String hash(String text) {
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
      return "sha256-" + Base64.getEncoder().encodeToString(digest);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every JDK has SHA-256", e);
    }
  }

  /** Returns a module's text without the lines that join modules: the page has them all in one. */
  private static String inPage(String module) {
    return module
        .lines()
        .filter(line -> !line.startsWith("import ") && !line.startsWith("export {"))
        .map(line -> line.startsWith("export ") ? line.substring("export ".length()) : line)
        .collect(Collectors.joining("\n"));
  }

  private static String resource(String name) {
    try (InputStream in =
        Objects.requireNonNull(PlayerPage.class.getResourceAsStream(name), name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new IllegalStateException("the page's own file " + name + " cannot be read", e);
    }
  }

  private JsonObject data(Map<String, String> facts, List<Event> events) {
    JsonObject data = new JsonObject();
    data.addProperty("name", scene.name());
    data.addProperty("rootName", scene.rootName());
    data.addProperty("extent", stage.extent());
    data.add("gravity", array(scene.gravity()));
    // floats keep 7 digits: positions are counted from the root, however far from the origin it is
    data.add("origin", array(origin));
    data.add("root", pose(scene.root()));
    data.addProperty("frames", recording.frameCount());
    data.add("columns", columns());
    data.addProperty("values", values());
    data.addProperty("drift", drift());
    JsonArray bodies = new JsonArray();
    for (int i = 0; i < scene.bodies().size(); i++) {
      JsonObject body = named(scene.bodies().get(i).name());
      body.addProperty("pose", place(scene.bodies().get(i).name() + ".x"));
      body.addProperty("speed", place(scene.bodies().get(i).name() + ".vx"));
      body.addProperty("colour", Stage.colour(i));
      body.add("start", pose(scene.bodies().get(i).pose()));
      body.add("centre", array(scene.bodies().get(i).centreOfMass()));
      body.addProperty("mass", scene.bodies().get(i).mass());
      JsonArray inertia = new JsonArray();
      scene.bodies().get(i).inertia().forEach(inertia::add);
      body.add("inertia", inertia);
      bodies.add(body);
    }
    data.add("bodies", bodies);
    parts(data);
    data.add("links", links());
    data.add("ropes", ropes());
    data.add("joints", joints());
    data.add("forces", forces());
    JsonArray told = new JsonArray();
    facts.forEach(
        (label, text) -> {
          JsonArray fact = new JsonArray();
          fact.add(label);
          fact.add(text);
          told.add(fact);
        });
    data.add("facts", told);
    JsonArray happened = new JsonArray();
    for (Event event : events) {
      JsonObject one = named(event.name());
      one.addProperty("time", event.time());
      happened.add(one);
    }
    data.add("events", happened);
    return data;
  }

  private int place(String column) {
    OptionalInt place = recording.place(column);
    return place.orElse(-1);
  }

  private static JsonObject named(String name) {
    JsonObject object = new JsonObject();
    object.addProperty("name", name);
    return object;
  }

  private static JsonArray array(Point3 point) {
    JsonArray array = new JsonArray();
    array.add(point.x());
    array.add(point.y());
    array.add(point.z());
    return array;
  }

  private JsonArray pose(BodyPose pose) {
    return numbers(
        new BodyPose(pose.position().minus(origin), pose.e0(), pose.e1(), pose.e2(), pose.e3()));
  }

  private static JsonArray numbers(BodyPose pose) {
    JsonArray array = array(pose.position());
    array.add(pose.e0());
    array.add(pose.e1());
    array.add(pose.e2());
    array.add(pose.e3());
    return array;
  }

  private static JsonArray array(Anchor anchor) {
    JsonArray array = new JsonArray();
    array.add(anchor.body());
    array.addAll(array(anchor.point()));
    return array;
  }

  private JsonArray columns() {
    JsonArray columns = new JsonArray();
    for (Variable column : recording.columns()) {
      JsonArray one = new JsonArray();
      one.add(column.name());
      one.add(column.unit());
      columns.add(one);
    }
    return columns;
  }

  /** Returns the numbers column after column. */
  private String values() {
    int frames = recording.frameCount();
    int count = recording.columns().size();
    double[] subtract = new double[count];
    scene.bodies().forEach(body -> countFromRoot(body.name(), subtract));
    ByteBuffer bytes = floats(frames * count);
    for (int column = 0; column < count; column++) {
      for (int frame = 0; frame < frames; frame++) {
        bytes.putFloat((float) (recording.value(frame, column) - subtract[column]));
      }
    }
    return base64(bytes);
  }

  /**
   * Returns by how much energy differs from what it was at the start plus the work since, J, in
   * each frame; empty if the run does not have the energies. Formed here, because floats do not
   * keep the digits that the difference consists of.
   */
  private String drift() {
    int kinetic = place("energy.kinetic");
    int potential = place("energy.potential");
    int work = place("energy.work");
    if (kinetic < 0 || potential < 0 || work < 0) {
      return "";
    }
    ByteBuffer bytes = floats(recording.frameCount());
    double atStart = 0;
    for (int frame = 0; frame < recording.frameCount(); frame++) {
      double balance =
          recording.value(frame, kinetic)
              + recording.value(frame, potential)
              - recording.value(frame, work);
      atStart = frame == 0 ? balance : atStart;
      bytes.putFloat((float) (balance - atStart));
    }
    return base64(bytes);
  }

  private void countFromRoot(String body, double[] subtract) {
    int x = place(body + ".x");
    if (x >= 0) {
      subtract[x] = origin.x();
      subtract[x + 1] = origin.y();
      subtract[x + 2] = origin.z();
    }
  }

  private static ByteBuffer floats(int count) {
    return ByteBuffer.allocate(4 * count).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Returns all bytes of a buffer. */
  private static byte[] content(ByteBuffer bytes) {
    byte[] content = new byte[bytes.capacity()];
    bytes.get(0, content);
    return content;
  }

  private static String base64(ByteBuffer bytes) {
    return Base64.getEncoder().encodeToString(content(bytes));
  }

  /** Tells the surfaces, each once, and the parts that they are drawn as. */
  private void parts(JsonObject data) {
    JsonArray meshes = new JsonArray();
    JsonArray parts = new JsonArray();
    IdentityHashMap<Mesh, Integer> known = new IdentityHashMap<>();
    for (Part part : stage.parts(recording)) {
      Shape shape = part.shape();
      Integer place = known.get(shape.mesh());
      if (place == null) {
        place = meshes.size();
        known.put(shape.mesh(), place);
        meshes.add(surface(shape.mesh()));
      }
      JsonObject one = named(part.name());
      one.addProperty("mesh", place);
      one.addProperty("body", part.body());
      one.addProperty("role", part.role().name());
      one.addProperty("colour", part.colour());
      one.addProperty("opacity", part.opacity());
      one.addProperty("finish", part.finish().name());
      one.add("at", numbers(shape.at()));
      one.add("scale", array(shape.scale()));
      parts.add(one);
    }
    data.add("meshes", meshes);
    data.add("parts", parts);
  }

  private static JsonObject surface(Mesh mesh) {
    JsonObject one = new JsonObject();
    ByteBuffer corners = floats(3 * mesh.cornerCount());
    for (float number : mesh.corners()) {
      corners.putFloat(number);
    }
    one.addProperty("corners", base64(corners));
    ByteBuffer triangles = floats(3 * mesh.triangleCount());
    for (int corner : mesh.triangles()) {
      triangles.putInt(corner);
    }
    one.addProperty("triangles", base64(triangles));
    return one;
  }

  private JsonArray links() {
    JsonArray links = new JsonArray();
    for (Strut link : stage.links()) {
      JsonObject one = named(link.name());
      one.addProperty("kind", link.kind().name());
      one.addProperty("colour", link.kind().colour());
      one.addProperty("width", link.kind().width());
      one.add("from", array(link.from()));
      one.add("to", array(link.to()));
      one.addProperty("tension", place(link.name() + ".tension"));
      links.add(one);
    }
    return links;
  }

  private JsonArray ropes() {
    JsonArray ropes = new JsonArray();
    for (SceneRope rope : scene.ropes()) {
      Strut.Kind kind = rope.muscle() ? Strut.Kind.MUSCLE : Strut.Kind.ROPE;
      JsonObject one = named(rope.name());
      one.addProperty("colour", kind.colour());
      one.addProperty("width", kind.width());
      one.addProperty("tension", place(rope.name() + ".tension"));
      JsonArray stops = new JsonArray();
      rope.stops().forEach(stop -> stops.add(stop(stop)));
      one.add("stops", stops);
      JsonObject plane = new JsonObject();
      plane.addProperty("body", rope.plane().body());
      plane.add("at", numbers(rope.plane().axes()));
      one.add("plane", plane);
      ropes.add(one);
    }
    return ropes;
  }

  private static JsonObject stop(SceneRope.Stop stop) {
    JsonObject one = new JsonObject();
    if (stop instanceof SceneRope.Eye eye) {
      one.addProperty("kind", "eye");
      one.add("at", array(eye.at()));
    } else if (stop instanceof SceneRope.Pulley pulley) {
      one.addProperty("kind", "pulley");
      one.add("at", array(pulley.centre()));
      one.addProperty("radius", pulley.radius());
      one.addProperty("left", pulley.left());
      one.addProperty("held", pulley.held());
    } else if (stop instanceof SceneRope.Around shape) {
      one.addProperty("kind", "around");
      one.add("at", array(shape.centre()));
      one.addProperty("radius", shape.radius());
      one.add("axis", array(shape.axis()));
      JsonArray sides = new JsonArray();
      shape.sides().forEach(side -> sides.add(array(side)));
      one.add("sides", sides);
      one.addProperty("inside", shape.inside());
    } else {
      one.addProperty("kind", "branch");
    }
    return one;
  }

  private JsonArray joints() {
    JsonArray joints = new JsonArray();
    for (SceneJoint joint : scene.joints()) {
      JsonObject one = named(joint.name());
      one.addProperty("type", joint.type().name());
      one.addProperty("cut", joint.cut());
      one.addProperty("driven", joint.driven());
      one.add("at", array(joint.second()));
      one.addProperty("reaction", place(joint.name() + ".fx"));
      joints.add(one);
    }
    return joints;
  }

  private JsonArray forces() {
    JsonArray forces = new JsonArray();
    for (SceneForce force : scene.forces()) {
      JsonObject one = named(force.name());
      one.addProperty("kind", force.kind().name());
      JsonArray anchors = new JsonArray();
      force.anchors().forEach(anchor -> anchors.add(array(anchor)));
      one.add("anchors", anchors);
      // A contact's surface turns with its body: the normal is in the axes of this body.
      Point3 direction =
          force.kind() == SceneForce.Kind.CONTACT
              ? scene.pose(force.anchors().get(1).body()).turnBack(force.direction())
              : force.direction();
      one.add("direction", array(direction));
      one.addProperty("inBodyAxes", force.inBodyAxes());
      one.addProperty("radius", force.radius());
      one.add("axle", array(force.axle()));
      one.addProperty("force", place(force.name() + ".fx"));
      one.addProperty("normal", place(force.name() + ".normal"));
      forces.add(one);
    }
    return forces;
  }
}
