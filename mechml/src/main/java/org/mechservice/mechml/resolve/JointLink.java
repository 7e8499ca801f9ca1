package org.mechservice.mechml.resolve;

import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.mechanism.Joint;

/**
 * A joint as the file gives it, and which bodies it joins.
 *
 * @param element the joint
 * @param body1 index of body1's body, −1 for the root
 * @param body2 index of body2's body, −1 for the root
 * @param joint with body1 as parent; empty if it could not be read
 */
record JointLink(Element element, int body1, int body2, Optional<Joint> joint) {}
