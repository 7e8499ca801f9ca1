package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Coefficients;
import org.mechservice.solver.force.applied.ScalarLaw;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.Side;

/** The force of a spring in a joint or along a coupling, which is the negative tension. */
public final class JointSpringLaw implements ScalarLaw {
  private final Coefficients coefficients;
  private final ScalarSpring spring;

  public JointSpringLaw(JointSpringDamper element) {
    this(
        element.name(),
        element.side(),
        List.of(
            element.stiffness(),
            element.damping(),
            element.position0(),
            new Negation(element.force0()),
            element.smoothing(),
            element.dissipation()));
  }

  public JointSpringLaw(CouplingSpringDamper element) {
    this(
        element.name(),
        element.side(),
        List.of(
            element.stiffness(),
            element.damping(),
            element.rest(),
            element.force0(),
            element.smoothing(),
            element.dissipation()));
  }

  private JointSpringLaw(String name, Side side, List<Expression> numbers) {
    coefficients = new Coefficients(name, numbers);
    spring = new ScalarSpring(side);
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    return spring.parameters(coefficients, values, force);
  }

  @Override
  public void evaluate(double position, double velocity) {
    spring.evaluate(position, velocity);
  }

  @Override
  public double force() {
    return -spring.tension();
  }

  @Override
  public double byPosition() {
    return -spring.byPosition();
  }

  @Override
  public double byVelocity() {
    return -spring.byVelocity();
  }

  @Override
  public double potentialEnergy(double position) {
    return spring.potentialEnergy(position);
  }

  @Override
  public double energyRate(double velocity) {
    return (spring.tension() - spring.dampingForce()) * velocity;
  }
}
