package org.mechservice.solver.api;

/**
 * Why a run could not go on.
 *
 * @param code entry of the error catalogue, such as {@code N-001}
 * @param cause what happened, in one sentence
 * @param time simulated time at which it happened, s
 * @param stepSize step tried, s; 0 before the first step
 * @param order order of the method tried; 0 before the first step
 * @param part the joint, body or state it happened at; empty if none can be named
 * @param advice what to do about it
 */
public record Failure(
    String code,
    String cause,
    double time,
    double stepSize,
    int order,
    String part,
    String advice) {

  /** Returns the failure as one message. */
  public String message() {
    StringBuilder text = new StringBuilder(code).append(" t=").append(time).append(" s");
    if (stepSize != 0) {
      text.append(", h=").append(stepSize).append(" s, order ").append(order);
    }
    text.append(": ").append(cause);
    if (!part.isEmpty()) {
      text.append(" At ").append(part).append('.');
    }
    if (!advice.isEmpty()) {
      text.append(' ').append(advice);
    }
    return text.toString();
  }
}
