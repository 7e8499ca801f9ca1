package org.mechservice.mechml.resolve.formula;

import org.mechservice.mechml.document.Element;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.JointCoordinate;

/**
 * A joint of the file with its index in the mechanism.
 *
 * @param element its element in the file
 * @param type its type
 * @param cut whether it closes a loop
 * @param driven whether its coordinates are prescribed
 * @param index among the joints of the tree, or among the closures if it was cut
 */
public record ResolvedJoint(
    Element element, JointType type, boolean cut, boolean driven, int index) {

  /** Returns one of the joint's coordinates. */
  public Coordinate coordinate(int component) {
    return cut ? new ClosureCoordinate(index, component) : new JointCoordinate(index, component);
  }

  /** Returns whether a velocity of the joint is angular. */
  public boolean turns(int component) {
    return type.velocityUnit(component).equals("rad/s");
  }
}
