package org.mechservice.sim.equations.recursion;

import java.util.Arrays;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/** The applied loads on links and joints: forces add to them, sweeps read them. */
public final class Loads implements JointForces {
  private final Expressions expressions;
  private final Wrench[] wrenches;
  private final ScalarVector[] jointForces;

  public Loads(Expressions expressions, Links mechanism) {
    this.expressions = expressions;
    int count = mechanism.links().size();
    wrenches = new Wrench[count];
    jointForces = new ScalarVector[count];
    ScalarVector none = ScalarVector.zero(expressions);
    Arrays.fill(wrenches, new Wrench(none, none));
    Arrays.fill(jointForces, none);
  }

  /** Adds a force at a link's point and a moment, in the link's axes; has no effect on the root. */
  public void add(int link, ScalarVector point, ScalarVector force, ScalarVector moment) {
    if (link != Links.ROOT) {
      wrenches[link] = wrenches[link].plus(new Wrench(moment.plus(point.cross(force)), force));
    }
  }

  /**
   * Adds a force along a degree of freedom of a link; for Euler parameters, a moment along an axis
   * of the link.
   */
  public void addJointForce(int link, int axis, Scalar force) {
    Scalar zero = expressions.zero();
    ScalarVector along =
        new ScalarVector(
            axis == 0 ? force : zero, axis == 1 ? force : zero, axis == 2 ? force : zero);
    jointForces[link] = jointForces[link].plus(along);
  }

  /** Returns the wrench that acts on a link, about its origin in its axes. */
  public Wrench on(int link) {
    return wrenches[link];
  }

  @Override
  public ScalarVector of(int link) {
    return jointForces[link];
  }
}
