package org.mechservice.robot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.OwnShape;
import org.mechservice.robot.Robot.Visual;
import org.mechservice.robot.TriangleMesh.Spread;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Mass and inertia of the shapes of an MJCF model: spheres, capsules, cylinders, boxes, ellipsoids
 * and meshes of even density, by default 1000 kg/m³, or shells of an even surface density. Source:
 * MuJoCo documentation, XML reference, {@code geom} and {@code mesh}.
 */
final class MjcfGeometry {
  private static final double WATER = 1000;

  /** Groups from this one on are hidden in MuJoCo's window at first. */
  private static final double HIDDEN = 3;

  private final MjcfCompiler compiler;
  private final RobotNumbers numbers;
  private final Diagnostics diagnostics;
  private final ImportLosses losses;
  private final RobotFiles files;
  private final Path folder;
  private final Map<String, Element> meshes = new HashMap<>();
  private final Map<String, Element> materials = new HashMap<>();
  private final Map<String, Optional<TriangleMesh>> read = new HashMap<>();
  private final int[] groups;

  MjcfGeometry(
      MjcfFile file,
      MjcfCompiler compiler,
      RobotFiles files,
      RobotNumbers numbers,
      Diagnostics diagnostics,
      ImportLosses losses) {
    this.compiler = compiler;
    this.numbers = numbers;
    this.diagnostics = diagnostics;
    this.losses = losses;
    this.files = files;
    folder = file.folder();
    groups = compiler.inertiaGroups();
    for (Element mesh : file.all("asset")) {
      if (mesh.name().equals("mesh")) {
        meshes.put(nameOf(mesh), mesh);
      } else if (mesh.name().equals("material")) {
        mesh.attribute("name").ifPresent(name -> materials.put(name, mesh));
      }
    }
  }

  /** A mesh without a name has that of its file, without folder and ending. */
  private static String nameOf(Element mesh) {
    return mesh.attribute("name")
        .orElseGet(
            () ->
                mesh.attribute("file")
                    .orElse("")
                    .replaceFirst(".*[/\\\\]", "")
                    .replaceFirst("\\.[^.]*$", ""));
  }

  /** A shape in a body: its element and the frame in the body that its pose is in. */
  record Held(Element element, Frame frame) {}

  /**
   * Returns the inertia of the shapes of a body; empty if none has mass.
   *
   * @param body for messages
   */
  Optional<Inertial> inertial(Element body, List<Held> shapes) {
    ShapeMasses masses = new ShapeMasses();
    for (Held held : shapes) {
      double group = numbers.optional(held.element(), "group", 0);
      if (group >= groups[0] && group <= groups[1]) {
        add(masses, held);
      }
    }
    return masses.inertial(body);
  }

  /**
   * Returns what a body looks like: the groups of shapes that MuJoCo's window shows at first, or
   * all where those are none.
   */
  List<Visual> visuals(List<Held> shapes) {
    List<Held> shown =
        shapes.stream()
            .filter(held -> numbers.optional(held.element(), "group", 0) < HIDDEN)
            .toList();
    List<Visual> all = new ArrayList<>();
    for (Held held : shown.isEmpty() ? shapes : shown) {
      surface(held.element())
          .ifPresent(
              mesh ->
                  all.add(
                      new Visual(
                          held.element(),
                          held.frame().times(placed(held.element())),
                          new OwnShape(mesh),
                          colour(held.element()))));
    }
    return all;
  }

  /** Returns the frame of a shape, as far as its mesh does not move it. */
  Frame placed(Element geometry) {
    List<Double> e =
        geometry
            .attribute("fromto")
            .map(text -> numbers.read(geometry, "fromto", text, 6, 6))
            .orElse(List.of());
    if (e.isEmpty()) {
      return compiler.frame(geometry);
    }
    Vector3 from = new Vector3(e.get(0), e.get(1), e.get(2));
    Vector3 to = new Vector3(e.get(3), e.get(4), e.get(5));
    Vector3 along = from.minus(to);
    return new Frame(
        from.plus(to).times(0.5),
        along.norm() > 0 ? MjcfCompiler.least(along.normalized()) : Rotation.IDENTITY);
  }

