package org.mechservice.solver.ode.suite;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.mechservice.solver.ode.ResidualSystem;

/** A problem of the integrator suite in residual form. */
public interface ResidualProblem extends ResidualSystem {
  /** Returns where it ends and what is known about its solution. */
  VerifiedValues reference();

  /** Returns a derivative that fits the initial state. */
  double[] initialDerivative();

  /** Returns where it starts. */
  default double start() {
    return 0;
  }

  /** Returns how many components, from the first on, are judged. */
  default int scored() {
    return dimension();
  }

  /** Returns what vanishes along the solution. */
  default List<ToDoubleFunction<double[]>> invariants() {
    return List.of();
  }

  @Override
  default int dimension() {
    return reference().initialState().length;
  }

  /** Returns the problem's name. */
  default String name() {
    return getClass().getSimpleName();
  }

  /** Returns the correct digits of the scored components. */
  default double mixedDigits(double[] y, double[] expected) {
    return reference().mixedDigits(Arrays.copyOf(y, scored()), Arrays.copyOf(expected, scored()));
  }

  /** Returns all of them, new. */
  static List<ResidualProblem> all() {
    return List.of(
        new ConservedRobertson(),
        new TransistorAmplifier(),
        new PendulumWithMultiplier(),
        new SliderCrank(),
        new Weissinger());
  }

  /** Returns a new problem by its name. */
  static ResidualProblem named(String name) {
    return all().stream().filter(p -> p.name().equals(name)).findFirst().orElseThrow();
  }
}
