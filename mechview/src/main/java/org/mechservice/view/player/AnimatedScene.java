package org.mechservice.view.player;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntFunction;
import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.mesh.Solids;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.RopeWay;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneRope;

/**
 * A run as animated glTF 2.0 in one binary file (GLB), for Blender, browsers and office programs.
 *
 * <p>Every body is a node that its one animation translates and turns; below it are its surfaces.
 * Links between bodies are nodes of their own, a metre long and scaled. The scene's node turns the
 * model's axes to those of glTF, whose y points up, and puts the root where the origin is.
 */
public final class AnimatedScene {
  private static final int ARRAY_BUFFER = 34962;
  private static final int ELEMENT_ARRAY_BUFFER = 34963;
  private static final int FLOAT = 5126;
  private static final int UNSIGNED_INT = 5125;

  private final SceneDescription scene;
  private final Stage stage;
  private final Recording recording;
  private final List<Part> parts;
  private final ByteArrayOutputStream binary = new ByteArrayOutputStream();
  private final JsonArray nodes = new JsonArray();
  private final JsonArray meshes = new JsonArray();
  private final JsonArray materials = new JsonArray();
  private final JsonArray accessors = new JsonArray();
  private final JsonArray views = new JsonArray();
  private final JsonArray samplers = new JsonArray();
  private final JsonArray channels = new JsonArray();
  private final Map<String, Integer> materialOf = new HashMap<>();
  private final Map<Strut.Kind, Mesh> linkSurfaces = new EnumMap<>(Strut.Kind.class);
  private final IdentityHashMap<Mesh, JsonObject> surfaces = new IdentityHashMap<>();
  private final Map<Drawn, Integer> meshOf = new HashMap<>();
  private int times;

  /** A surface in a material; shapes that share both share a mesh of the file. */
  private record Drawn(int position, int material) {}

  private AnimatedScene(SceneDescription scene, Stage stage, Recording recording) {
    this.scene = scene;
    this.stage = stage;
    this.recording = recording;
    parts = stage.parts(recording);
  }

  /**
   * Writes the scene.
   *
   * @param scene the mechanism
   * @param stage what it looks like
   * @param recording its motion, at least one frame
   * @return the file
   */
  public static byte[] write(SceneDescription scene, Stage stage, Recording recording) {
    return new AnimatedScene(scene, stage, recording).file();
  }

  private byte[] file() {
    times = times();
    JsonArray children = new JsonArray();
    children.add(node(scene.rootName(), Anchor.ROOT));
    for (int body = 0; body < scene.bodies().size(); body++) {
      int animated = node(scene.bodies().get(body).name(), body);
      int index = body;
      animate(animated, "translation", 3, frame -> vector(pose(frame, index).position()));
      animate(animated, "rotation", 4, rotations(frame -> pose(frame, index)));
      children.add(animated);
    }
    stage.links().forEach(link -> children.add(link(link)));
    scene.ropes().forEach(rope -> rope(rope, children));
    JsonObject top = new JsonObject();
    top.addProperty("name", scene.name());
    top.add("rotation", numbers(upright()));
    top.add("children", children);
    nodes.add(top);
    return container(description(nodes.size() - 1));
  }

  private JsonObject description(int top) {
    JsonObject asset = new JsonObject();
    asset.addProperty("version", "2.0");
    asset.addProperty("generator", "MechService");
    JsonObject whole = new JsonObject();
    JsonArray roots = new JsonArray();
    roots.add(top);
    whole.add("nodes", roots);
    JsonObject extras = new JsonObject();
    extras.addProperty("lengthUnit", "m");
    extras.addProperty("timeUnit", "s");
    extras.addProperty("startTime", recording.value(0, 0));
    whole.add("extras", extras);
    JsonObject gltf = new JsonObject();
    gltf.add("asset", asset);
    gltf.addProperty("scene", 0);
    gltf.add("scenes", single(whole));
    gltf.add("nodes", nodes);
    if (meshes.size() > 0) {
      gltf.add("meshes", meshes);
      gltf.add("materials", materials);
    }
    gltf.add("accessors", accessors);
    gltf.add("bufferViews", views);
    if (channels.size() > 0) {
      JsonObject animation = new JsonObject();
      animation.addProperty("name", "run");
      animation.add("samplers", samplers);
      animation.add("channels", channels);
      gltf.add("animations", single(animation));
    }
    JsonObject buffer = new JsonObject();
    buffer.addProperty("byteLength", binary.size());
    gltf.add("buffers", single(buffer));
    return gltf;
  }

