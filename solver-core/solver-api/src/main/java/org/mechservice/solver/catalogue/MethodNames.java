package org.mechservice.solver.catalogue;

/**
 * The two words that may replace the name of a formulation, closure or integrator. Model files,
 * requests, JARs and reports contain these names as text; {@link Formulation}, {@link
 * ClosureMethod} and {@link IntegrationMethod} are their types.
 */
public final class MethodNames {
  /** The service chooses the method. */
  public static final String AUTO = "auto";

  /** No method: there are no loops to close, or no states to integrate. */
  public static final String NONE = "none";

  private MethodNames() {}
}
