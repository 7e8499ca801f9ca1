package org.mechservice.study.optimise;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** Methods of optimisation. */
public enum Method {
  /** The method that suits the problem. */
  AUTO("lm for residuals, sqp with constraints, min or max, else bobyqa"),
  /** Levenberg-Marquardt, for residuals. */
  LM("Levenberg-Marquardt, for residuals without constraints"),
  /** Sequential quadratic programming. */
  SQP("sequential quadratic programming; linear programs of rows where min or max has corners"),
  /** Powell's quadratic models on a trust region, without derivatives. */
  BOBYQA("Powell's quadratic models, without derivatives"),
  /** Covariance matrix adaptation, an evolution strategy. */
  CMAES("evolution strategy, without derivatives, for rough objectives with several minima");

  private final String description;

  Method(String description) {
    this.description = description;
  }

  /** Returns the method's name on the command line. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns what it is, in a few words. */
  public String description() {
    return description;
  }

  /** Returns the names of all methods, for messages. */
  public static String labels() {
    return Arrays.stream(values()).map(Method::label).collect(Collectors.joining(", "));
  }

  /** Returns whether it uses derivatives. */
  public boolean hasDerivatives() {
    return this == LM || this == SQP;
  }

  /**
   * Returns the method that is used for a problem. Two objectives count as one under a constraint:
   * a {@linkplain Front front} is made of such problems.
   *
   * @throws IllegalArgumentException if this one does not fit it
   */
  public Method chosenFor(DesignProblem problem) {
    return switch (this) {
      case AUTO ->
          problem.hasResiduals() && !problem.hasConstraints()
              ? LM
              : problem.hasConstraints() || problem.hasCorners() || problem.objectives().length > 1
                  ? SQP
                  : BOBYQA;
      case LM -> {
        if (!problem.hasResiduals() || problem.hasConstraints()) {
          throw new IllegalArgumentException(
              "the method lm needs residuals and takes no constraints; choose sqp, bobyqa or"
                  + " cmaes");
        }
        yield this;
      }
      case SQP, BOBYQA, CMAES -> this;
    };
  }
}