  private static JsonArray single(JsonObject object) {
    JsonArray array = new JsonArray();
    array.add(object);
    return array;
  }

  /** Returns the parts of the file with its header (glTF 2.0, section 4.4). */
  private byte[] container(JsonObject gltf) {
    byte[] json = new Gson().toJson(gltf).getBytes(StandardCharsets.UTF_8);
    int jsonLength = json.length + 3 & ~3;
    int length = 12 + 8 + jsonLength + 8 + binary.size();
    ByteBuffer file = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(0x46546c67).putInt(2).putInt(length);
    file.putInt(jsonLength).putInt(0x4e4f534a).put(json);
    while (file.position() < 20 + jsonLength) {
      file.put((byte) ' ');
    }
    file.putInt(binary.size()).putInt(0x004e4942).put(binary.toByteArray());
    return file.array();
  }

  private BodyPose pose(int frame, int body) {
    if (body == Anchor.ROOT) {
      return local(scene.root());
    }
    BodyPose start = scene.bodies().get(body).pose();
    return local(recording.pose(frame, scene.bodies().get(body).name(), start));
  }

  /** Returns a pose counted from the root's origin, in world axes. */
  private BodyPose local(BodyPose pose) {
    return new BodyPose(
        pose.position().minus(scene.root().position()), pose.e0(), pose.e1(), pose.e2(), pose.e3());
  }

  /** Returns the rotation that turns the direction against gravity to the y axis. */
  private double[] upright() {
    Point3 gravity = scene.gravity();
    Point3 up = gravity.norm() > 0 ? gravity.times(-1 / gravity.norm()) : new Point3(0, 0, 1);
    Point3 y = new Point3(0, 1, 0);
    Point3 axis = up.cross(y);
    double cos = up.dot(y);
    if (axis.norm() < 1e-9) {
      return cos > 0 ? new double[] {0, 0, 0, 1} : new double[] {1, 0, 0, 0};
    }
    double half = Math.acos(Math.max(-1, Math.min(1, cos))) / 2;
    Point3 turned = axis.times(Math.sin(half) / axis.norm());
    return new double[] {turned.x(), turned.y(), turned.z(), Math.cos(half)};
  }

  private int node(String name, int body) {
    JsonObject node = new JsonObject();
    node.addProperty("name", name);
    BodyPose start = pose(0, body);
    node.add("translation", numbers(vector(start.position())));
    node.add("rotation", numbers(rotation(start)));
    JsonArray children = new JsonArray();
    for (Part part : parts) {
      if (part.body() == body && part.role() != Part.Role.INERTIA) {
        JsonObject child = new JsonObject();
        child.addProperty("name", part.name());
        Shape shape = part.shape();
        child.addProperty("mesh", mesh(part.name(), shape.mesh(), part.colour(), part.opacity()));
        child.add("translation", numbers(vector(shape.at().position())));
        child.add("rotation", numbers(rotation(shape.at())));
        child.add("scale", numbers(vector(shape.scale())));
        JsonObject extras = new JsonObject();
        extras.addProperty("role", part.role().name().toLowerCase(Locale.ROOT));
        child.add("extras", extras);
        nodes.add(child);
        children.add(nodes.size() - 1);
      }
    }
    if (children.size() > 0) {
      node.add("children", children);
    }
    nodes.add(node);
    return nodes.size() - 1;
  }

  private int link(Strut link) {
    return rod(
        link.name(), link.kind(), frame -> end(frame, link.from()), frame -> end(frame, link.to()));
  }

  /** Adds the rods that a rope is drawn as, from point to point of its way. */
  private void rope(SceneRope rope, JsonArray children) {
    List<List<List<Point3>>> ways = new ArrayList<>();
    for (int frame = 0; frame < recording.frameCount(); frame++) {
      int now = frame;
      ways.add(RopeWay.of(rope, body -> pose(now, body)));
    }
    Strut.Kind kind = rope.muscle() ? Strut.Kind.MUSCLE : Strut.Kind.ROPE;
    for (int i = 0; i < ways.get(0).size(); i++) {
      int line = i;
      for (int k = 1; k < ways.get(0).get(i).size(); k++) {
        int point = k;
        children.add(
            rod(
                rope.name(),
                kind,
                frame -> ways.get(frame).get(line).get(point - 1),
                frame -> ways.get(frame).get(line).get(point)));
      }
    }
  }

