package org.mechservice.sim.build.dynamics;

import java.util.List;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;

/** A spring and damper along the line between two points: the force on point 2 is −T n. */
final class SpringTerm implements ForceTerm {
  private final PairMotion pair;
  private final SpringLaw law;
  private final ScalarVector way;
  private final Scalar length;
  private final Scalar rate;

  SpringTerm(PairMotion pair, SpringLaw law) {
    this.pair = pair;
    this.law = law;
    this.way = pair.way();
    this.length = way.dot(way).squareRoot();
    this.rate =
        pair.isRigid() ? length.expressions().zero() : way.dot(pair.velocity()).over(length);
  }

  /** Returns the length of the line, which must not vanish. */
  Scalar length() {
    return length;
  }

  @Override
  public void apply(Loads loads) {
    if (!pair.isRigid()) {
      Scalar perLength = law.tension(length, rate).over(length).negated();
      pair.addForce(way.times(perLength), loads);
    }
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
