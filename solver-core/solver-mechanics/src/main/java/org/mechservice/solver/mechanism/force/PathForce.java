package org.mechservice.solver.mechanism.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * A tension along a path whose length x is a formula of positions: of a muscle, of a cable that a
 * motor winds. It acts against growing x, and exerts −T ∂x/∂q on every coordinate. It has no
 * potential energy.
 *
 * @param name name in the model file
 * @param along x, of t, parameters, positions of coordinates that are no Euler parameters, and
 *     places of points, m
 * @param tension T, of {@link Expression.PathMotion}, t, parameters and further states, N
 * @param watched formulas beside T that a step could pass over, of the leaves of x: they tell where
 *     its form changes
 * @param points what the path passes, in this order, for pictures
 * @param origin position in the model file
 */
public record PathForce(
    String name,
    Expression along,
    Expression tension,
    List<Expression> watched,
    List<BodyPoint> points,
    Origin origin)
    implements ForceElement {
  public PathForce {
    watched = List.copyOf(watched);
    points = List.copyOf(points);
  }

  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return List.of(
        new Variable("length", "m"), new Variable("rate", "m/s"), new Variable("tension", "N"));
  }

  @Override
  public List<Formula> formulas() {
    return List.of(new Formula("length", along), new Formula("tension", tension));
  }

  @Override
  public String kind() {
    return "tension along a path";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.pathForce(this);
  }
}
