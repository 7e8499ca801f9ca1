package org.mechservice.sim.gradient;

import java.util.List;
import org.mechservice.sim.equations.ArticulatedBodyEquations;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.symbol.Program;

/** The equations of an open chain, y' = f(t, y) by the articulated-body recursion. */
final class OpenVariations extends VariationalEquations {
  private final DifferentiableFunction function;

  OpenVariations(Mechanism mechanism, int[] chosen, double[] parameters) {
    super(mechanism.stateCount());
    function =
        new DifferentiableFunction(
            ArticulatedBodyEquations.derive(Links.of(mechanism)),
            states(),
            states(),
            chosen,
            parameters);
  }

  @Override
  public int derivative(double t, double[] y, double[] yDot) {
    return function.value(t, y, yDot);
  }

  @Override
  public void directions(int[] unit) {
    function.directions(unit);
  }

  @Override
  public int tangents(double t, double[] y, double[] seeds, double[] out) {
    return function.tangents(t, y, seeds, out);
  }

  @Override
  public int tangent(double t, double[] y, double[] seed, double[] out) {
    return function.tangent(t, y, seed, out);
  }

  @Override
  public int adjoint(double t, double[] y, double[] weights, double[] out) {
    return function.adjoint(t, y, weights, out);
  }

  @Override
  Iterable<Program> programs() {
    return List.of(function.program());
  }
}
