package org.mechservice.solver.force.law;

/**
 * Why a load has no direction, for messages.
 *
 * @param cause with {@code %s} in the place of an output value
 * @param value number of that value
 * @param advice what to do
 */
public record Undirected(String cause, int value, String advice) {
  /** The reason of a load that has a direction in every state. */
  static final Undirected NEVER = new Undirected("", 0, "");

  /**
   * Returns the cause.
   *
   * @param results what {@link PrintedLaw#results} gave in that state
   */
  public String cause(double[] results) {
    return cause.formatted(results[PairLaw.VALUES + value]);
  }
}
