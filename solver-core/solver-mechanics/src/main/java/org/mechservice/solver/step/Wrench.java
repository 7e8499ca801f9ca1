package org.mechservice.solver.step;

import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A force and a moment about the origin of their frame.
 *
 * @param moment N·m
 * @param force N
 */
public record Wrench(ScalarVector moment, ScalarVector force) implements Moved<Wrench> {

  public Wrench plus(Wrench other) {
    return new Wrench(moment.plus(other.moment), force.plus(other.force));
  }

  public Wrench minus(Wrench other) {
    return new Wrench(moment.minus(other.moment), force.minus(other.force));
  }

  /** Returns factor · this. */
  public Wrench times(Scalar factor) {
    return new Wrench(moment.times(factor), force.times(factor));
  }

  /** Returns factor · this. */
  public Wrench times(double factor) {
    return new Wrench(moment.times(factor), force.times(factor));
  }

  @Override
  public Wrench in(ScalarMatrix rotation) {
    return new Wrench(rotation.times(moment), rotation.times(force));
  }

  @Override
  public Wrench turned(int axis, Scalar cosine, Scalar sine) {
    return new Wrench(moment.turned(axis, cosine, sine), force.turned(axis, cosine, sine));
  }

  @Override
  public Wrench shifted(ScalarVector r) {
    return new Wrench(moment.plus(r.cross(force)), force);
  }
}
