package org.mechservice.sim.equations.force;

import java.util.List;
import java.util.Optional;
import org.mechservice.sim.equations.coordinates.PairMotion;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.force.law.PairLoad.Direction;
import org.mechservice.solver.force.law.SpringLaw;
import org.mechservice.solver.force.law.SpringLoad;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/** A spring and damper along the line between two points. */
final class SpringTerm implements ForceTerm {
  private final PairMotion pair;
  private final SpringLoad load;

  /** Whether its length never changes, so that it has no effect on the motion. */
  private final boolean still;

  /**
   * @param name of the force, for messages
   * @throws ModelBuildException N-031 if its points coincide in all positions and it has a tension
   *     there
   */
  SpringTerm(String name, PairMotion pair, SpringLaw law) {
    this.pair = pair;
    ScalarVector way = pair.way();
    boolean coincident = way.dot(way).isZero();
    this.still = pair.isRigid() || coincident;
    ScalarVector none = ScalarVector.zero(way.x().expressions());
    this.load = new SpringLoad(law, way, still ? none : pair.velocity());
    if (coincident && !pair.isRigid() && !load.isSlack()) {
      throw new ModelBuildException(
          MessageCode.FORCE_WITHOUT_DIRECTION,
          "force \""
              + name
              + "\" has no direction: its two points coincide in every position; move one of them,"
              + " or use an element that suits the motion");
    }
  }

  @Override
  public Optional<Direction> direction() {
    return still ? Optional.empty() : load.direction();
  }

  @Override
  public void apply(Loads loads) {
    if (!still) {
      pair.addForce(load.force(), loads);
    }
  }

  @Override
  public Scalar potential() {
    return load.potential();
  }

  @Override
  public Scalar power() {
    return load.power();
  }

  @Override
  public List<Scalar> values() {
    return load.values();
  }
}
