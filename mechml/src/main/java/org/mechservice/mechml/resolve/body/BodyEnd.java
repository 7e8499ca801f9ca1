package org.mechservice.mechml.resolve.body;

import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.spatial.Vector3;

/**
 * One end of a joint, constraint or force: a body with the point and directions that it names
 * there.
 *
 * @param element its element in the file
 * @param body the named body
 */
public record BodyEnd(Element element, BodyDefinition body) {

  /** Returns the point named, from the body's origin, in body axes, m; reports an unknown name. */
  public Optional<Vector3> point() {
    return body.points().find(element, element.required("point"));
  }

  /** Returns whether the end has the given attribute, which names a direction. */
  public boolean has(String attribute) {
    return element.attribute(attribute).isPresent();
  }

  /** Returns the direction an attribute names, in body axes; reports an unknown name. */
  public Optional<Vector3> direction(String attribute) {
    return element.attribute(attribute).flatMap(name -> body.directions().find(element, name));
  }
}