  /** Adds a rod between two points in each frame. */
  private int rod(String name, Strut.Kind kind, IntFunction<Point3> from, IntFunction<Point3> to) {
    JsonObject node = new JsonObject();
    node.addProperty("name", name);
    Mesh rod =
        linkSurfaces.computeIfAbsent(kind, key -> Solids.cylinder(key.width() * stage.extent(), 1));
    node.addProperty("mesh", mesh(name, rod, kind.colour(), 1));
    nodes.add(node);
    int index = nodes.size() - 1;
    IntFunction<Point3> span = frame -> to.apply(frame).minus(from.apply(frame));
    animate(
        index,
        "translation",
        3,
        frame -> vector(from.apply(frame).plus(span.apply(frame).times(0.5))));
    animate(index, "rotation", 4, rotations(frame -> along(span.apply(frame))));
    animate(
        index, "scale", 3, frame -> new double[] {1, 1, Math.max(1e-9, span.apply(frame).norm())});
    return index;
  }

  private Point3 end(int frame, Anchor anchor) {
    return pose(frame, anchor.body()).toWorld(anchor.point());
  }

  private static BodyPose along(Point3 span) {
    double length = span.norm();
    return length > 0 ? Solids.zAlong(span.times(1 / length), Point3.ZERO) : BodyPose.WORLD;
  }

  private static double[] vector(Point3 point) {
    return new double[] {point.x(), point.y(), point.z()};
  }

  /** Returns x, y, z, w of a pose's unit quaternion. */
  private static double[] rotation(BodyPose pose) {
    double e0 = pose.e0();
    double norm =
        Math.sqrt(e0 * e0 + pose.e1() * pose.e1() + pose.e2() * pose.e2() + pose.e3() * pose.e3());
    return new double[] {pose.e1() / norm, pose.e2() / norm, pose.e3() / norm, e0 / norm};
  }

  /** Returns quaternions of which each is on the side of the one before: viewers go between. */
  private static IntFunction<double[]> rotations(IntFunction<BodyPose> poses) {
    double[] before = {0, 0, 0, 1};
    return frame -> {
      double[] now = rotation(poses.apply(frame));
      double dot = 0;
      for (int i = 0; i < 4; i++) {
        dot += now[i] * before[i];
      }
      for (int i = 0; i < 4; i++) {
        now[i] = dot < 0 ? -now[i] : now[i];
        before[i] = now[i];
      }
      return now;
    };
  }

  private static JsonArray numbers(double... values) {
    JsonArray array = new JsonArray();
    for (double value : values) {
      array.add((float) value);
    }
    return array;
  }

  private int times() {
    int frames = recording.frameCount();
    double start = recording.value(0, 0);
    ByteBuffer bytes = buffer(frames);
    float before = -1;
    for (int frame = 0; frame < frames; frame++) {
      // strictly increasing, also where floats cannot tell two rows apart
      float time = (float) (recording.value(frame, 0) - start);
      before = time > before ? time : Math.nextUp(before);
      bytes.putFloat(before);
    }
    int accessor = accessor(bytes, 0, FLOAT, "SCALAR", frames);
    JsonObject bounds = accessors.get(accessor).getAsJsonObject();
    bounds.add("min", numbers(bytes.getFloat(0)));
    bounds.add("max", numbers(before));
    return accessor;
  }

  private void animate(int node, String path, int size, IntFunction<double[]> values) {
    int frames = recording.frameCount();
    ByteBuffer bytes = buffer(size * frames);
    for (int frame = 0; frame < frames; frame++) {
      for (double value : values.apply(frame)) {
        bytes.putFloat((float) value);
      }
    }
    JsonObject sampler = new JsonObject();
    sampler.addProperty("input", times);
    sampler.addProperty("interpolation", "LINEAR");
    sampler.addProperty("output", accessor(bytes, 0, FLOAT, "VEC" + size, frames));
    samplers.add(sampler);
    JsonObject target = new JsonObject();
    target.addProperty("node", node);
    target.addProperty("path", path);
    JsonObject channel = new JsonObject();
    channel.addProperty("sampler", samplers.size() - 1);
    channel.add("target", target);
    channels.add(channel);
  }

