package org.mechservice.sim.equations.force;

import java.util.List;
import org.mechservice.sim.equations.coordinates.RelativeFrameMotion;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.expression.Formulas;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/** A force between two frames given by formulas of their relative motion. */
final class PairForceTerm implements ForceTerm {
  private final RelativeFrameMotion frames;
  private final Formulas formulas;
  private final PairForce element;

  PairForceTerm(RelativeFrameMotion frames, Formulas formulas, PairForce element) {
    this.frames = frames;
    this.formulas = formulas;
    this.element = element;
  }

  /** Returns the moment or the force: three components of the wrench. */
  private ScalarVector part(int first) {
    return new ScalarVector(
        formulas.scalar(element.wrench().get(first)),
        formulas.scalar(element.wrench().get(first + 1)),
        formulas.scalar(element.wrench().get(first + 2)));
  }

  @Override
  public void apply(Loads loads) {
    frames.addWrench(part(3), part(0), loads);
  }

  @Override
  public Scalar potential() {
    return formulas.scalar(element.potential());
  }

  @Override
  public Scalar power() {
    return part(0)
        .dot(frames.omega())
        .plus(part(3).dot(frames.rate()))
        .plus(formulas.scalar(element.potentialRate()));
  }

  @Override
  public List<Scalar> values() {
    return element.outputs().stream().map(one -> formulas.scalar(one.expression())).toList();
  }
}
