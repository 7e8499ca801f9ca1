package org.mechservice.mechml.resolve.force;

import java.util.Optional;
import java.util.function.Function;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;

/**
 * Reads the damping of an element that acts on one side. It is given in one of three ways: a linear
 * damper c; the dissipation χ of Hunt and Crossley; or the restitution at a speed, which is a χ.
 */
final class DampingReader {
  /**
   * Names of the attributes.
   *
   * @param linear c
   * @param dissipation χ; empty if the element has none
   * @param restitution e
   * @param speed speed of impact for e
   */
  record Names(String linear, String dissipation, String restitution, String speed) {}

  /** The attributes of contacts. */
  static final Names CONTACT =
      new Names("damping", "dissipation", "restitution", "restitutionSpeed");

  /** The attributes of springs. */
  static final Names SPRING = new Names("c", "", "restitution", "restitutionSpeed");

  /** The attributes of the stops of joints. */
  static final Names STOP = new Names("stopDamping", "", "stopRestitution", "stopRestitutionSpeed");

  /**
   * Coefficients of a damper.
   *
   * @param linear c, N·s/m or N·m·s/rad
   * @param dissipation χ, s/m or s/rad
   */
  record Damping(Expression linear, Expression dissipation) {}

  /** Reads the coefficient of an attribute that is not given as zero. */
  interface Coefficients {
    /** Returns the coefficient; empty after a reported error. */
    Optional<Expression> read(String attribute, Quantity quantity);
  }

  private final FormulaReader formulas;
  private final Diagnostics diagnostics;

  DampingReader(FormulaReader formulas, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.diagnostics = diagnostics;
  }

  /** Returns the damping of an element with one value for each attribute. */
  Optional<Damping> read(Element element, Names names, boolean angle) {
    return read(
        element,
        names,
        angle,
        (attribute, quantity) -> formulas.coefficient(element, attribute, quantity, 0));
  }

  /** Returns the damping; empty after a reported error. */
  Optional<Damping> read(Element element, Names names, boolean angle, Coefficients coefficients) {
    boolean restitution = element.attribute(names.restitution()).isPresent();
    boolean dissipation =
        !names.dissipation().isEmpty() && element.attribute(names.dissipation()).isPresent();
    boolean linear = element.attribute(names.linear()).isPresent();
    if ((restitution ? 1 : 0) + (dissipation ? 1 : 0) + (linear ? 1 : 0) > 1) {
      return refuse(
          element,
          Phrase.of(
              "the damping is given twice; give one of %s",
              names.dissipation().isEmpty()
                  ? names.linear() + " and " + names.restitution()
                  : names.linear() + ", " + names.dissipation() + " and " + names.restitution()));
    }
    if (restitution != element.attribute(names.speed()).isPresent()) {
      return refuse(
          element,
          Phrase.of(
              "%s needs %s",
              restitution ? names.restitution() : names.speed(),
              restitution
                  ? names.speed() + ", the speed of impact at which it holds"
                  : names.restitution() + " beside it"));
    }
    if (restitution) {
      return restitution(element, names, angle, coefficients);
    }
    if (dissipation) {
      return notNegative(element, names.dissipation(), Quantity.DISSIPATION, coefficients)
          .map(chi -> new Damping(Expression.ZERO, chi));
    }
    return notNegative(
            element,
            names.linear(),
            angle ? Quantity.TORSIONAL_DAMPING : Quantity.DAMPING,
            coefficients)
        .map(c -> new Damping(c, Expression.ZERO));
  }

  private Optional<Expression> notNegative(
      Element element, String attribute, Quantity quantity, Coefficients coefficients) {
    return coefficients
        .read(attribute, quantity)
        .filter(
            c -> formulas.satisfies(element, attribute, c, x -> x >= 0, "must not be negative"));
  }

  private Optional<Damping> restitution(
      Element element, Names names, boolean angle, Coefficients coefficients) {
    Quantity speed = angle ? Quantity.ANGULAR_SPEED : Quantity.SPEED;
    Optional<Expression> at =
        coefficients
            .read(names.speed(), speed)
            .filter(
                v -> formulas.satisfies(element, names.speed(), v, x -> x > 0, "must be positive"));
    Optional<Expression> e =
        coefficients
            .read(names.restitution(), Quantity.NUMBER)
            .filter(
                value ->
                    formulas.satisfies(
                        element,
                        names.restitution(),
                        value,
                        x -> x > 0 && x <= 1,
                        "must be above 0 and at most 1"));
    if (e.isPresent() && !(e.get() instanceof Expression.Constant)) {
      return refuse(
          element, names.restitution() + " contains a tunable parameter; it must be a number");
    }
    Function<Expression, Damping> damping =
        v ->
            new Damping(
                Expression.ZERO,
                ExpressionAlgebra.quotient(
                    Expression.of(
                        Restitution.dissipationBySpeed(
                            ((Expression.Constant) e.orElseThrow()).value())),
                    v));
    return e.isPresent() ? at.map(damping) : Optional.empty();
  }

  private Optional<Damping> refuse(Element element, String message) {
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES, element.position(), element.label() + ": " + message);
    return Optional.empty();
  }
}
