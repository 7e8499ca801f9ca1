package org.mechservice.sim.equations.coordinates;

import java.util.List;
import org.mechservice.solver.kinematics.pair.AxisPair;
import org.mechservice.solver.kinematics.pair.PairForms;
import org.mechservice.solver.kinematics.pair.RollingShape;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/** Functions of the pose of two frames: the constraints of joints, and their coordinates. */
public final class PairTerms implements PairForms<PairTerm> {
  private final Expressions expressions;
  private final ScalarVector none;
  private final ScalarMatrix rotation;
  private final ScalarVector way;
  private final ScalarVector omega;
  private final ScalarVector rate;

  public PairTerms(Expressions expressions, RelativeFrameMotion frames) {
    this.expressions = expressions;
    this.none = ScalarVector.zero(expressions);
    this.rotation = frames.rotation();
    this.way = frames.displacement();
    this.omega = frames.omega();
    this.rate = frames.rate();
  }

  /** Returns β = x · R y with ∂β = (R y) × x and the quadratic part ω · (R y xᵀ − β 1) ω. */
  private PairTerm product(AxisPair axes) {
    ScalarVector x = ScalarVector.of(expressions, axes.inA());
    ScalarVector carried = rotation.times(ScalarVector.of(expressions, axes.inB()));
    Scalar value = x.dot(carried);
    Scalar bend = carried.dot(omega).times(x.dot(omega)).minus(value.times(omega.dot(omega)));
    return new PairTerm(value, carried.cross(x), none, bend, false);
  }

  /** Returns Σ sign_k β_k. */
  private PairTerm sum(List<AxisPair> axes, List<Double> sign) {
    Scalar zero = expressions.zero();
    PairTerm sum = new PairTerm(zero, none, none, zero, false);
    for (int k = 0; k < axes.size(); k++) {
      double factor = sign.get(k);
      PairTerm term = product(axes.get(k));
      sum =
          new PairTerm(
              sum.value().plus(term.value().times(factor)),
              sum.byTurn().plus(term.byTurn().map(c -> c.times(factor))),
              none,
              sum.bend().plus(term.bend().times(factor)),
              false);
    }
    return sum;
  }

  @Override
  public PairTerm displacement(Vector3 axis) {
    ScalarVector along = ScalarVector.of(expressions, axis);
    return new PairTerm(way.dot(along), none, along, expressions.zero(), false);
  }

  @Override
  public PairTerm axisCosine(AxisPair axes, double atZero) {
    PairTerm product = product(axes);
    return new PairTerm(
        product.value().minus(expressions.constant(atZero)),
        product.byTurn(),
        none,
        product.bend(),
        false);
  }

  /**
   * {@inheritDoc} f = 2 N / D has ∂f = (2 ∂N − f ∂D) / D and the quadratic part [2 N − f D − 2 D'
   * f'] / D of those of N and D.
   */
  @Override
  public PairTerm tilt(List<AxisPair> above, List<Double> sign, List<AxisPair> below) {
    PairTerm n = sum(above, sign);
    PairTerm d = sum(below, below.stream().map(axes -> 1.0).toList());
    Scalar denominator = d.value().plus(expressions.one());
    Scalar value = n.value().times(2).over(denominator);
    ScalarVector byTurn =
        n.byTurn()
            .map(c -> c.times(2))
            .minus(d.byTurn().times(value))
            .map(c -> c.over(denominator));
    Scalar product = d.byTurn().dot(omega).times(byTurn.dot(omega)).times(2);
    Scalar bend = n.bend().times(2).minus(value.times(d.bend())).minus(product).over(denominator);
    return new PairTerm(value, byTurn, none, bend, false);
  }

  /**
   * {@inheritDoc} ∂φ = (c ∂s − s ∂c) / (s² + c²), with the quadratic part (c s − s c − 2 φ' (s s' +
   * c c')) / (s² + c²).
   */
  @Override
  public PairTerm turn(AxisPair sine, AxisPair cosine, double sense) {
    PairTerm s = product(sine);
    PairTerm c = product(cosine);
    Scalar square = s.value().squared().plus(c.value().squared());
    ScalarVector across = s.byTurn().times(c.value()).minus(c.byTurn().times(s.value()));
    ScalarVector byTurn = across.map(x -> x.over(square).times(sense));
    Scalar growth =
        s.value()
            .times(s.byTurn().dot(omega))
            .plus(c.value().times(c.byTurn().dot(omega)))
            .times(2);
    Scalar own = c.value().times(s.bend()).minus(s.value().times(c.bend())).times(sense);
    Scalar bend = own.minus(byTurn.dot(omega).times(growth)).over(square);
    Scalar angle = expressions.function(MathFunction.ATAN2, s.value(), c.value());
    return new PairTerm(angle.times(sense), byTurn, none, bend, true);
  }

