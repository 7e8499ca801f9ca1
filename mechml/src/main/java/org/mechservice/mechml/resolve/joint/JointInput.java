package org.mechservice.mechml.resolve.joint;

import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.BodyEnd;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.text.Origin;

/**
 * Input of the readers of joints.
 *
 * @param element the joint, or the constraint that has a joint's equations
 * @param end1 body1
 * @param end2 body2
 * @param body1 index of body1's body; {@link Mechanism#ROOT} for the root
 * @param body2 index of body2's body; {@link Mechanism#ROOT} for the root
 * @param start the joint's {@code jointVal}, if there is one
 * @param origin its position in the file
 */
record JointInput(
    Element element,
    BodyEnd end1,
    BodyEnd end2,
    int body1,
    int body2,
    Optional<Element> start,
    Origin origin) {

  /** Returns the joint's name. */
  String name() {
    return element.required("name");
  }

  JointType type() {
    return JointType.valueOf(element.required("type"));
  }
}
