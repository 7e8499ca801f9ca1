package org.mechservice.solver.catalogue;

/**
 * The two words that stand where the name of a formulation, closure or integrator is expected and
 * that are no method. Names travel as text in model files, requests, JARs and reports; {@link
 * Formulation}, {@link ClosureMethod} and {@link IntegrationMethod} are what they stand for.
 */
public final class MethodNames {
  /** The service is to choose. */
  public static final String AUTO = "auto";

  /** There is nothing to choose: no loops to close, no states to integrate. */
  public static final String NONE = "none";

  private MethodNames() {}
}
