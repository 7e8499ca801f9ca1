package org.mechservice.solver.force.law;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;
import org.mechservice.solver.symbol.Substitution;

/**
 * A spring and damper along the line between two points: the force on point 2 is −T n. The line is
 * not defined if the points coincide: a spring without tension there passes through zero length
 * smoothly, its damper along the velocity u; any other spring has no direction.
 */
public final class SpringLoad implements PairLoad {
  static final Undirected UNDIRECTED =
      new Undirected(
          "Its two points coincide, so its tension of %s N has no direction.",
          2, "Move one of the points, or use a bushing, which needs no direction.");

  /** Tension, relative to its terms, that counts as zero. */
  private static final double NO_TENSION = 1e-9;

  /** A length beside zero, m. */
  private static final double TINY = 1e-300;

  private final Expressions e;
  private final SpringLaw law;
  private final ScalarVector way;
  private final ScalarVector velocity;
  private final Scalar length;
  private final Scalar rate;

  /** 1 if there is no tension at zero length and rate, up to rounding of its terms, else 0. */
  private final Scalar slack;

  /**
   * @param way point 2 from point 1, m
   * @param velocity its rate in axes in which the force is wanted, m/s
   */
  public SpringLoad(SpringLaw law, ScalarVector way, ScalarVector velocity) {
    this.e = way.x().expressions();
    this.law = law;
    this.way = way;
    this.velocity = velocity;
    this.length = way.dot(way).squareRoot();
    this.slack = slackAtZero();
    Scalar along = way.dot(velocity).over(length);
    this.rate = slack.isZero() ? along : atZero(velocity.dot(velocity).squareRoot(), along);
  }

  private Scalar slackAtZero() {
    Scalar tension = law.tension(e.zero(), e.zero());
    if (tension.isZero()) {
      return e.one();
    }
    Scalar ofSpring = size(law.k()).times(size(law.rest()).plus(law.eps()));
    Scalar least = size(law.preload()).plus(ofSpring).times(NO_TENSION);
    return e.function(MathFunction.CHOOSE, size(tension), least, e.one(), e.zero());
  }

  private Scalar size(Scalar value) {
    return e.function(MathFunction.ABS, value);
  }

  /** Returns one value if the points coincide, otherwise another. */
  private Scalar atZero(Scalar coincident, Scalar apart) {
    return e.function(MathFunction.CHOOSE, length, e.zero(), coincident, apart);
  }

  /** Returns whether the points may coincide, whatever the numbers. */
  public boolean isSlack() {
    return slack.isConstant() && !slack.isZero();
  }

  @Override
  public Optional<Direction> direction() {
    if (isSlack()) {
      return Optional.empty();
    }
    Scalar size =
        slack.isZero() ? length : e.function(MathFunction.CHOOSE, e.one(), slack, e.one(), length);
    return Optional.of(new Direction(size, 0));
  }

  @Override
  public ScalarVector force() {
    Scalar perLength = law.tension(length, rate).over(length).negated();
    if (slack.isZero()) {
      return way.times(perLength);
    }
    Scalar resisting = law.dampingForce(e.zero(), e.one()).negated();
    ScalarVector along = way.times(atZero(slopeAtZero().negated(), perLength));
    return along.plus(velocity.times(atZero(resisting, e.zero())));
  }

  /** Returns the slope of the tension by a length that begins at zero. */
  private Scalar slopeAtZero() {
    Scalar z = e.input(Program.PLACEHOLDER);
    Scalar slope = new Differentiation(e, Map.of(z, e.one())).of(law.tension(z, e.zero()));
    return new Substitution(z, e.constant(TINY)).of(slope);
  }

  @Override
  public ScalarVector moment() {
    return ScalarVector.zero(e);
  }

  @Override
  public Scalar potential() {
    return law.potential(length);
  }

  @Override
  public Scalar power() {
    return law.dampingForce(length, rate).times(rate).negated();
  }

  /** {@inheritDoc} Length, its rate and the tension. */
  @Override
  public List<Scalar> values() {
    return List.of(length, rate, law.tension(length, rate));
  }
}
