package org.mechservice.solver.catalogue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The formulations of the equations of motion, Rodríguez et al. 2003, §3.
 *
 * <p>The name {@code auto} is not a formulation: the service then chooses one.
 */
public enum Formulation {
  /** Direct, tree recursive: accelerations by articulated bodies in O(n); open chains only. */
  DTR("DTR", false, false, false),
  /** Direct, semi-recursive: accelerations by the joint-space mass matrix. */
  DSR("DSR", true, false, false),
  /**
   * Residual, recursive: F(t, y, y') = 0 by inverse dynamics, with difference quotients for its
   * Jacobian.
   */
  RR("RR", true, true, false),
  /** As {@link #RR}, with the Jacobian by recursion. */
  RR_JF("RR-JF", true, true, true);

  private final String label;
  private final boolean loops;
  private final boolean residual;
  private final boolean recursiveJacobian;

  Formulation(String label, boolean loops, boolean residual, boolean recursiveJacobian) {
    this.label = label;
    this.loops = loops;
    this.residual = residual;
    this.recursiveJacobian = recursiveJacobian;
  }

  /** Returns the published name, such as {@code RR-JF}. */
  public String label() {
    return label;
  }

  /** Returns whether it supports closed chains; all support open ones. */
  public boolean takesLoops() {
    return loops;
  }

  /** Returns whether it is a residual F(t, y, y') = 0 rather than explicit, y' = f(t, y). */
  public boolean isResidual() {
    return residual;
  }

  /** Returns whether it has the Jacobian of its residual by recursion. */
  public boolean hasRecursiveJacobian() {
    return recursiveJacobian;
  }

  /** Returns all published names, in order. */
  public static List<String> labels() {
    return Arrays.stream(values()).map(Formulation::label).toList();
  }

  /** Returns the formulation of a published name; empty if there is none. */
  public static Optional<Formulation> find(String label) {
    return Arrays.stream(values()).filter(one -> one.label.equals(label)).findFirst();
  }

  /**
   * Returns the formulation of a published name.
   *
   * @throws IllegalArgumentException if there is none; lists the known ones
   */
  public static Formulation of(String label) {
    return find(label)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "there is no formulation \""
                        + label
                        + "\"; there are "
                        + String.join(", ", labels())));
  }

  /** Returns {@link #label}. */
  @Override
  public String toString() {
    return label;
  }
}
