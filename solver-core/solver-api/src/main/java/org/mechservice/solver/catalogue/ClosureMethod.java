package org.mechservice.solver.catalogue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * How the loops of a closed chain are closed.
 *
 * <p>The choice {@code auto} is no method: it leaves the choice to the service. An open chain has
 * none.
 */
public enum ClosureMethod {
  /** By the second velocity transformation onto independent coordinates. */
  PROJECTION("projection"),
  /** By the augmented Lagrangian; numbers of its own may follow the name. */
  PENALTY("penalty");

  private final String label;

  ClosureMethod(String label) {
    this.label = label;
  }

  /** Returns the name in MechML and on the command line. */
  public String label() {
    return label;
  }

  /** Returns all names, in order. */
  public static List<String> labels() {
    return Arrays.stream(values()).map(ClosureMethod::label).toList();
  }

  /** Returns the method of a name; empty if there is none. */
  public static Optional<ClosureMethod> find(String label) {
    return Arrays.stream(values()).filter(one -> one.label.equals(label)).findFirst();
  }

  /**
   * Returns the method of a name.
   *
   * @throws IllegalArgumentException if there is none; lists the known ones
   */
  public static ClosureMethod of(String label) {
    return find(label)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "there is no closure \""
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
