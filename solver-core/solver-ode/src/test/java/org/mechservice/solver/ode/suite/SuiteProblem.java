package org.mechservice.solver.ode.suite;

import java.util.List;
import java.util.stream.Stream;
import org.mechservice.solver.ode.OdeSystem;

/** A problem of the integrator suite: autonomous data that a test can integrate and judge. */
public interface SuiteProblem extends OdeSystem {
  /** Returns where it starts and ends and what is known about its solution. */
  VerifiedValues reference();

  @Override
  default int dimension() {
    return reference().initialState().length;
  }

  /** Returns the problem's name. */
  default String name() {
    return getClass().getSimpleName();
  }

  /** Returns the problems without stiffness, new. */
  static List<SuiteProblem> nonstiff() {
    return List.of(
        new Pleiades(),
        new Arenstorf(),
        new Kepler(),
        new EulerRigidBody(),
        new VanDerPol(),
        new DetestA3(),
        new FastOscillator(),
        new SixLinkChain());
  }

  /** Returns the stiff problems, new. */
  static List<SuiteProblem> stiff() {
    return List.of(
        new Robertson(),
        new Hires(),
        new StiffVanDerPol(),
        new Brusselator(),
        new ProtheroRobinson(),
        new Flame(),
        new DampedOscillator(),
        new StiffChain());
  }

  /** Returns a new problem by its name. */
  static SuiteProblem named(String name) {
    return Stream.concat(nonstiff().stream(), stiff().stream())
        .filter(p -> p.name().equals(name))
        .findFirst()
        .orElseThrow();
  }
}