  @Override
  public PairTerm screwGap(PairTerm displacement, PairTerm turn, double pitch) {
    Scalar gap = displacement.value().minus(turn.value().times(pitch));
    double lead = 2 * Math.PI * pitch;
    return new PairTerm(
        lead == 0 ? gap : nearest(gap, lead),
        turn.byTurn().map(c -> c.times(-pitch)),
        displacement.byShift(),
        turn.bend().times(-pitch),
        false);
  }

  /** Returns a difference minus the nearest whole number of periods. */
  public static Scalar nearest(Scalar difference, double period) {
    Expressions e = difference.expressions();
    Scalar periods = difference.over(e.constant(period)).plus(e.constant(0.5));
    return difference.minus(e.function(MathFunction.FLOOR, periods).times(period));
  }

  @Override
  public PairTerm distance(double d) {
    Scalar length = way.dot(way).squareRoot();
    Scalar size = expressions.constant(d);
    Scalar value = length.minus(size).times(length.plus(size)).over(expressions.constant(2 * d));
    ScalarVector along = way.map(c -> c.over(size));
    return new PairTerm(value, none, along, rate.dot(rate).over(size), false);
  }

  @Override
  public PairTerm angularVelocity(int axis) {
    double[] unit = new double[3];
    unit[axis] = 1;
    ScalarVector byTurn = ScalarVector.of(expressions, new Vector3(unit[0], unit[1], unit[2]));
    Scalar zero = expressions.zero();
    return new PairTerm(zero, byTurn, none, zero, false);
  }

  /**
   * {@inheritDoc} With k = e × n, c = n · e, s = |k|: a = −radius (n − c e) / s − tube n, c' = k ·
   * ω, s' = −c c' / s; the gradient is [a × t; t].
   */
  @Override
  public PairTerm rollingContact(RollingShape shape, RollingShape.Direction direction) {
    ScalarVector n = ScalarVector.of(expressions, shape.normal());
    ScalarVector first = ScalarVector.of(expressions, shape.tangent());
    boolean off = direction == RollingShape.Direction.OFF;
    Scalar height = way.dot(n);
    if (shape.isBall()) {
      ScalarVector arm = n.map(c -> c.times(-shape.radius()));
      ScalarVector along =
          switch (direction) {
            case OFF -> n;
            case ALONG -> first;
            case ACROSS -> n.cross(first);
          };
      Scalar value = off ? height.minus(expressions.constant(shape.radius())) : expressions.zero();
      return new PairTerm(value, arm.cross(along), along, expressions.zero(), false);
    }
    ScalarVector e = rotation.times(ScalarVector.of(expressions, shape.axle()));
    Scalar c = n.dot(e);
    ScalarVector k = e.cross(n);
    Scalar s = k.dot(k).squareRoot();
    ScalarVector up = n.minus(e.times(c)).map(x -> x.over(s));
    ScalarVector arm = up.times(-shape.radius()).minus(n.map(x -> x.times(shape.tube())));
    ScalarVector eRate = omega.cross(e);
    ScalarVector kRate = eRate.cross(n);
    Scalar cRate = k.dot(omega);
    Scalar sRate = c.times(cRate).over(s).negated();
    ScalarVector upRate =
        e.times(cRate).plus(eRate.times(c)).plus(up.times(sRate)).map(x -> x.over(s).negated());
    ScalarVector armRate = upRate.times(-shape.radius());
    ScalarVector track = k.map(x -> x.over(s));
    ScalarVector trackRate = kRate.minus(track.times(sRate)).map(x -> x.over(s));
    ScalarVector along =
        switch (direction) {
          case OFF -> n;
          case ALONG -> track;
          case ACROSS -> n.cross(track);
        };
    ScalarVector alongRate =
        switch (direction) {
          case OFF -> none;
          case ALONG -> trackRate;
          case ACROSS -> n.cross(trackRate);
        };
    Scalar value =
        off
            ? height.minus(s.times(shape.radius())).minus(expressions.constant(shape.tube()))
            : expressions.zero();
    Scalar bend =
        armRate.cross(along).plus(arm.cross(alongRate)).dot(omega).plus(alongRate.dot(rate));
    return new PairTerm(value, arm.cross(along), along, bend, false);
  }

  @Override
  public PairTerm edgeVelocity(Vector3 side) {
    ScalarVector along = rotation.times(ScalarVector.of(expressions, side));
    Scalar bend = omega.cross(along).dot(rate);
    return new PairTerm(expressions.zero(), none, along, bend, false);
  }
}
