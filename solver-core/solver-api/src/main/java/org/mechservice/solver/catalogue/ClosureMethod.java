package org.mechservice.solver.catalogue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Methods to close the loops of a closed chain.
 *
 * <p>The name {@code auto} is not a method: the service then chooses one. An open chain has none.
 */
public enum ClosureMethod {
  /** The second velocity transformation onto independent coordinates. */
  PROJECTION("projection"),
  /** The augmented Lagrangian; parameters may follow the name. */
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
