package org.mechservice.solver.ode;

/**
 * A system in which some components share one error weight: the four Euler parameters of a rotation
 * are weighed by the norm of the four, so that one of them crossing zero does not tighten the test
 * (docs/theory/integrators.md#error-control). Implemented beside {@link OdeSystem} or {@link
 * ResidualSystem}.
 */
public interface ErrorWeightGroups {
  /** Returns the number of groups. */
  int groupCount();

  /** Returns the first component of a group; its others follow. */
  int groupStart(int group);

  /** Returns the number of components of a group. */
  int groupSize(int group);

  /**
   * Returns the size beyond which a component does not loosen its own test, positive: a wheel that
   * has turned a thousand times is to be known to the same angle as one that has turned once.
   */
  default double largestSize(int component) {
    return Double.POSITIVE_INFINITY;
  }
}
