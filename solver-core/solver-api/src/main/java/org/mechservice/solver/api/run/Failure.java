package org.mechservice.solver.api.run;

import java.util.List;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The reason why a run could not continue.
 *
 * @param code entry of the error catalogue, such as {@code N-001}
 * @param cause the cause in one sentence
 * @param time simulated time of the failure, s
 * @param stepSize attempted step, s; 0 before the first step
 * @param order order of the attempted method; 0 before the first step
 * @param part the joint, body or state concerned; empty if none can be named
 * @param advice the remedy
 * @param lastSteps last attempted steps, in order of time; empty if the failure was not in a step
 */
public record Failure(
    MessageCode code,
    String cause,
    double time,
    double stepSize,
    int order,
    String part,
    String advice,
    List<Step> lastSteps) {

  public Failure {
    lastSteps = List.copyOf(lastSteps);
  }

  /** Creates a failure without the steps that led to it. */
  public Failure(
      MessageCode code,
      String cause,
      double time,
      double stepSize,
      int order,
      String part,
      String advice) {
    this(code, cause, time, stepSize, order, part, advice, List.of());
  }

  /**
   * An attempted step.
   *
   * @param time simulated time of its start, s
   * @param stepSize s
   * @param order order of the method
   * @param error estimated error divided by the permitted one; NaN if it was not computed
   * @param result outcome of the step, such as {@code accepted}
   */
  public record Step(double time, double stepSize, int order, double error, String result) {
    /** Result of a step whose implicit equations were not solved. */
    public static final String UNSOLVED = "its equations were not solved";

    @Override
    public String toString() {
      String tried = "t=" + time + " s, h=" + stepSize + " s, order " + order;
      return tried + (Double.isNaN(error) ? "" : ", error " + (float) error) + ": " + result;
    }
  }

  /** Returns the failure with the steps that led to it. */
  public Failure after(List<Step> steps) {
    return new Failure(code, cause, time, stepSize, order, part, advice, steps);
  }

  /** Returns the failure as one message. */
  public String message() {
    StringBuilder text = new StringBuilder(code.code()).append(" t=").append(time).append(" s");
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
