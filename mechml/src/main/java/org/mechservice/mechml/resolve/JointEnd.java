package org.mechservice.mechml.resolve;

import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.spatial.Vector3;

/**
 * One side of a joint.
 *
 * @param element where it was given
 * @param body the body named
 */
record JointEnd(Element element, BodyParts body) {

  /** Returns the point named, from the body's origin, in body axes, m; reports an unknown name. */
  Optional<Vector3> point() {
    return body.points().find(element, element.required("point"));
  }

  /** Returns whether the end names a direction. */
  boolean has(String attribute) {
    return element.attribute(attribute).isPresent();
  }

  /** Returns the direction an attribute names, in body axes; reports an unknown name. */
  Optional<Vector3> direction(String attribute) {
    return element.attribute(attribute).flatMap(name -> body.directions().find(element, name));
  }
}
