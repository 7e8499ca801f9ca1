package org.mechservice.solver.catalogue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Relation of the error at the end of a run to the tolerances of its steps. */
public enum Accuracy {
  /** Each step keeps its local error within the tolerances, as usual; errors of steps add up. */
  STANDARD("standard"),
  /**
   * Each step keeps its local error within a 20th of the tolerances or less, so that the final
   * solution usually has all requested digits but one. It costs 1.3 to 1.5 times the evaluations.
   */
  STRICT("strict");

  /** Name of the option and of the attribute that chooses it. */
  public static final String OPTION = "accuracy";

  private final String label;

  Accuracy(String label) {
    this.label = label;
  }

  /** Returns the name in MechML and on the command line. */
  public String label() {
    return label;
  }

  /** Returns all names, in order. */
  public static List<String> labels() {
    return Arrays.stream(values()).map(Accuracy::label).toList();
  }

  /** Returns the accuracy of a name; empty if there is none. */
  public static Optional<Accuracy> find(String label) {
    return Arrays.stream(values()).filter(one -> one.label.equals(label)).findFirst();
  }

  /**
   * Returns the accuracy of a name.
   *
   * @throws IllegalArgumentException if there is none; lists the known ones
   */
  public static Accuracy of(String label) {
    return find(label)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    OPTION + " is \"" + label + "\"; it must be " + String.join(" or ", labels())));
  }

  /** Returns {@link #label}. */
  @Override
  public String toString() {
    return label;
  }
}
