package org.mechservice.sim.build.dynamics;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.sim.symbolic.Differentiation;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.MathFunction;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.Substitution;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;

/** A relation between positions of joints of the tree as an equation of a loop. */
final class RelationRow extends Formulas {
  /** A position the relation depends on, and the input that stands for it while it is derived. */
  private record Leaf(JointCoordinate coordinate, Scalar stand) {}

  private final Expressions expressions;
  private final JointLinks joints;
  private final Links mechanism;
  private final VelocityRows rows;
  private final double length;
  private final List<Leaf> leaves = new ArrayList<>();

  /**
   * @param length what makes displacements comparable with angles, m
   */
  RelationRow(
      Expressions expressions,
      JointLinks joints,
      Links mechanism,
      VelocityRows rows,
      double length) {
    super(expressions);
    this.expressions = expressions;
    this.joints = joints;
    this.mechanism = mechanism;
    this.rows = rows;
    this.length = length;
  }

  @Override
  Scalar leaf(Expression leaf) {
    if (leaf instanceof Expression.CoordinatePosition position
        && position.coordinate() instanceof JointCoordinate joint) {
      return stand(joint);
    }
    throw new IllegalArgumentException("no code is generated for a relation that has " + leaf);
  }

  private Scalar stand(JointCoordinate coordinate) {
    for (Leaf leaf : leaves) {
      if (leaf.coordinate().equals(coordinate)) {
        return leaf.stand();
      }
    }
    Scalar stand = expressions.input(Program.PLACEHOLDER - leaves.size());
    leaves.add(new Leaf(coordinate, stand));
    return stand;
  }

  private Scalar inPlace(Scalar derived) {
    Scalar found = derived;
    for (Leaf leaf : leaves) {
      found = new Substitution(leaf.stand(), joints.position(leaf.coordinate())).of(found);
    }
    return found;
  }

  /** Returns the equation. */
  LoopRow row(Expression relation) {
    Scalar derived = scalar(relation);
    Scalar value = inPlace(derived);
    Scalar[] jacobian = rows.zeros();
    Scalar size = expressions.zero();
    for (Leaf leaf : leaves) {
      Scalar slope = slope(derived, leaf);
      Link link = joints.link(leaf.coordinate());
      if (!link.isDriven()) {
        int at = rows.velocity(link);
        jacobian[at] = jacobian[at].plus(slope);
      }
      Scalar moves = expressions.function(MathFunction.ABS, slope).times(unit(link));
      size = size.isZero() ? moves : expressions.function(MathFunction.MAX, size, moves);
    }
    Differentiation byMotion = new Differentiation(expressions, motion());
    Scalar rate = byMotion.of(value);
    Scalar offset = byMotion.of(rate);
    return new LoopRow(value, rate, offset, jacobian, size.isConstant() ? none() : some(size));
  }

  /** Adds the joint forces that a multiplier of the equation stands for. */
  void addForces(Expression relation, Scalar multiplier, Loads loads) {
    Scalar derived = scalar(relation);
    for (Leaf leaf : leaves) {
      Scalar force = slope(derived, leaf).times(multiplier);
      joints.addForce(joints.velocityOf(leaf.coordinate()), force, loads);
    }
  }

  /** Returns ∂Φ/∂(leaf). */
  private Scalar slope(Scalar derived, Leaf leaf) {
    Map<Scalar, Scalar> direction = Map.of(leaf.stand(), expressions.one());
    return inPlace(new Differentiation(expressions, direction).of(derived));
  }

  private static Optional<Scalar> none() {
    return Optional.empty();
  }

  private Optional<Scalar> some(Scalar size) {
    return Optional.of(
        expressions.function(
            MathFunction.CHOOSE, size, expressions.zero(), expressions.one(), size));
  }

  /** The size of what a joint's position measures. */
  private double unit(Link link) {
    return link.turns() ? 1 : length;
  }

  /** How the state moves while no joint accelerates: q' = v, t' = 1. */
  private Map<Scalar, Scalar> motion() {
    Map<Scalar, Scalar> motion = new HashMap<>();
    motion.put(expressions.input(Program.TIME), expressions.one());
    for (Link link : mechanism.links()) {
      if (!link.isDriven() && !link.isBall()) {
        motion.put(expressions.input(link.position()), expressions.input(link.velocity()));
      }
    }
    return motion;
  }
}
