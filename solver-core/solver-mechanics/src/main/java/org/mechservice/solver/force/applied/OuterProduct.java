package org.mechservice.solver.force.applied;

/**
 * Outer product of the gradient of a number with a load proportional to it: a wrench on a link, or
 * a joint force.
 */
public final class OuterProduct implements GradientSink {
  private final double[] direction = new double[6];
  private final double[] byPlace = new double[36];
  private final double[] byVelocity = new double[36];
  private final double[] placeColumn = new double[6];
  private final double[] velocityColumn = new double[6];
  private int on;
  private boolean onLink;
  private double factor;
  private ForceJacobian target;

  /**
   * @param target receives the derivatives
   */
  public OuterProduct(ForceJacobian target) {
    this.target = target;
  }

  public void to(ForceJacobian sink) {
    target = sink;
  }

  /**
   * Sets the load to the number times a wrench on a link.
   *
   * @param wrench 6 numbers in link axes; copied
   */
  public void wrench(int link, double[] wrench, double scale) {
    on = link;
    onLink = true;
    for (int i = 0; i < 6; i++) {
      direction[i] = scale * wrench[i];
    }
  }

  /** Sets the load to the number times a factor in a joint. */
  public void force(int coordinate, double scale) {
    on = coordinate;
    onLink = false;
    factor = scale;
  }

  @Override
  public void byLink(int link, double[] place, double[] velocity) {
    if (!onLink) {
      for (int j = 0; j < 6; j++) {
        placeColumn[j] = factor * place[j];
        velocityColumn[j] = factor * velocity[j];
      }
      target.forceByLink(on, link, placeColumn, velocityColumn);
      return;
    }
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 6; j++) {
        byPlace[6 * i + j] = direction[i] * place[j];
        byVelocity[6 * i + j] = direction[i] * velocity[j];
      }
    }
    target.wrenchByLink(on, link, byPlace, byVelocity);
  }

  @Override
  public void byCoordinate(int coordinate, double place, double velocity) {
    if (!onLink) {
      target.forceByCoordinate(on, coordinate, factor * place, factor * velocity);
      return;
    }
    for (int i = 0; i < 6; i++) {
      placeColumn[i] = direction[i] * place;
      velocityColumn[i] = direction[i] * velocity;
    }
    target.wrenchByCoordinate(on, coordinate, placeColumn, velocityColumn);
  }
}
