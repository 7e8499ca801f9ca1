package org.mechservice.mechml.resolve.body;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.Look;
import org.mechservice.mechml.Solid;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.spatial.Vector3;

/**
 * A body with its named points and directions.
 *
 * @param element its element in the file
 * @param points from the body's origin, in body axes, m
 * @param directions unit vectors in body axes
 * @param solids what gives it its mass, in file order; none if numbers do
 * @param looks what it is shown as, in file order
 * @param body mass and inertia; empty if they could not be read
 */
public record BodyDefinition(
    Element element,
    NameTable<Vector3> points,
    NameTable<Vector3> directions,
    List<Solid> solids,
    List<Look> looks,
    Optional<Body> body) {
  public BodyDefinition {
    solids = List.copyOf(solids);
    looks = List.copyOf(looks);
  }

  /** Returns the body's name. */
  public String name() {
    return element.required("name");
  }
}