  private Optional<TriangleMesh> surface(Element geometry) {
    String mesh = geometry.attribute("mesh").orElse("");
    Element asset = meshes.get(mesh);
    if (asset != null) {
      return read.computeIfAbsent(mesh, key -> mesh(asset));
    }
    List<Double> size =
        geometry
            .attribute("size")
            .map(text -> numbers.read(geometry, "size", text, 1, 3))
            .orElse(List.of(0.0));
    List<Double> e =
        geometry
            .attribute("fromto")
            .map(text -> numbers.read(geometry, "fromto", text, 6, 6))
            .orElse(List.of());
    boolean ended = !e.isEmpty();
    double half =
        ended
            ? new Vector3(e.get(0) - e.get(3), e.get(1) - e.get(4), e.get(2) - e.get(5)).norm() / 2
            : size.get(Math.min(1, size.size() - 1));
    double r = size.get(0);
    Vector3 axes =
        ended
            ? new Vector3(r, r, half)
            : new Vector3(r, size.get(Math.min(1, size.size() - 1)), size.get(size.size() - 1));
    return switch (geometry.attribute("type").orElse("sphere")) {
      case "sphere" -> Optional.of(Surfaces.ellipsoid(new Vector3(r, r, r)));
      case "capsule" -> Optional.of(Surfaces.capsule(r, 2 * half));
      case "cylinder" -> Optional.of(Surfaces.cylinder(r, 2 * half));
      case "box" -> Optional.of(Surfaces.box(axes.times(2)));
      case "ellipsoid" -> Optional.of(Surfaces.ellipsoid(axes));
      default -> Optional.empty(); // planes have no end
    };
  }

  /** The colour of a shape is its own, or that of its material. */
  private Optional<List<Double>> colour(Element geometry) {
    Element material = materials.get(geometry.attribute("material").orElse(""));
    return rgba(geometry).or(() -> material == null ? Optional.empty() : rgba(material));
  }

  private Optional<List<Double>> rgba(Element element) {
    return element.attribute("rgba").map(text -> numbers.read(element, "rgba", text, 4, 4));
  }

  private void add(ShapeMasses masses, Held held) {
    Element geometry = held.element();
    String type = geometry.attribute("type").orElse("sphere");
    Optional<Double> given =
        geometry.attribute("mass").map(text -> numbers.optional(geometry, "mass", 0));
    double density = numbers.optional(geometry, "density", WATER);
    if (given.orElse(density) == 0 || type.equals("plane") || type.equals("hfield")) {
      return;
    }
    boolean shell = geometry.attribute("shellinertia").filter("true"::equals).isPresent();
    Frame frame = compiler.frame(geometry);
    Optional<UniformShape> shape;
    if (type.equals("mesh") || (type.equals("sdf") && geometry.attribute("mesh").isPresent())) {
      shape = meshShape(geometry, shell);
    } else if (geometry.attribute("mesh").isPresent()) {
      losses.motion(geometry, "its mass is left out: a " + type + " that is fitted to a mesh");
      return;
    } else {
      Optional<List<Double>> ends =
          geometry.attribute("fromto").map(text -> numbers.read(geometry, "fromto", text, 6, 6));
      Optional<Double> half = Optional.empty();
      if (ends.isPresent()) {
        requireEnds(geometry, type);
        List<Double> e = ends.get();
        Vector3 from = new Vector3(e.get(0), e.get(1), e.get(2));
        Vector3 to = new Vector3(e.get(3), e.get(4), e.get(5));
        // MuJoCo's z axis points from the second end to the first; boxes and ellipsoids feel it.
        Vector3 along = from.minus(to);
        if (!(along.norm() > 0)) {
          numbers.contradiction(geometry, "its two ends are one point");
          return;
        }
        half = Optional.of(along.norm() / 2);
        frame = new Frame(from.plus(to).times(0.5), MjcfCompiler.least(along.normalized()));
      }
      shape = primitive(geometry, type, half, shell);
    }
    if (shape.isPresent()) {
      double mass = given.orElse(density * shape.get().volume());
      masses.add(held.frame().times(frame), mass, shape.get());
    }
  }

  private void requireEnds(Element geometry, String type) {
    if (!Set.of("capsule", "cylinder", "box", "ellipsoid").contains(type)) {
      numbers.contradiction(geometry, "a " + type + " has no two ends (fromto)");
    }
    if (geometry.attribute("pos").isPresent()) {
      numbers.contradiction(geometry, "it has two ends (fromto) and a place (pos); leave one");
    }
  }

  private Optional<UniformShape> primitive(
      Element geometry, String type, Optional<Double> half, boolean shell) {
    List<Double> size =
        geometry
            .attribute("size")
            .map(text -> numbers.read(geometry, "size", text, 1, 3))
            .orElse(List.of());
    boolean thick = type.equals("box") || type.equals("ellipsoid");
    int needed = type.equals("sphere") || (half.isPresent() && !thick) ? 1 : 2;
    needed = thick ? (half.isPresent() ? 1 : 3) : needed;
    if (size.size() < needed) {
      numbers.missing(geometry, "attribute size with " + needed + " numbers for type " + type);
      return Optional.empty();
    }
    double a = size.get(0);
    // Between two ends the first size holds across in both directions.
    double b = half.isPresent() && thick ? a : size.get(Math.min(1, size.size() - 1));
    double c = half.orElse(size.get(size.size() - 1));
    double h = half.orElse(b);
    return switch (type) {
      case "sphere" ->
          Optional.of(shell ? UniformShape.sphereShell(a) : UniformShape.ellipsoid(a, a, a));
      case "box" -> Optional.of(shell ? UniformShape.boxShell(a, b, c) : UniformShape.box(a, b, c));
      case "cylinder" ->
          Optional.of(shell ? UniformShape.cylinderShell(a, h) : UniformShape.cylinder(a, h));
      case "capsule" ->
          Optional.of(shell ? UniformShape.capsuleShell(a, h) : UniformShape.capsule(a, h));
      case "ellipsoid" -> {
        if (shell) {
          losses.motion(geometry, "its shell is taken as a solid: ellipsoids have no formula");
        }
        yield Optional.of(UniformShape.ellipsoid(a, b, c));
      }
      default -> {
        diagnostics.error(
            MessageCode.VALUE_NOT_IN_LIST,
            geometry.position(),
            Phrase.of("%s: type %s is not known", geometry.label(), Quoted.of(type)));
        yield Optional.empty();
      }
    };
  }

