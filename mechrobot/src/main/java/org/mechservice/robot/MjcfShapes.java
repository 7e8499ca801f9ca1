package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Mass and inertia of a body in MJCF that gives its shapes: spheres, capsules, cylinders, boxes and
 * ellipsoids of uniform density, by default 1000 kg/m³.
 */
final class MjcfShapes {
  private static final double WATER = 1000;

  /**
   * A uniform body: volume and moments of a unit of mass about its centre in its own axes.
   *
   * @param volume m³
   * @param xx m², likewise yy and zz
   */
  private record Solid(double volume, double xx, double yy, double zz) {}

  /**
   * A shape with mass.
   *
   * @param frame its centre and axes in the body
   * @param mass kg
   */
  private record Part(Frame frame, double mass, Solid solid) {}

  private final MjcfCompiler compiler;
  private final RobotNumbers numbers;
  private final ImportLosses losses;
  private final List<Part> parts = new ArrayList<>();

  MjcfShapes(MjcfCompiler compiler, RobotNumbers numbers, ImportLosses losses) {
    this.compiler = compiler;
    this.numbers = numbers;
    this.losses = losses;
  }

  /**
   * Adds a shape.
   *
   * @param outer the frame in the body that the shape's pose is in
   * @param attribute gives the text of an attribute of the shape, with its default
   */
  void add(Element geometry, Frame outer, Function<String, Optional<String>> attribute) {
    Optional<Double> given =
        attribute.apply("mass").map(text -> numbers.read(geometry, "mass", text, 1, 1).get(0));
    double density =
        attribute
            .apply("density")
            .map(text -> numbers.read(geometry, "density", text, 1, 1).get(0))
            .orElse(WATER);
    String type =
        attribute.apply("mesh").isPresent() ? "mesh" : attribute.apply("type").orElse("sphere");
    if (given.orElse(density) == 0 || type.equals("plane") || type.equals("hfield")) {
      return;
    }
    if (type.equals("mesh") || type.equals("sdf")) {
      losses.add(geometry, "the mass of a mesh is not computed; give its body an <inertial>");
      return;
    }
    Frame frame = compiler.frame(geometry, attribute);
    List<Double> size =
        attribute
            .apply("size")
            .map(text -> numbers.read(geometry, "size", text, 1, 3))
            .orElse(List.of());
    Optional<String> ends = attribute.apply("fromto");
    double half = size.size() > 1 ? size.get(1) : 0;
    if (ends.isPresent()) {
      List<Double> e = numbers.read(geometry, "fromto", ends.get(), 6, 6);
      Vector3 from = new Vector3(e.get(0), e.get(1), e.get(2));
      Vector3 to = new Vector3(e.get(3), e.get(4), e.get(5));
      // MuJoCo's z axis points from the second end to the first; moments do not depend on it.
      Vector3 along = to.minus(from);
      half = along.norm() / 2;
      if (half == 0) {
        numbers.contradiction(geometry, "its two ends are one point");
        return;
      }
      frame = new Frame(from.plus(to).times(0.5), MjcfCompiler.least(along.normalized()));
    }
    Optional<Solid> solid = solid(geometry, type, size, half, ends.isPresent());
    if (solid.isPresent()) {
      double mass = given.orElse(density * solid.get().volume());
      parts.add(new Part(outer.times(frame), mass, solid.get()));
    }
  }

