package org.mechservice.mechml.resolve.body;

import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads {@code box}, {@code cylinder} and {@code sphere}: homogeneous solids with a density or a
 * mass. Volumes and moments of inertia are those of every handbook, such as Beer and Johnston,
 * <i>Vector Mechanics for Engineers</i>, appendix on mass moments of inertia.
 */
final class ShapeReader {
  private final ValueReader values;
  private final Diagnostics diagnostics;

  ShapeReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /**
   * Returns mass, centre and inertia of a solid; empty after a reported error.
   *
   * @param points of its body
   */
  Optional<MassProperties> read(Element shape, NameTable<Vector3> points) {
    return switch (shape.name()) {
      case "box" -> box(shape, points);
      case "cylinder" -> cylinder(shape, points);
      default -> sphere(shape, points);
    };
  }

  private Optional<MassProperties> box(Element box, NameTable<Vector3> points) {
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
            new MassProperties(
                mass.getAsDouble(),
                center.get(),
                new InertiaTensor(
                    mass.getAsDouble() * (yy + zz) / 12,
                    mass.getAsDouble() * (xx + zz) / 12,
                    mass.getAsDouble() * (xx + yy) / 12,
                    0,
                    0,
                    0)));
  }

  private Optional<MassProperties> sphere(Element sphere, NameTable<Vector3> points) {
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
        new MassProperties(
            mass.getAsDouble(), center.get(), new InertiaTensor(moment, moment, moment, 0, 0, 0)));
  }

  private Optional<MassProperties> cylinder(Element cylinder, NameTable<Vector3> points) {
    OptionalDouble radius = positive(cylinder, "radius");
    OptionalDouble inner = values.quantityOrZero(cylinder, "inner", Quantity.LENGTH);
    Optional<Vector3> from = points.find(cylinder, cylinder.required("from"));
    Optional<Vector3> to = points.find(cylinder, cylinder.required("to"));
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
      return wrong(cylinder, "points \"from\" and \"to\" lie in one place; it has no length");
    }
    OptionalDouble mass = mass(cylinder, Math.PI * (r - hole) * (r + hole) * length);
    if (mass.isEmpty()) {
      return Optional.empty();
    }
    double square = r * r + hole * hole;
    return Optional.of(
        MassProperties.about(
            along.normalized(),
            mass.getAsDouble(),
            from.get().plus(along.times(0.5)),
            mass.getAsDouble() * square / 2,
            mass.getAsDouble() * (3 * square + length * length) / 12));
  }

  private Optional<Vector3> point(Element shape, NameTable<Vector3> points) {
    return shape
        .attribute("point")
        .map(name -> points.find(shape, name))
        .orElse(Optional.of(Vector3.ZERO));
  }

  /** Returns the mass, kg, of a volume, m³. */
  private OptionalDouble mass(Element shape, double volume) {
    boolean byDensity = shape.attribute("density").isPresent();
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
