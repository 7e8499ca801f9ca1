package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
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
final class SettledCoefficients {
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
    if (e instanceof Expression.ParameterValue) {
      return true;
    } else if (e instanceof Expression.Sum sum) {
      return hasParameter(sum.left()) || hasParameter(sum.right());
    } else if (e instanceof Expression.Product product) {
      return hasParameter(product.left()) || hasParameter(product.right());
    } else if (e instanceof Expression.Quotient quotient) {
      return hasParameter(quotient.dividend()) || hasParameter(quotient.divisor());
    } else if (e instanceof Expression.Power power) {
      return hasParameter(power.base()) || hasParameter(power.exponent());
    } else if (e instanceof Expression.Negation negation) {
      return hasParameter(negation.operand());
    }
    if (e instanceof Expression.TableValue value) {
      return value.arguments().stream().anyMatch(SettledCoefficients::hasParameter);
    }
    return e instanceof Expression.Call call
        && call.arguments().stream().anyMatch(SettledCoefficients::hasParameter);
  }
}
