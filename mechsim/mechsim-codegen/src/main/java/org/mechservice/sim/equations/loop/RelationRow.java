package org.mechservice.sim.equations.loop;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.sim.equations.coordinates.CutCoordinate;
import org.mechservice.sim.equations.coordinates.CutCoordinateTerms;
import org.mechservice.sim.equations.coordinates.JointLinks;
import org.mechservice.sim.equations.kinematics.Formulas;
import org.mechservice.sim.equations.links.Link;
import org.mechservice.sim.equations.links.Links;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.sim.symbolic.Differentiation;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.MathFunction;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;
import org.mechservice.sim.symbolic.Substitution;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;

/** A coupling of joint positions as an equation of a loop. */
final class RelationRow extends Formulas {
  /**
   * A position on which the coupling depends.
   *
   * @param stand the placeholder input for it while the coupling is differentiated
   * @param rate the placeholder for its rate, for cut joints only
   * @param second the placeholder for its second derivative
   */
  private record Leaf(Coordinate coordinate, Scalar stand, Scalar rate, Scalar second) {}

  private final Expressions expressions;
  private final JointLinks joints;
  private final CutCoordinateTerms cuts;
  private final Links mechanism;
  private final VelocityRows rows;
  private final double length;
  private final Optional<ForceSweep> sweep;
  private final List<Leaf> leaves = new ArrayList<>();

  /**
   * @param length length scale that makes displacements comparable with angles, m
   * @param sweep accelerations of the links with zero joint accelerations, if γ is requested
   */
  RelationRow(
      Expressions expressions,
      JointLinks joints,
      CutCoordinateTerms cuts,
      Links mechanism,
      VelocityRows rows,
      double length,
      Optional<ForceSweep> sweep) {
    super(expressions);
    this.expressions = expressions;
    this.joints = joints;
    this.cuts = cuts;
    this.mechanism = mechanism;
    this.rows = rows;
    this.length = length;
    this.sweep = sweep;
  }

  @Override
  protected Scalar leaf(Expression leaf) {
    if (leaf instanceof Expression.CoordinatePosition position) {
      return stand(position.coordinate());
    }
    throw new IllegalArgumentException("no code is generated for a relation that has " + leaf);
  }

  private Scalar stand(Coordinate coordinate) {
    for (Leaf leaf : leaves) {
      if (leaf.coordinate().equals(coordinate)) {
        return leaf.stand();
      }
    }
    int first = Program.PLACEHOLDER - 3 * leaves.size();
    Leaf leaf =
        new Leaf(
            coordinate,
            expressions.input(first),
            expressions.input(first - 1),
            expressions.input(first - 2));
    leaves.add(leaf);
    return leaf.stand();
  }

  private Scalar inPlace(Scalar derived) {
    return cutsInPlace(statesInPlace(derived));
  }

  /** Substitutes the placeholders of tree joints' positions, which are states. */
  private Scalar statesInPlace(Scalar derived) {
    Scalar found = derived;
    for (Leaf leaf : leaves) {
      if (leaf.coordinate() instanceof JointCoordinate joint) {
        found = new Substitution(leaf.stand(), joints.position(joint)).of(found);
      }
    }
    return found;
  }

  /** Substitutes the placeholders of cut joints' positions and rates, which are computed. */
  private Scalar cutsInPlace(Scalar derived) {
    Scalar found = derived;
    ScalarVector none = ScalarVector.zero(expressions);
    for (Leaf leaf : leaves) {
      if (leaf.coordinate() instanceof ClosureCoordinate position) {
        CutCoordinate cut = cuts.ofPosition(position);
        found = new Substitution(leaf.stand(), cut.position()).of(found);
        found = new Substitution(leaf.rate(), cut.velocity()).of(found);
        found = new Substitution(leaf.second(), cut.acceleration(sweep, none)).of(found);
      }
    }
    return found;
  }

  /** Returns the equation. */
  LoopRow row(Expression relation) {
    Scalar derived = scalar(relation);
    Scalar[] jacobian = rows.zeros();
    Scalar size = expressions.zero();
    for (Leaf leaf : leaves) {
      Scalar slope = slope(derived, leaf);
      addRow(leaf.coordinate(), slope, jacobian);
      Scalar moves = expressions.function(MathFunction.ABS, slope).times(unit(leaf.coordinate()));
      size = size.isZero() ? moves : expressions.function(MathFunction.MAX, size, moves);
    }
    Differentiation byMotion = new Differentiation(expressions, motion());
    Scalar value = statesInPlace(derived);
    Scalar rate = byMotion.of(value);
    Scalar offset = byMotion.of(rate);
    return new LoopRow(
        cutsInPlace(value),
        cutsInPlace(rate),
        cutsInPlace(offset),
        jacobian,
        size.isConstant() ? none() : some(size));
  }

  private void addRow(Coordinate coordinate, Scalar slope, Scalar[] jacobian) {
    if (coordinate instanceof ClosureCoordinate position) {
      cuts.ofPosition(position).addRow(slope, rows, jacobian);
      return;
    }
    Link link = joints.link((JointCoordinate) coordinate);
    if (!link.isDriven()) {
      int at = rows.velocity(link);
      jacobian[at] = jacobian[at].plus(slope);
    }
  }

  /** Adds the joint forces of a multiplier of the equation. */
  void addForces(Expression relation, Scalar multiplier, Loads loads) {
    Scalar derived = scalar(relation);
    for (Leaf leaf : leaves) {
      Scalar force = slope(derived, leaf).times(multiplier);
      if (leaf.coordinate() instanceof ClosureCoordinate position) {
        cuts.ofPosition(position).addForce(force, loads);
      } else {
        JointCoordinate position = (JointCoordinate) leaf.coordinate();
        joints.addForce(joints.velocityOf(position), force, loads);
      }
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

  /** Returns the size of a joint's position. */
  private double unit(Coordinate coordinate) {
    boolean turns =
        coordinate instanceof ClosureCoordinate position
            ? cuts.ofPosition(position).term().countsTurns()
            : joints.link((JointCoordinate) coordinate).turns();
    return turns ? 1 : length;
  }

  /**
   * Returns the rates with zero joint accelerations: q' = v, t' = 1, and the placeholders of rates.
   */
  private Map<Scalar, Scalar> motion() {
    Map<Scalar, Scalar> motion = new HashMap<>();
    motion.put(expressions.input(Program.TIME), expressions.one());
    for (Link link : mechanism.links()) {
      if (!link.isDriven() && !link.isBall()) {
        motion.put(expressions.input(link.position()), expressions.input(link.velocity()));
      }
    }
    for (Leaf leaf : leaves) {
      motion.put(leaf.stand(), leaf.rate());
      motion.put(leaf.rate(), leaf.second());
    }
    return motion;
  }
}
