package org.mechservice.solver.simulation;

/** The version of this solver; results of different versions may differ in their last bits. */
public final class SolverVersion {
  /** Version of the solver, as in the build. */
  public static final String CURRENT = "0.1.0";

  private SolverVersion() {}
}
