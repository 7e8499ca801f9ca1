package org.mechservice.mechml.resolve.body;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.Solid;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads {@code box}, {@code cylinder}, {@code cone}, {@code sphere} and {@code mesh}: homogeneous
 * solids with a density or a mass. Volumes and moments of inertia are those of every handbook, such
 * as Beer and Johnston, <i>Vector Mechanics for Engineers</i>, appendix on mass moments of inertia.
 */
final class ShapeReader {
  private static final String SAME_PLACE =
      "points \"from\" and \"to\" lie in one place; it has no length";

  private final ValueReader values;
  private final Diagnostics diagnostics;
  private final boolean weighs;

  /**
   * @param weighs whether each solid has a mass; if not, it is for the eye alone, and its mass is 0
   */
  ShapeReader(ValueReader values, Diagnostics diagnostics, boolean weighs) {
    this.values = values;
    this.diagnostics = diagnostics;
    this.weighs = weighs;
  }

  /**
   * Returns a solid with its mass, centre and inertia; empty after a reported error.
   *
   * @param points of its body
   */
  Optional<WeighedSolid> read(Element shape, NameTable<Vector3> points) {
    return switch (shape.name()) {
      case "box" -> box(shape, points);
      case "cylinder" -> cylinder(shape, points);
      case "cone" -> cone(shape, points);
      case "mesh" -> mesh(shape, points);
      case "surface" -> surface(shape, points);
      default -> sphere(shape, points);
    };
  }

