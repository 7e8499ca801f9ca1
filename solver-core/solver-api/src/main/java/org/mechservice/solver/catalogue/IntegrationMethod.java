package org.mechservice.solver.catalogue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The integrators.
 *
 * <p>The name {@code auto} is not an integrator: the service then chooses one.
 */
public enum IntegrationMethod {
  /** Adams-Bashforth-Moulton predictor and corrector, as MATLAB's ode113. */
  ODE113("ode113", Family.ADAMS, false, "adams.Ode113"),
  /** Shampine and Gordon's Adams code DE. */
  DE("DE", Family.ADAMS, false, "adams.De"),
  /** Backward differentiation of y' = f(t, y), as MATLAB's ode15s. */
  ODE15S("ode15s", Family.BACKWARD, false, "stiff.Ode15s"),
  /** Backward differentiation of a residual F(t, y, y') = 0. */
  ODE15SR("ode15sR", Family.BACKWARD, true, "stiff.Ode15sR"),
  /** ode113, and ode15s while the equations are stiff. */
  SWITCHING("switching", Family.SWITCHING, false, "switching.Switching");

  /** The formulas of an integrator. */
  public enum Family {
    /** Adams formulas: explicit predictor, for equations that are not stiff. */
    ADAMS,
    /** Backward differentiation formulas: implicit, for stiff equations. */
    BACKWARD,
    /** Both, one at a time. */
    SWITCHING
  }

  private static final String PACKAGE = "org.mechservice.solver.ode.";

  private final String label;
  private final Family family;
  private final boolean residual;
  private final String classBelow;

  IntegrationMethod(String label, Family family, boolean residual, String classBelow) {
    this.label = label;
    this.family = family;
    this.residual = residual;
    this.classBelow = classBelow;
  }

  /** Returns the published name, such as {@code ode15sR}. */
  public String label() {
    return label;
  }

  /** Returns the family of its formulas. */
  public Family family() {
    return family;
  }

  /** Returns whether the limit of its stability may keep its steps short. */
  public boolean stabilityHasLimit() {
    return family != Family.BACKWARD;
  }

  /** Returns whether it integrates residual systems F(t, y, y') = 0; otherwise explicit ones. */
  public boolean takesResidual() {
    return residual;
  }

  /**
   * Returns the qualified name of its class. This catalogue holds the name only, because a
   * standalone JAR contains the catalogue and only the integrator that its main class names.
   */
  public String className() {
    return PACKAGE + classBelow;
  }

  /** Returns all published names, in order. */
  public static List<String> labels() {
    return Arrays.stream(values()).map(IntegrationMethod::label).toList();
  }

  /** Returns all published names as words: "a, b and c". */
  public static String listed() {
    List<String> labels = labels();
    int last = labels.size() - 1;
    return String.join(", ", labels.subList(0, last)) + " and " + labels.get(last);
  }

  /** Returns the integrator of a published name; empty if there is none. */
  public static Optional<IntegrationMethod> find(String label) {
    return Arrays.stream(values()).filter(one -> one.label.equals(label)).findFirst();
  }

  /**
   * Returns the integrator of a published name.
   *
   * @throws IllegalArgumentException with code S-063 if there is none; lists the known ones
   */
  public static IntegrationMethod of(String label) {
    return find(label)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    MessageCode.INTEGRATOR_UNKNOWN
                        + " integrator \""
                        + label
                        + "\" is unknown; there are "
                        + listed()));
  }

  /** Returns {@link #label}. */
  @Override
  public String toString() {
    return label;
  }
}
