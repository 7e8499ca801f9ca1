package org.mechservice.mechml.resolve;

import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;

/**
 * What a joint's attributes say of one of its coordinates: each is a list with one item per
 * coordinate.
 *
 * @param joint a joint whose coordinates all have velocities of their own
 * @param component the coordinate, from 0
 * @param formulas reads the items
 */
record JointValues(JointPlace joint, int component, FormulaReader formulas) {

  Element element() {
    return joint.element();
  }

  Coordinate coordinate() {
    return joint.coordinate(component);
  }

  /** Returns the name of the coordinate's force of a kind. */
  String name(String kind) {
    String name = element().required("name") + "." + kind;
    return joint.type().velocityCount() == 1 ? name : name + "[" + component + "]";
  }

  Quantity position() {
    return turns() ? Quantity.ANGLE : Quantity.LENGTH;
  }

  Quantity velocity() {
    return turns() ? Quantity.ANGULAR_SPEED : Quantity.SPEED;
  }

  Quantity force() {
    return turns() ? Quantity.TORQUE : Quantity.FORCE;
  }

  Quantity stiffness() {
    return turns() ? Quantity.TORSIONAL_STIFFNESS : Quantity.STIFFNESS;
  }

  Quantity damping() {
    return turns() ? Quantity.TORSIONAL_DAMPING : Quantity.DAMPING;
  }

  private boolean turns() {
    return joint.turns(component);
  }

  /** Returns the coordinate's item of an attribute, zero if the attribute is missing. */
  Optional<Expression> coefficient(String attribute, Quantity quantity) {
    return formulas.item(element(), attribute, joint.type().velocityCount(), component, quantity);
  }

  Optional<Expression> notNegative(String attribute, Quantity quantity) {
    return coefficient(attribute, quantity)
        .filter(
            c -> formulas.satisfies(element(), attribute, c, x -> x >= 0, "must not be negative"));
  }

  Optional<Expression> positive(String attribute, Quantity quantity) {
    return coefficient(attribute, quantity)
        .filter(c -> formulas.satisfies(element(), attribute, c, x -> x > 0, "must be positive"));
  }
}
