package org.mechservice.sim.equations.force;

import java.util.List;
import org.mechservice.sim.equations.coordinates.Relation;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.symbol.Scalar;

/** A spring and damper along a formula x of positions: the tension −T is conjugate to x. */
final class CouplingTerm implements ForceTerm {
  private final Relation relation;
  private final SpringLaw law;
  private final Scalar x;
  private final Scalar rate;

  CouplingTerm(Relation relation, SpringLaw law) {
    this.relation = relation;
    this.law = law;
    this.x = relation.value();
    this.rate = relation.rate();
  }

  @Override
  public void apply(Loads loads) {
    relation.addForce(law.tension(x, rate).negated(), loads);
  }

  @Override
  public Scalar potential() {
    return law.potential(x);
  }

  /** Returns −T (x′ − x_t) + (T − d) x′ = T x_t − d x′ with the damper's part d. */
  @Override
  public Scalar power() {
    Scalar byTime = law.tension(x, rate).times(relation.slopeByTime());
    return byTime.minus(law.dampingForce(x, rate).times(rate));
  }

  @Override
  public List<Scalar> values() {
    return List.of(x, rate, law.tension(x, rate));
  }
}
