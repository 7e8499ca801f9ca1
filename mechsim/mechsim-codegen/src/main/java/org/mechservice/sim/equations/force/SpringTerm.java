package org.mechservice.sim.equations.force;

import java.util.List;
import java.util.Optional;
import org.mechservice.sim.equations.coordinates.PairMotion;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A spring and damper along the line between two points: the force on point 2 is −T n. The line is
 * not defined if the points coincide: a spring without tension there uses the direction of the
 * velocity u; any other spring has no direction.
 */
final class SpringTerm implements ForceTerm {
  private final PairMotion pair;
  private final SpringLaw law;
  private final ScalarVector way;
  private final Scalar length;
  private final Scalar rate;
  private final boolean slack;

  /** Whether its length never changes, so that it has no effect on the motion. */
  private final boolean still;

  /**
   * @param name of the force, for messages
   * @throws ModelBuildException N-031 if its points coincide in all positions and it has a tension
   *     there
   */
  SpringTerm(String name, PairMotion pair, SpringLaw law) {
    this.pair = pair;
    this.law = law;
    this.way = pair.way();
    this.length = way.dot(way).squareRoot();
    this.slack = law.isSlackAtZero(length.expressions());
    boolean coincident = length.isZero();
    if (coincident && !slack && !pair.isRigid()) {
      throw new ModelBuildException(
          MessageCode.FORCE_WITHOUT_DIRECTION,
          "force \""
              + name
              + "\" has no direction: its two points coincide in every position; move one of them,"
              + " or use an element that suits the motion");
    }
    this.still = pair.isRigid() || coincident;
    this.rate = still ? length.expressions().zero() : rate(pair.velocity());
  }

  private Scalar rate(ScalarVector velocity) {
    Scalar along = way.dot(velocity).over(length);
    return slack ? atZero(velocity.dot(velocity).squareRoot(), along) : along;
  }

  /** Returns one value if the points coincide, otherwise another. */
  private Scalar atZero(Scalar coincident, Scalar apart) {
    Expressions e = length.expressions();
    return e.function(MathFunction.CHOOSE, length, e.zero(), coincident, apart);
  }

  @Override
  public Optional<Direction> direction() {
    return slack || still ? Optional.empty() : Optional.of(new Direction(length, 0));
  }

  @Override
  public void apply(Loads loads) {
    if (still) {
      return;
    }
    Scalar perLength = law.tension(length, rate).over(length).negated();
    if (!slack) {
      pair.addForce(way.times(perLength), loads);
      return;
    }
    Expressions e = length.expressions();
    Scalar resisting = law.dampingForce(e.zero(), e.one()).negated();
    ScalarVector along = way.times(atZero(e.zero(), perLength));
    pair.addForce(along.plus(pair.velocity().times(atZero(resisting, e.zero()))), loads);
  }

  @Override
  public Scalar potential() {
    return law.potential(length);
  }

  @Override
  public Scalar power() {
    return law.dampingForce(length, rate).times(rate).negated();
  }

  @Override
  public List<Scalar> values() {
    return List.of(length, rate, law.tension(length, rate));
  }
}
