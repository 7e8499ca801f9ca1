package org.mechservice.mechml.resolve.body;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.DirectionReader;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

/** Reads {@code body}. */
public final class BodyReader {
  private static final Set<String> SHAPES = Set.of("box", "cylinder", "cone", "sphere", "mesh");

  private final ValueReader values;
  private final DirectionReader directions;
  private final InertiaReader inertias;
  private final ShapeReader shapes;
  private final LookReader looks;
  private final Diagnostics diagnostics;

  public BodyReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.directions = new DirectionReader(values, diagnostics);
    this.inertias = new InertiaReader(values, diagnostics);
    this.shapes = new ShapeReader(values, diagnostics, true);
    this.looks = new LookReader(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Reads a body with its points, vectors, mass and inertia. */
  public BodyDefinition read(Element element) {
    String absence = Phrase.of("body %s does not have", Quoted.of(element.required("name")));
    NameTable<Vector3> points = new NameTable<>("point", absence, diagnostics);
    for (Element point : element.children("point")) {
      points.add(point, values.vector(point, "x", "y", "z", Quantity.LENGTH));
    }
    NameTable<Vector3> vectors = new NameTable<>("vector", absence, diagnostics);
    for (Element vector : element.children("vector")) {
      vectors.add(vector, directions.read(vector));
    }
    List<Optional<WeighedSolid>> solids =
        element.children().stream()
            .filter(child -> SHAPES.contains(child.name()))
            .map(solid -> shapes.read(solid, points))
            .toList();
    return new BodyDefinition(
        element,
        points,
        vectors,
        solids.stream().flatMap(Optional::stream).map(WeighedSolid::solid).toList(),
        element.children("look").stream()
            .flatMap(look -> looks.read(look, points).stream())
            .toList(),
        body(element, solids));
  }

  private Optional<Body> body(Element element, List<Optional<WeighedSolid>> solids) {
    return massProperties(element, solids)
        .map(
            of ->
                new Body(
                    element.required("name"),
                    of.mass(),
                    of.center(),
                    of.inertia(),
                    diagnostics.origin(element.position())));
  }

  /** The grammar allows shapes or numbers, not both. */
  private Optional<MassProperties> massProperties(
      Element element, List<Optional<WeighedSolid>> solids) {
    if (solids.isEmpty()) {
      return givenByNumbers(element);
    }
    return solids.stream().allMatch(Optional::isPresent)
        ? solids.stream()
            .flatMap(Optional::stream)
            .map(WeighedSolid::properties)
            .reduce(MassProperties::plus)
        : Optional.empty();
  }

  private Optional<MassProperties> givenByNumbers(Element element) {
    Optional<Vector3> centerOfMass =
        element
            .child("cog")
            .map(cog -> values.vector(cog, "x", "y", "z", Quantity.LENGTH))
            .orElse(Optional.of(Vector3.ZERO));
    OptionalDouble mass = element.child("mass").map(this::mass).orElse(OptionalDouble.of(0));
    Optional<InertiaTensor> inertia =
        element.child("inertiaTensor").map(inertias::read).orElse(Optional.of(InertiaTensor.ZERO));
    if (centerOfMass.isEmpty() || mass.isEmpty() || inertia.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(new MassProperties(mass.getAsDouble(), centerOfMass.get(), inertia.get()));
  }

  private OptionalDouble mass(Element element) {
    OptionalDouble mass = values.quantity(element, "value", Quantity.MASS);
    if (mass.isPresent() && mass.getAsDouble() < 0) {
      diagnostics.error(
          MessageCode.NEGATIVE_MASS,
          element.position(),
          Phrase.of(
              "%s is negative: %s; write 0 for a body without mass",
              element.label(), Quoted.of(element.required("value"))));
      return OptionalDouble.empty();
    }
    return mass;
  }
}
