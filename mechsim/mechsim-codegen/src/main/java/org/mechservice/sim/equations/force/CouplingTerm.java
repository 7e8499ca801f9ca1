package org.mechservice.sim.equations.force;

import java.util.List;
import org.mechservice.sim.equations.coordinates.Relation;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.force.law.CoordinateLoad;
import org.mechservice.solver.symbol.Scalar;

/**
 * A force along a formula of positions.
 *
 * @param relation the formula x
 * @param rate x'
 * @param load conjugate to x
 */
record CouplingTerm(Relation relation, Scalar rate, CoordinateLoad load) implements ForceTerm {
  @Override
  public void apply(Loads loads) {
    relation.addForce(load.force(), loads);
  }

  @Override
  public Scalar potential() {
    return load.potential();
  }

  /** {@inheritDoc} The part x_t of the rate is driven: F (x' − x_t) and the rate of the energy. */
  @Override
  public Scalar power() {
    return load.force().negated().times(relation.slopeByTime()).plus(load.power());
  }

  /** {@inheritDoc} x, its rate and the tension. */
  @Override
  public List<Scalar> values() {
    return List.of(relation.value(), rate, load.force().negated());
  }
}
