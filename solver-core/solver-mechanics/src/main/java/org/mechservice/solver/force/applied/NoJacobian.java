package org.mechservice.solver.force.applied;

/** A receiver that ignores all derivatives. */
public final class NoJacobian implements ForceJacobian {
  public static final NoJacobian INSTANCE = new NoJacobian();

  private NoJacobian() {}

  @Override
  public void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity) {}

  @Override
  public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {}

  @Override
  public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {}

  @Override
  public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {}
}
