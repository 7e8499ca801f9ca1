package org.mechservice.mechml.resolve.joint;

import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * A joint as given in the file, with the two bodies that it connects.
 *
 * @param element the joint
 * @param start its {@code jointVal}, if there is one
 * @param body1 index of body1's body, −1 for the root
 * @param body2 index of body2's body, −1 for the root
 * @param joint with body1 as parent; empty if it could not be read
 */
public record JointLink(
    Element element, Optional<Element> start, int body1, int body2, Optional<Joint> joint) {

  public JointType type() {
    return JointType.valueOf(element.required("type"));
  }

  /** Returns whether the file marks it {@code cut="true"}. */
  boolean isCutAsked() {
    return element.attribute("cut").map("true"::equals).orElse(false);
  }

  /** Returns whether its motion is prescribed. */
  public boolean isDriven() {
    return start.flatMap(s -> s.attribute("driven")).isPresent();
  }
}
