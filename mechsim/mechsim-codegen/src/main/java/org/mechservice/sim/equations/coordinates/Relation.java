package org.mechservice.sim.equations.coordinates;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.expression.Formulas;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.ReverseDifferentiation;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;
import org.mechservice.solver.symbol.Substitution;

/**
 * A formula x of time, positions of joints and places of points, with its slopes by them. Positions
 * of tree joints are states; those of cut joints and places of points are computed from the poses
 * of bodies. While the formula is differentiated, placeholders stand for them.
 */
public final class Relation extends Formulas {
  /**
   * A position on which the formula depends.
   *
   * @param variable in the formula
   * @param stand placeholder for the position
   * @param rate placeholder for its rate, if it is computed
   * @param second placeholder for its second derivative
   */
  public record Leaf(Expression variable, Scalar stand, Scalar rate, Scalar second) {
    /** Returns the position of a tree joint, if it is one. */
    public Optional<JointCoordinate> ofTree() {
      return variable instanceof CoordinatePosition position
              && position.coordinate() instanceof JointCoordinate joint
          ? Optional.of(joint)
          : Optional.empty();
    }
  }

  /**
   * Most leaves that are cheaper one after the other: the straight way over three points, whose
   * slopes by differences share their parts. A sweep costs a few times the formula.
   */
  private static final int FEW = 9;

  private final Expressions expressions;
  private final JointLinks joints;
  private final CutCoordinateTerms cuts;
  private final List<Leaf> leaves = new ArrayList<>();
  private final Map<Leaf, Scalar> slopes = new HashMap<>();
  private final Scalar derived;
  private Optional<ReverseDifferentiation> gradient = Optional.empty();
  private Optional<Substitution> ofStates = Optional.empty();
  private Optional<Substitution> still = Optional.empty();

  /** Derives the formula with placeholders. */
  public Relation(
      Expressions expressions, JointLinks joints, CutCoordinateTerms cuts, Expression formula) {
    super(expressions);
    this.expressions = expressions;
    this.joints = joints;
    this.cuts = cuts;
    this.derived = scalar(formula);
  }

  @Override
  protected Scalar leaf(Expression variable) {
    if (!(variable instanceof CoordinatePosition) && !(variable instanceof PointPosition)) {
      throw new IllegalArgumentException(
          "no code is generated for a relation that has " + variable);
    }
    for (Leaf leaf : leaves) {
      if (leaf.variable().equals(variable)) {
        return leaf.stand();
      }
    }
    int first = Program.PLACEHOLDER - 3 * leaves.size();
    Leaf leaf =
        new Leaf(
            variable,
            expressions.input(first),
            expressions.input(first - 1),
            expressions.input(first - 2));
    leaves.add(leaf);
    return leaf.stand();
  }

  /** Returns the positions on which it depends. */
  public List<Leaf> leaves() {
    return leaves;
  }

  /** Returns a position that is computed from poses, not one of a tree joint. */
  public CutCoordinate computed(Leaf leaf) {
    return leaf.variable() instanceof PointPosition point
        ? cuts.ofPoint(point)
        : cuts.ofPosition((ClosureCoordinate) ((CoordinatePosition) leaf.variable()).coordinate());
  }

  /** Returns x with placeholders for the positions that are computed. */
  public Scalar ofStates() {
    return statesInPlace(derived);
  }

  /** Returns x. */
  public Scalar value() {
    return inPlace(derived, Optional.empty());
  }

  /** Returns ∂x/∂(position). */
  public Scalar slope(Leaf leaf) {
    Scalar known = slopes.get(leaf);
    if (known == null) {
      known = inPlace(slopeInPlaceholders(leaf), Optional.empty());
      slopes.put(leaf, known);
    }
    return known;
  }

  /** Differentiates by one leaf, or, where they are many, by all of them in one sweep. */
  private Scalar slopeInPlaceholders(Leaf leaf) {
    if (leaves.size() <= FEW) {
      Map<Scalar, Scalar> direction = Map.of(leaf.stand(), expressions.one());
      return new Differentiation(expressions, direction).of(derived);
    }
    if (gradient.isEmpty()) {
      Map<Scalar, Scalar> weight = Map.of(derived, expressions.one());
      gradient = Optional.of(new ReverseDifferentiation(expressions, weight));
    }
    return gradient.get().by(leaf.stand());
  }

  /** Returns ∂x/∂t. */
  public Scalar slopeByTime() {
    Map<Scalar, Scalar> byTime = Map.of(expressions.input(Program.TIME), expressions.one());
    return inPlace(new Differentiation(expressions, byTime).of(derived), Optional.empty());
  }

  /** Returns x'. */
  public Scalar rate() {
    Scalar rate = slopeByTime();
    for (Leaf leaf : leaves) {
      Scalar moves =
          leaf.ofTree()
              .map(position -> joints.velocity(joints.velocityOf(position)))
              .orElseGet(() -> computed(leaf).velocity());
      rate = rate.plus(slope(leaf).times(moves));
    }
    return rate;
  }

  /**
   * Adds the loads of a force that is conjugate to x, whose power is the force times x'.
   *
   * @param force N, or N·m if x is an angle
   */
  public void addForce(Scalar force, Loads loads) {
    for (Leaf leaf : leaves) {
      Scalar along = slope(leaf).times(force);
      leaf.ofTree()
          .ifPresentOrElse(
              position -> joints.addForce(joints.velocityOf(position), along, loads),
              () -> computed(leaf).addForce(along, loads));
    }
  }

  /**
   * Substitutes all placeholders.
   *
   * @param sweep accelerations of the links with zero joint accelerations, if they are wanted
   */
  public Scalar inPlace(Scalar scalar, Optional<ForceSweep> sweep) {
    return computedInPlace(statesInPlace(scalar), sweep);
  }

  /** Each substitution is kept, since the slopes of a long formula share most of it. */
  private Scalar statesInPlace(Scalar scalar) {
    if (ofStates.isEmpty()) {
      Map<Scalar, Scalar> positions = new HashMap<>();
      for (Leaf leaf : leaves) {
        leaf.ofTree().ifPresent(joint -> positions.put(leaf.stand(), joints.position(joint)));
      }
      ofStates = Optional.of(new Substitution(expressions, positions));
    }
    return ofStates.get().of(scalar);
  }

  private Scalar computedInPlace(Scalar scalar, Optional<ForceSweep> sweep) {
    if (sweep.isPresent()) {
      return computed(sweep).of(scalar);
    }
    if (still.isEmpty()) {
      still = Optional.of(computed(sweep));
    }
    return still.get().of(scalar);
  }

  private Substitution computed(Optional<ForceSweep> sweep) {
    Map<Scalar, Scalar> motion = new HashMap<>();
    ScalarVector none = ScalarVector.zero(expressions);
    for (Leaf leaf : leaves) {
      if (leaf.ofTree().isEmpty()) {
        CutCoordinate coordinate = computed(leaf);
        motion.put(leaf.stand(), coordinate.position());
        motion.put(leaf.rate(), coordinate.velocity());
        motion.put(leaf.second(), coordinate.acceleration(sweep, none));
      }
    }
    return new Substitution(expressions, motion);
  }
}