  private int mesh(String name, Mesh mesh, int colour, double opacity) {
    JsonObject surface = surfaces.computeIfAbsent(mesh, this::surface);
    int material = material(colour, opacity);
    JsonObject primitive = surface.deepCopy();
    primitive.addProperty("material", material);
    int position = primitive.getAsJsonObject("attributes").get("POSITION").getAsInt();
    return meshOf.computeIfAbsent(
        new Drawn(position, material),
        key -> {
          JsonObject one = new JsonObject();
          one.addProperty("name", name);
          one.add("primitives", single(primitive));
          meshes.add(one);
          return meshes.size() - 1;
        });
  }

  /** Writes a surface and returns where it is. */
  private JsonObject surface(Mesh mesh) {
    float[] corners = mesh.corners();
    ByteBuffer positions = buffer(corners.length);
    float[] least = {Float.MAX_VALUE, Float.MAX_VALUE, Float.MAX_VALUE};
    float[] most = {-Float.MAX_VALUE, -Float.MAX_VALUE, -Float.MAX_VALUE};
    for (int i = 0; i < corners.length; i++) {
      positions.putFloat(corners[i]);
      least[i % 3] = Math.min(least[i % 3], corners[i]);
      most[i % 3] = Math.max(most[i % 3], corners[i]);
    }
    int position = accessor(positions, ARRAY_BUFFER, FLOAT, "VEC3", mesh.cornerCount());
    JsonObject bounds = accessors.get(position).getAsJsonObject();
    bounds.add("min", numbers(least[0], least[1], least[2]));
    bounds.add("max", numbers(most[0], most[1], most[2]));
    int[] triangles = mesh.triangles();
    ByteBuffer indices = buffer(triangles.length);
    for (int corner : triangles) {
      indices.putInt(corner);
    }
    JsonObject attributes = new JsonObject();
    attributes.addProperty("POSITION", position);
    JsonObject surface = new JsonObject();
    surface.add("attributes", attributes);
    surface.addProperty(
        "indices",
        accessor(indices, ELEMENT_ARRAY_BUFFER, UNSIGNED_INT, "SCALAR", triangles.length));
    return surface;
  }

  private int material(int colour, double opacity) {
    return materialOf.computeIfAbsent(
        colour + "/" + opacity,
        key -> {
          JsonObject surface = new JsonObject();
          surface.add(
              "baseColorFactor",
              numbers(linear(colour >> 16), linear(colour >> 8), linear(colour), opacity));
          surface.addProperty("metallicFactor", 0.1);
          surface.addProperty("roughnessFactor", 0.6);
          JsonObject material = new JsonObject();
          material.add("pbrMetallicRoughness", surface);
          material.addProperty("doubleSided", true);
          if (opacity < 1) {
            material.addProperty("alphaMode", "BLEND");
          }
          materials.add(material);
          return materials.size() - 1;
        });
  }

  /** Returns the intensity of an sRGB channel. */
  private static double linear(int channel) {
    double c = (channel & 0xff) / 255.0;
    return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
  }

  private static ByteBuffer buffer(int numbers) {
    return ByteBuffer.allocate(4 * numbers).order(ByteOrder.LITTLE_ENDIAN);
  }

  private int accessor(ByteBuffer bytes, int target, int component, String type, int count) {
    JsonObject view = new JsonObject();
    view.addProperty("buffer", 0);
    view.addProperty("byteOffset", binary.size());
    view.addProperty("byteLength", bytes.capacity());
    if (target != 0) {
      view.addProperty("target", target);
    }
    views.add(view);
    byte[] content = new byte[bytes.capacity()];
    bytes.get(0, content);
    binary.writeBytes(content);
    JsonObject accessor = new JsonObject();
    accessor.addProperty("bufferView", views.size() - 1);
    accessor.addProperty("componentType", component);
    accessor.addProperty("type", type);
    accessor.addProperty("count", count);
    accessors.add(accessor);
    return accessors.size() - 1;
  }
}
