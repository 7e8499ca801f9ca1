package org.mechservice.solver.dynamics.derivative;

import org.mechservice.solver.dynamics.recursion.LinkDerivatives;
import org.mechservice.solver.force.applied.ForceJacobian;

/**
 * Adds the derivatives of applied forces to those of M a + b, whose sign is the opposite: F = M a +
 * b − τ − Jᵀ w. Derivatives by driven coordinates and of driving forces are left out: driven
 * coordinates do not vary, and their forces are not equations.
 */
final class ForceDerivatives implements ForceJacobian {
  private static final double[] NONE = {};

  private final LinkDerivatives links;
  private final int stateVelocityCount;

  ForceDerivatives(LinkDerivatives links, int stateVelocityCount) {
    this.links = links;
    this.stateVelocityCount = stateVelocityCount;
  }

  @Override
  public void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity) {
    links.add(on, by, -1, byPlace, byVelocity, NONE);
  }

  @Override
  public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {
    if (by < stateVelocityCount) {
      links.addByCoordinate(on, by, -1, byPlace, byVelocity);
    }
  }

  @Override
  public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {
    if (on < stateVelocityCount) {
      links.addToForce(on, by, -1, byPlace, byVelocity);
    }
  }

  @Override
  public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {
    if (on < stateVelocityCount && by < stateVelocityCount) {
      links.addDirect(on, by, -byPlace, -byVelocity);
    }
  }
}