  private Optional<UniformShape> meshShape(Element geometry, boolean shell) {
    String name = geometry.attribute("mesh").orElse("");
    Element asset = meshes.get(name);
    if (asset == null) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          geometry.position(),
          Phrase.of(
              "%s: mesh %s does not exist%s",
              geometry.label(), Quoted.of(name), NearestName.suggestion(name, meshes.keySet())));
      return Optional.empty();
    }
    Optional<TriangleMesh> mesh = read.computeIfAbsent(name, key -> mesh(asset));
    if (mesh.isEmpty()) {
      losses.motion(
          geometry, "its mass is left out, because its mesh " + Quoted.of(name) + " is not read");
      return Optional.empty();
    }
    Spread spread =
        switch (asset.attribute("inertia").orElse("legacy")) {
          case "convex" -> Spread.CONVEX;
          case "exact" -> Spread.EXACT;
          case "shell" -> Spread.SHELL;
          default -> Spread.LEGACY;
        };
    UniformShape shape = mesh.get().shape(shell ? Spread.SHELL : spread);
    if (!(shape.volume() > 0)) {
      losses.motion(geometry, "its mass is left out, because its mesh encloses nothing");
      return Optional.empty();
    }
    return Optional.of(shape);
  }

  /** Returns a mesh in the frame of its shape. */
  private Optional<TriangleMesh> mesh(Element asset) {
    Optional<TriangleMesh> raw =
        asset.attribute("vertex").isPresent() ? Optional.of(written(asset)) : fromFile(asset);
    Vector3 scale = numbers.vector(asset, "scale", new Vector3(1, 1, 1));
    Vector3 at = numbers.vector(asset, "refpos", Vector3.ZERO);
    Rotation turn =
        asset
            .attribute("refquat")
            .map(text -> compiler.ofQuaternion(asset, numbers.read(asset, "refquat", text, 4, 4)))
            .orElse(Rotation.IDENTITY);
    return raw.map(mesh -> mesh.in(new Frame(at, turn).inverse()).scaled(scale));
  }

  private TriangleMesh written(Element asset) {
    List<Double> xyz =
        numbers.read(asset, "vertex", asset.attribute("vertex").orElse(""), 0, Integer.MAX_VALUE);
    List<Vector3> points = new ArrayList<>();
    for (int i = 0; i + 2 < xyz.size(); i += 3) {
      points.add(new Vector3(xyz.get(i), xyz.get(i + 1), xyz.get(i + 2)));
    }
    List<Double> corners =
        numbers.read(asset, "face", asset.attribute("face").orElse(""), 0, Integer.MAX_VALUE);
    List<int[]> faces = new ArrayList<>();
    for (int i = 0; i + 2 < corners.size(); i += 3) {
      int[] face = new int[3];
      for (int k = 0; k < 3; k++) {
        face[k] = corners.get(i + k).intValue();
        if (face[k] < 0 || face[k] >= points.size()) {
          numbers.contradiction(asset, "face " + face[k] + " is no vertex");
          return new TriangleMesh(points, List.of());
        }
      }
      faces.add(face);
    }
    return faces.isEmpty() ? ConvexHull.of(points) : new TriangleMesh(points, faces);
  }

  private Optional<TriangleMesh> fromFile(Element asset) {
    Optional<String> name = asset.attribute("file");
    if (name.isEmpty() || files.folder().isEmpty()) {
      return Optional.empty();
    }
    String plain =
        compiler.setting("strippath").filter("true"::equals).isPresent()
            ? name.get().replaceFirst(".*[/\\\\]", "")
            : name.get();
    String inside = compiler.setting("meshdir").or(() -> compiler.setting("assetdir")).orElse("");
    Optional<Path> file = files.find(inside.isEmpty() ? plain : inside + "/" + plain, folder);
    try {
      return file.isEmpty() ? Optional.empty() : Optional.of(MeshFile.read(file.get()));
    } catch (IOException e) {
      losses.picture(asset, "it cannot be read: " + e.getMessage());
      return Optional.empty();
    }
  }
}
