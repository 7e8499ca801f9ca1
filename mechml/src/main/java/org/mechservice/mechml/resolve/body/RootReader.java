package org.mechservice.mechml.resolve.body;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.DirectionReader;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads {@code root} and its {@code inipos}: computes the pose of the root from the world position
 * of its named point and the world directions of its named vectors.
 */
public final class RootReader {
  /** Largest accepted difference of angles between vectors, rad: the rounding of six digits. */
  private static final double SAME_ANGLE = 1e-5;

  private final ValueReader values;
  private final DirectionReader directions;
  private final Diagnostics diagnostics;

  /** A direction of the root, in its own axes and in the world's. */
  private record Sighting(Vector3 own, Vector3 world) {}

  public RootReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.directions = new DirectionReader(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the root's pose; empty after a reported error. */
  public Optional<Root> read(Element root, BodyDefinition body) {
    Optional<Element> inipos = root.child("inipos");
    if (inipos.isEmpty()) {
      return Optional.of(new Root(body.name(), Vector3.ZERO, Rotation.IDENTITY));
    }
    Element point = inipos.get().requiredChild("point");
    Optional<Vector3> own = body.points().find(point, point.required("name"));
    Optional<Vector3> world = values.vector(point, "x", "y", "z", Quantity.LENGTH);
    Optional<Rotation> orientation = orientation(inipos.get(), body);
    if (own.isEmpty() || world.isEmpty() || orientation.isEmpty()) {
      return Optional.empty();
    }
    Vector3 position = world.get().minus(orientation.get().apply(own.get()));
    return Optional.of(new Root(body.name(), position, orientation.get()));
  }

  private Optional<Rotation> orientation(Element inipos, BodyDefinition body) {
    List<Element> vectors = inipos.children("vector");
    List<Sighting> sightings = new ArrayList<>();
    for (Element vector : vectors) {
      Optional<Vector3> own = body.directions().find(vector, vector.required("name"));
      Optional<Vector3> world = directions.read(vector);
      if (own.isPresent() && world.isPresent()) {
        sightings.add(new Sighting(own.get(), world.get()));
      }
    }
    if (sightings.size() < vectors.size()) {
      return Optional.empty();
    }
    return switch (sightings.size()) {
      case 0 -> Optional.of(Rotation.IDENTITY);
      case 1 -> least(inipos, sightings.get(0));
      default -> full(inipos, sightings.get(0), sightings.get(1));
    };
  }

  private Optional<Rotation> least(Element inipos, Sighting sighting) {
    Optional<Rotation> least = AlignmentRotation.least(sighting.own(), sighting.world());
    if (least.isEmpty()) {
      diagnostics.error(
          MessageCode.OPPOSITE_VECTORS,
          inipos.position(),
          inipos.label()
              + ": the vector is opposite to its direction in the body, so the root's pose is not"
              + " defined; add a second vector");
    }
    return least;
  }

  private Optional<Rotation> full(Element inipos, Sighting first, Sighting second) {
    double own = angle(first.own(), second.own());
    double world = angle(first.world(), second.world());
    Optional<Rotation> rotation =
        AlignmentRotation.aligned(first.own(), second.own(), first.world(), second.world());
    if (rotation.isEmpty()) {
      diagnostics.error(
          MessageCode.ROOT_POSE,
          inipos.position(),
          inipos.label()
              + ": the two vectors are parallel, so the root's pose is not defined; give two"
              + " vectors with different directions");
    } else if (Math.abs(own - world) > SAME_ANGLE) {
      diagnostics.error(
          MessageCode.ROOT_POSE,
          inipos.position(),
          Phrase.of(
              "%s: the two vectors enclose %.6g deg here but %.6g deg in the body",
              inipos.label(), Math.toDegrees(world), Math.toDegrees(own)));
      return Optional.empty();
    }
    return rotation;
  }

  private static double angle(Vector3 a, Vector3 b) {
    return StrictMath.atan2(a.cross(b).norm(), a.dot(b));
  }
}
