package org.mechservice.mechml.resolve.force;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;

/** Reads the coefficients that contacts of all shapes share. */
final class ContactLawReader {
  /** Standard gravity, m/s², for the default of stickTime. */
  private static final double GRAVITY = 9.80665;

  private final ValueReader values;
  private final FormulaReader formulas;
  private final DampingReader dampers;
  private final Diagnostics diagnostics;

  ContactLawReader(ValueReader values, FormulaReader formulas, Diagnostics diagnostics) {
    this.values = values;
    this.formulas = formulas;
    this.dampers = new DampingReader(formulas, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the coefficients; empty after a reported error. */
  Optional<ContactCoefficients> read(Element element) {
    Optional<Expression> exponent = exponent(element);
    Optional<Expression> stiffness = exponent.flatMap(n -> stiffness(element, n));
    Optional<DampingReader.Damping> damping = damping(element);
    Optional<Expression> smoothing = formulas.notNegative(element, "smoothing", Quantity.LENGTH);
    Optional<Expression> friction = formulas.notNegative(element, "friction", Quantity.NUMBER);
    boolean sticks = element.attribute("stickLength").isPresent();
    if (!isPossible(element, sticks)) {
      return Optional.empty();
    }
    Optional<Expression> speed = sticks ? Optional.of(Expression.of(1)) : frictionSpeed(element);
    Optional<Expression> length =
        sticks
            ? formulas.positive(element, "stickLength", Quantity.LENGTH)
            : Optional.of(Expression.ZERO);
    Optional<Expression> time =
        length.flatMap(l -> friction.flatMap(mu -> stickTime(element, l, mu)));
    boolean push = stiffness.isPresent() && damping.isPresent() && smoothing.isPresent();
    boolean sliding = friction.isPresent() && speed.isPresent() && time.isPresent();
    if (!push || !sliding || !(exponent.orElseThrow() instanceof Expression.Constant n)) {
      return Optional.empty();
    }
    return Optional.of(
        new ContactCoefficients(
            stiffness.get(),
            damping.get().linear(),
            damping.get().dissipation(),
            n.value(),
            smoothing.get(),
            friction.get(),
            speed.get(),
            length.orElseThrow(),
            time.get()));
  }

  Optional<DampingReader.Damping> damping(Element element) {
    return dampers.read(element, DampingReader.CONTACT, false);
  }

  private boolean isPossible(Element element, boolean sticks) {
    if (sticks && element.attribute("frictionSpeed").isPresent()) {
      return refuse(
          element,
          "stickLength and frictionSpeed exclude each other: with stickLength friction holds at"
              + " rest, with frictionSpeed it creeps; leave one out");
    }
    if (sticks && element.attribute("friction").isEmpty()) {
      return refuse(element, "stickLength has no meaning without friction");
    }
    if (!sticks && element.attribute("stickTime").isPresent()) {
      return refuse(element, "stickTime has no meaning without stickLength");
    }
    return true;
  }

  /** Returns τ; by default that which damps a body that lies by its own weight critically. */
  private Optional<Expression> stickTime(Element element, Expression length, Expression friction) {
    if (element.attribute("stickTime").isPresent()) {
      return formulas.positive(element, "stickTime", Quantity.TIME);
    }
    boolean none = ExpressionAlgebra.isZero(length) || ExpressionAlgebra.isZero(friction);
    return Optional.of(
        none
            ? Expression.of(1)
            : ExpressionAlgebra.times(
                2,
                ExpressionAlgebra.root(
                    ExpressionAlgebra.quotient(
                        length, ExpressionAlgebra.times(GRAVITY, friction)))));
  }

  /** Returns n, a number for the contacts of {@link #read}. */
  private Optional<Expression> exponent(Element element) {
    Optional<Expression> exponent = anyExponent(element);
    if (exponent.isPresent() && !(exponent.get() instanceof Expression.Constant)) {
      refuse(element, "exponent contains a tunable parameter; it must be a number");
      return Optional.empty();
    }
    return exponent;
  }

  Optional<Expression> anyExponent(Element element) {
    return formulas
        .coefficient(element, "exponent", Quantity.NUMBER, 1)
        .filter(n -> formulas.satisfies(element, "exponent", n, x -> x >= 1, "must be 1 or more"));
  }

  /** Returns k in N/mⁿ, from force per length to the power n in the file's units. */
  Optional<Expression> stiffness(Element element, Expression exponent) {
    boolean linear = exponent.equals(Expression.of(1));
    if (!linear && element.attribute("stiffnessUnit").isPresent()) {
      refuse(
          element,
          "stiffnessUnit can be given where exponent is 1 only; leave it out and write the"
              + " stiffness in the file's units of force and length");
      return Optional.empty();
    }
    Optional<Expression> k = formulas.positive(element, "stiffness", Quantity.STIFFNESS);
    double length = values.units().length().toSi(1);
    if (linear || length == 1) {
      return k;
    }
    // k/Lⁿ = k/L · L^(1 − n), L the file's unit of length
    Expression power =
        new Expression.Power(
            Expression.of(length),
            new Expression.Sum(Expression.of(1), new Expression.Negation(exponent)));
    return k.map(value -> new Expression.Product(value, power));
  }

  Optional<Expression> frictionSpeed(Element element) {
    boolean needed =
        element.attribute("friction").isPresent() || element.attribute("frictionSpeed").isPresent();
    return needed
        ? formulas.positive(element, "frictionSpeed", Quantity.SPEED)
        : Optional.of(Expression.of(1));
  }

  private boolean refuse(Element element, String message) {
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES, element.position(), element.label() + ": " + message);
    return false;
  }
}
