package org.mechservice.study.optimise;

/**
 * A quantity of a design problem with its purpose: objective, residual or constraint.
 *
 * @param kind its purpose
 * @param text the expression, for people
 * @param scale size of the quantity that counts as 1 for tolerances; 0 for its size at the start
 */
public record Aim(Kind kind, String text, double scale) {
  /** The purpose of a quantity. */
  public enum Kind {
    /** As small as possible. */
    MINIMISE,
    /** Its square is one term of a sum that is to be as small as possible. */
    RESIDUAL,
    /** Zero or less. */
    AT_MOST_ZERO,
    /** Zero. */
    ZERO
  }

  /** A quantity that is scaled by its size at the start. */
  public Aim(Kind kind, String text) {
    this(kind, text, 0);
  }

  boolean isConstraint() {
    return kind == Kind.AT_MOST_ZERO || kind == Kind.ZERO;
  }
}