  private Optional<Solid> solid(
      Element geometry, String type, List<Double> size, double half, boolean byEnds) {
    int needed =
        switch (type) {
          case "sphere" -> 1;
          case "capsule", "cylinder" -> byEnds ? 1 : 2;
          default -> byEnds ? 1 : 3;
        };
    if (size.size() < needed) {
      numbers.missing(geometry, "attribute size with " + needed + " numbers for type " + type);
      return Optional.empty();
    }
    double r = size.get(0);
    double a = size.get(0);
    double b =
        byEnds ? (size.size() > 1 ? size.get(1) : a) : size.get(Math.min(1, size.size() - 1));
    double c = byEnds ? half : size.get(size.size() - 1);
    return switch (type) {
      case "sphere" -> Optional.of(ellipsoid(r, r, r));
      case "ellipsoid" -> Optional.of(ellipsoid(a, b, c));
      case "box" ->
          Optional.of(
              new Solid(
                  8 * a * b * c, (b * b + c * c) / 3, (a * a + c * c) / 3, (a * a + b * b) / 3));
      case "cylinder" -> {
        double across = r * r / 4 + half * half / 3;
        yield Optional.of(new Solid(2 * Math.PI * r * r * half, across, across, r * r / 2));
      }
      case "capsule" -> Optional.of(capsule(r, half));
      default -> {
        numbers.contradiction(geometry, "type " + type + " is not known");
        yield Optional.empty();
      }
    };
  }

  private static Solid ellipsoid(double a, double b, double c) {
    return new Solid(
        4 * Math.PI / 3 * a * b * c, (b * b + c * c) / 5, (a * a + c * c) / 5, (a * a + b * b) / 5);
  }

  /** A cylinder of half length h with two half spheres, whose centres are 3r/8 from their discs. */
  private static Solid capsule(double r, double h) {
    double tube = 2 * Math.PI * r * r * h;
    double balls = 4 * Math.PI / 3 * r * r * r;
    double across =
        tube * (r * r / 4 + h * h / 3) + balls * (2 * r * r / 5 + h * h + 3 * r * h / 4);
    double along = tube * r * r / 2 + balls * 2 * r * r / 5;
    double volume = tube + balls;
    return new Solid(volume, across / volume, across / volume, along / volume);
  }

  /**
   * Returns the inertia of all shapes together.
   *
   * @param body for messages
   * @return empty if no shape has mass
   */
  Optional<Inertial> inertial(Element body) {
    double mass = 0;
    Vector3 moment = Vector3.ZERO;
    for (Part part : parts) {
      mass += part.mass();
      moment = moment.plus(part.frame().at().times(part.mass()));
    }
    if (!(mass > 0)) {
      return Optional.empty();
    }
    Vector3 centre = moment.times(1 / mass);
    double[] sum = new double[6];
    for (Part part : parts) {
      addMoments(part, part.frame().at().minus(centre), sum);
    }
    return Optional.of(
        new Inertial(
            body,
            new Frame(centre, Rotation.IDENTITY),
            mass,
            List.of(sum[0], sum[1], sum[2], sum[3], sum[4], sum[5])));
  }

  /** Adds m (R J Rᵀ + (d·d) 1 − d dᵀ): xx, yy, zz, xy, xz, yz. */
  private static void addMoments(Part part, Vector3 d, double[] sum) {
    Rotation r = part.frame().turn();
    Solid s = part.solid();
    double m = part.mass();
    double dd = d.dot(d);
    sum[0] += m * (entry(s, r.xx(), r.xy(), r.xz(), r.xx(), r.xy(), r.xz()) + dd - d.x() * d.x());
    sum[1] += m * (entry(s, r.yx(), r.yy(), r.yz(), r.yx(), r.yy(), r.yz()) + dd - d.y() * d.y());
    sum[2] += m * (entry(s, r.zx(), r.zy(), r.zz(), r.zx(), r.zy(), r.zz()) + dd - d.z() * d.z());
    sum[3] += m * (entry(s, r.xx(), r.xy(), r.xz(), r.yx(), r.yy(), r.yz()) - d.x() * d.y());
    sum[4] += m * (entry(s, r.xx(), r.xy(), r.xz(), r.zx(), r.zy(), r.zz()) - d.x() * d.z());
    sum[5] += m * (entry(s, r.yx(), r.yy(), r.yz(), r.zx(), r.zy(), r.zz()) - d.y() * d.z());
  }

  private static double entry(
      Solid s, double ax, double ay, double az, double bx, double by, double bz) {
    return ax * s.xx() * bx + ay * s.yy() * by + az * s.zz() * bz;
  }
}
