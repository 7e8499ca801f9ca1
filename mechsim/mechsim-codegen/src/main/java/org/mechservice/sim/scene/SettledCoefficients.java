package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.SpringDamper;

/**
 * Coefficients whose values determine the generated code; they must not contain tunable parameters.
 */
public final class SettledCoefficients {
  private static final int ANY = -1;

  private SettledCoefficients() {}

  /** Returns the names of the forces that have a parameter in such a coefficient. */
  static List<String> withParameters(Mechanism mechanism) {
    List<String> names = new ArrayList<>();
    for (ForceElement force : mechanism.forces()) {
      boolean any = false;
      for (Expression coefficient : of(force)) {
        any |= hasParameter(coefficient);
      }
      if (any) {
        names.add(force.name());
      }
    }
    return names;
  }

  /** Returns the names of the parameters that the generated code needs the values of. */
  public static Set<String> parameters(Mechanism mechanism) {
    Set<String> names = new LinkedHashSet<>();
    for (ForceElement force : mechanism.forces()) {
      for (Expression coefficient : numbers(force)) {
        for (int i = 0; i < mechanism.parameters().size(); i++) {
          if (has(coefficient, i)) {
            names.add(mechanism.parameters().get(i).name());
          }
        }
      }
    }
    return names;
  }

  /** Returns the coefficients that are numbers in the code itself. */
  private static List<Expression> numbers(ForceElement force) {
    return force instanceof SpringDamper spring ? List.of(spring.smoothing()) : of(force);
  }

  private static List<Expression> of(ForceElement force) {
    List<Expression> all = new ArrayList<>();
    if (force instanceof Contact contact) {
      all.add(contact.exponent());
      all.add(contact.smoothing());
    } else if (force instanceof Bushing bushing) {
      all.addAll(bushing.stiffness());
      all.addAll(bushing.damping());
      all.addAll(bushing.preload());
    } else if (force instanceof SpringDamper spring) {
      // The code of a spring at coinciding points depends on whether it is slack there.
      all.add(spring.length0());
      all.add(spring.force0());
      all.add(spring.smoothing());
    } else if (force instanceof JointSpringDamper spring) {
      all.add(spring.smoothing());
    } else if (force instanceof CouplingSpringDamper spring) {
      all.add(spring.smoothing());
    }
    return all;
  }

  private static boolean hasParameter(Expression e) {
    return has(e, ANY);
  }

  /** Returns whether a formula has the parameter with a number. */
  private static boolean has(Expression e, int parameter) {
    if (e instanceof Expression.ParameterValue value) {
      return parameter == ANY || value.index() == parameter;
    } else if (e instanceof Expression.Sum sum) {
      return has(sum.left(), parameter) || has(sum.right(), parameter);
    } else if (e instanceof Expression.Product product) {
      return has(product.left(), parameter) || has(product.right(), parameter);
    } else if (e instanceof Expression.Quotient quotient) {
      return has(quotient.dividend(), parameter) || has(quotient.divisor(), parameter);
    } else if (e instanceof Expression.Power power) {
      return has(power.base(), parameter) || has(power.exponent(), parameter);
    } else if (e instanceof Expression.Negation negation) {
      return has(negation.operand(), parameter);
    }
    return Expression.operands(e).stream().anyMatch(operand -> has(operand, parameter));
  }
}
