package org.mechservice.sim.equations.loop;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.mechservice.sim.equations.coordinates.JointLinks;
import org.mechservice.sim.equations.coordinates.Relation;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/** A coupling of positions as an equation of a loop. */
final class RelationRow {
  private final Expressions expressions;
  private final JointLinks joints;
  private final Links mechanism;
  private final VelocityRows rows;
  private final double length;
  private final Optional<ForceSweep> sweep;

  /**
   * @param length length scale that makes displacements comparable with angles, m
   * @param sweep accelerations of the links with zero joint accelerations, if γ is requested
   */
  RelationRow(
      Expressions expressions,
      JointLinks joints,
      Links mechanism,
      VelocityRows rows,
      double length,
      Optional<ForceSweep> sweep) {
    this.expressions = expressions;
    this.joints = joints;
    this.mechanism = mechanism;
    this.rows = rows;
    this.length = length;
    this.sweep = sweep;
  }

  /** Returns the equation. */
  LoopRow row(Relation relation) {
    Scalar[] jacobian = rows.zeros();
    Scalar size = expressions.zero();
    for (Relation.Leaf leaf : relation.leaves()) {
      Scalar slope = relation.slope(leaf);
      addRow(relation, leaf, slope, jacobian);
      Scalar moves = expressions.function(MathFunction.ABS, slope).times(unit(relation, leaf));
      size = size.isZero() ? moves : expressions.function(MathFunction.MAX, size, moves);
    }
    Differentiation byMotion = new Differentiation(expressions, motion(relation));
    Scalar value = relation.ofStates();
    Scalar rate = byMotion.of(value);
    Scalar offset = byMotion.of(rate);
    return new LoopRow(
        relation.inPlace(value, sweep),
        relation.inPlace(rate, sweep),
        relation.inPlace(offset, sweep),
        jacobian,
        size.isConstant() ? none() : some(size));
  }

  private void addRow(Relation relation, Relation.Leaf leaf, Scalar slope, Scalar[] jacobian) {
    if (leaf.ofTree().isEmpty()) {
      relation.computed(leaf).addRow(slope, rows, jacobian);
      return;
    }
    Link link = joints.link(leaf.ofTree().get());
    if (!link.isDriven()) {
      int at = rows.velocity(link);
      jacobian[at] = jacobian[at].plus(slope);
    }
  }

  private static Optional<Scalar> none() {
    return Optional.empty();
  }

  private Optional<Scalar> some(Scalar size) {
    return Optional.of(
        expressions.function(
            MathFunction.CHOOSE, size, expressions.zero(), expressions.one(), size));
  }

  /** Returns the size of a position. */
  private double unit(Relation relation, Relation.Leaf leaf) {
    boolean turns =
        leaf.ofTree()
            .map(position -> joints.link(position).turns())
            .orElseGet(() -> relation.computed(leaf).term().countsTurns());
    return turns ? 1 : length;
  }

  /**
   * Returns the rates with zero joint accelerations: q' = v, t' = 1, and the placeholders of rates.
   */
  private Map<Scalar, Scalar> motion(Relation relation) {
    Map<Scalar, Scalar> motion = new HashMap<>();
    motion.put(expressions.input(Program.TIME), expressions.one());
    for (Link link : mechanism.links()) {
      if (!link.isDriven() && !link.isBall()) {
        motion.put(expressions.input(link.position()), expressions.input(link.velocity()));
      }
    }
    for (Relation.Leaf leaf : relation.leaves()) {
      motion.put(leaf.stand(), leaf.rate());
      motion.put(leaf.rate(), leaf.second());
    }
    return motion;
  }
}