  private Optional<WeighedSolid> box(Element box, NameTable<Vector3> points) {
    OptionalDouble x = positive(box, "x");
    OptionalDouble y = positive(box, "y");
    OptionalDouble z = positive(box, "z");
    Optional<Vector3> center = point(box, points);
    if (x.isEmpty() || y.isEmpty() || z.isEmpty() || center.isEmpty()) {
      return Optional.empty();
    }
    double xx = x.getAsDouble() * x.getAsDouble();
    double yy = y.getAsDouble() * y.getAsDouble();
    double zz = z.getAsDouble() * z.getAsDouble();
    OptionalDouble mass = mass(box, x.getAsDouble() * y.getAsDouble() * z.getAsDouble());
    return mass.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new WeighedSolid(
                new Solid.Block(
                    center.get(), new Vector3(x.getAsDouble(), y.getAsDouble(), z.getAsDouble())),
                new MassProperties(
                    mass.getAsDouble(),
                    center.get(),
                    new InertiaTensor(
                        mass.getAsDouble() * (yy + zz) / 12,
                        mass.getAsDouble() * (xx + zz) / 12,
                        mass.getAsDouble() * (xx + yy) / 12,
                        0,
                        0,
                        0))));
  }

  private Optional<WeighedSolid> sphere(Element sphere, NameTable<Vector3> points) {
    OptionalDouble radius = positive(sphere, "radius");
    Optional<Vector3> center = point(sphere, points);
    if (radius.isEmpty() || center.isEmpty()) {
      return Optional.empty();
    }
    double r = radius.getAsDouble();
    OptionalDouble mass = mass(sphere, 4.0 / 3.0 * Math.PI * r * r * r);
    if (mass.isEmpty()) {
      return Optional.empty();
    }
    double moment = 0.4 * mass.getAsDouble() * r * r;
    return Optional.of(
        new WeighedSolid(
            new Solid.Ball(center.get(), r),
            new MassProperties(
                mass.getAsDouble(),
                center.get(),
                new InertiaTensor(moment, moment, moment, 0, 0, 0))));
  }

  private Optional<WeighedSolid> cylinder(Element cylinder, NameTable<Vector3> points) {
    OptionalDouble radius = positive(cylinder, "radius");
    OptionalDouble inner = values.quantityOrZero(cylinder, "inner", Quantity.LENGTH);
    Optional<Vector3> from = place(cylinder, "from", points);
    Optional<Vector3> to = place(cylinder, "to", points);
    if (radius.isEmpty() || inner.isEmpty() || from.isEmpty() || to.isEmpty()) {
      return Optional.empty();
    }
    double r = radius.getAsDouble();
    double hole = inner.getAsDouble();
    if (hole < 0 || hole >= r) {
      return wrong(cylinder, "inner is the radius of the bore: from 0 to less than radius");
    }
    Vector3 along = to.get().minus(from.get());
    double length = along.norm();
    if (length == 0) {
      return wrong(cylinder, SAME_PLACE);
    }
    OptionalDouble mass = mass(cylinder, Math.PI * (r - hole) * (r + hole) * length);
    if (mass.isEmpty()) {
      return Optional.empty();
    }
    double square = r * r + hole * hole;
    return Optional.of(
        new WeighedSolid(
            new Solid.Round(from.get(), to.get(), r, r, hole),
            MassProperties.about(
                along.normalized(),
                mass.getAsDouble(),
                from.get().plus(along.times(0.5)),
                mass.getAsDouble() * square / 2,
                mass.getAsDouble() * (3 * square + length * length) / 12)));
  }

  /**
   * A surface from a file, whose volume and moments at density 1 stand beside its name in the
   * file's unit, along the axes of the body.
   */
  private Optional<WeighedSolid> mesh(Element mesh, NameTable<Vector3> points) {
    if (mesh.attribute("volume").isEmpty()
        || mesh.attribute("center").isEmpty()
        || mesh.attribute("moments").isEmpty()) {
      return wrong(
          mesh,
          "its file was not read, because this model is not read from a folder; write volume,"
              + " center and moments");
    }
    Optional<Unit> unit = values.unit(mesh, "length", Quantity.LENGTH);
    Optional<Vector3> origin = point(mesh, points);
    OptionalDouble volume = values.number(mesh, "volume");
    Optional<List<Double>> center =
        unit.flatMap(length -> values.list(mesh, "center", Collections.nCopies(3, length)));
    Optional<List<Double>> moments = values.list(mesh, "moments", Collections.nCopies(6, Unit.ONE));
    if (unit.isEmpty()
        || origin.isEmpty()
        || volume.isEmpty()
        || center.isEmpty()
        || moments.isEmpty()) {
      return Optional.empty();
    }
    if (!(volume.getAsDouble() > 0)) {
      return wrong(mesh, "volume must be positive");
    }
    double scale = unit.get().toSi(1);
    OptionalDouble mass = mass(mesh, volume.getAsDouble() * scale * scale * scale);
    if (mass.isEmpty()) {
      return Optional.empty();
    }
    List<Double> c = center.get();
    double factor = mass.getAsDouble() / volume.getAsDouble() * scale * scale;
    List<Double> m = moments.get().stream().map(moment -> moment * factor).toList();
    return Optional.of(
        new WeighedSolid(
            new Solid.Surface(mesh.required("file"), scale, origin.get()),
            new MassProperties(
                mass.getAsDouble(),
                origin.get().plus(new Vector3(c.get(0), c.get(1), c.get(2))),
                new InertiaTensor(m.get(0), m.get(1), m.get(2), m.get(3), m.get(4), m.get(5)))));
  }

  /** A surface from a file that is shown only. */
  private Optional<WeighedSolid> surface(Element surface, NameTable<Vector3> points) {
    Optional<Unit> unit = values.unit(surface, "length", Quantity.LENGTH);
    Optional<Vector3> origin = point(surface, points);
    return unit.isEmpty() || origin.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new WeighedSolid(
                new Solid.Surface(surface.required("file"), unit.get().toSi(1), origin.get()),
                new MassProperties(0, origin.get(), InertiaTensor.ZERO)));
  }

  /** Returns the ends of a capsule as balls, with the cylinder between them; none on an error. */
  List<Solid> capsule(Element capsule, NameTable<Vector3> points) {
    OptionalDouble radius = positive(capsule, "radius");
    Optional<Vector3> from = place(capsule, "from", points);
    Optional<Vector3> to = place(capsule, "to", points);
    if (radius.isEmpty() || from.isEmpty() || to.isEmpty()) {
      return List.of();
    }
    double r = radius.getAsDouble();
    if (to.get().minus(from.get()).norm() == 0) {
      wrong(capsule, SAME_PLACE);
      return List.of();
    }
    return List.of(
        new Solid.Round(from.get(), to.get(), r, r, 0),
        new Solid.Ball(from.get(), r),
        new Solid.Ball(to.get(), r));
  }

  /** Returns the point that an attribute of this name names or holds; the origin without one. */
  Optional<Vector3> point(Element shape, NameTable<Vector3> points) {
    return shape.attribute("point").isPresent()
        ? place(shape, "point", points)
        : Optional.of(Vector3.ZERO);
  }

  /** Returns the point that an attribute names, or whose three coordinates it holds. */
  private Optional<Vector3> place(Element shape, String attribute, NameTable<Vector3> points) {
    String text = shape.required(attribute);
    return text.contains(";") && points.value(text).isEmpty()
        ? values.triple(shape, attribute, Quantity.LENGTH)
        : points.find(shape, text);
  }

  /**
   * A frustum, whose sections have radii that change linearly from R to r over the height h: volume
   * π h (R² + R r + r²)/3; centre h (R² + 2 R r + 3 r²)/(4 (R² + R r + r²)) from the end of R; the
   * moments are integrals over its discs, about the end of R and from there to the centre by
   * Steiner.
   */
  private Optional<WeighedSolid> cone(Element cone, NameTable<Vector3> points) {
    OptionalDouble radius = positive(cone, "radius");
    OptionalDouble top = values.quantityOrZero(cone, "top", Quantity.LENGTH);
    Optional<Vector3> from = place(cone, "from", points);
    Optional<Vector3> to = place(cone, "to", points);
    if (radius.isEmpty() || top.isEmpty() || from.isEmpty() || to.isEmpty()) {
      return Optional.empty();
    }
    double a = radius.getAsDouble();
    double b = top.getAsDouble();
    if (b < 0) {
      return wrong(cone, "top is the radius at its other end: 0 for a pointed cone, or more");
    }
    Vector3 along = to.get().minus(from.get());
    double h = along.norm();
    if (h == 0) {
      return wrong(cone, SAME_PLACE);
    }
    double square = a * a + a * b + b * b;
    OptionalDouble mass = mass(cone, Math.PI * h * square / 3);
    if (mass.isEmpty()) {
      return Optional.empty();
    }
    double m = mass.getAsDouble();
    double center = h * (a * a + 2 * a * b + 3 * b * b) / (4 * square);
    double fourth = a * a * (a * a + a * b) + b * b * (a * a + a * b + b * b);
    double discs = 0.15 * m * fourth / square;
    double base = m * h * h * (a * a + 3 * a * b + 6 * b * b) / (10 * square);
    return Optional.of(
        new WeighedSolid(
            new Solid.Round(from.get(), to.get(), a, b, 0),
            MassProperties.about(
                along.normalized(),
                m,
                from.get().plus(along.times(center / h)),
                2 * discs,
                discs + base - m * center * center)));
  }

  /** Returns the mass, kg, of a volume, m³. */
  private OptionalDouble mass(Element shape, double volume) {
    boolean byDensity = shape.attribute("density").isPresent();
    if (!weighs) {
      if (byDensity || shape.attribute("mass").isPresent()) {
        wrong(shape, "a look has no mass; leave out density and mass");
        return OptionalDouble.empty();
      }
      return OptionalDouble.of(0);
    }
    if (byDensity == shape.attribute("mass").isPresent()) {
      wrong(
          shape,
          byDensity
              ? "density and mass both say how heavy it is; leave out one"
              : "it needs a density or a mass");
      return OptionalDouble.empty();
    }
    OptionalDouble given =
        byDensity
            ? positive(shape, "density", Quantity.DENSITY)
            : positive(shape, "mass", Quantity.MASS);
    return given.isPresent() && byDensity ? OptionalDouble.of(given.getAsDouble() * volume) : given;
  }

  private OptionalDouble positive(Element shape, String attribute) {
    return positive(shape, attribute, Quantity.LENGTH);
  }

  private OptionalDouble positive(Element shape, String attribute, Quantity quantity) {
    OptionalDouble value = values.quantity(shape, attribute, quantity);
    if (value.isPresent() && !(value.getAsDouble() > 0)) {
      wrong(
          shape,
          Phrase.of(
              "%s is %s; it must be positive", attribute, Quoted.of(shape.required(attribute))));
      return OptionalDouble.empty();
    }
    return value;
  }

  private <T> Optional<T> wrong(Element shape, String why) {
    diagnostics.error(
        MessageCode.SHAPE_VALUES, shape.position(), Phrase.of("%s: %s", shape.label(), why));
    return Optional.empty();
  }
}
