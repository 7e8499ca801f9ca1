package org.mechservice.report.stability;

import java.util.List;

/**
 * The outcome of a case.
 *
 * @param wanted the case
 * @param methods outcome of each method that fits
 * @param refusal why the model itself was refused; empty if it was not
 * @param warnings of the service
 * @param judge the reference with its doubts; empty if there is none
 */
public record CaseOutcome(
    ExtremeCase wanted,
    List<MethodOutcome> methods,
    String refusal,
    List<String> warnings,
    String judge) {
  public CaseOutcome {
    methods = List.copyOf(methods);
    warnings = List.copyOf(warnings);
  }

  /** Returns whether the case ended as expected. */
  public boolean asExpected() {
    boolean honest =
        methods.stream()
            .noneMatch(
                outcome ->
                    outcome.verdict() == MethodOutcome.Verdict.SILENTLY_WRONG
                        || outcome.verdict() == MethodOutcome.Verdict.ANONYMOUS);
    return switch (wanted.expectation()) {
      case MOTION -> honest && count(MethodOutcome.Verdict.MET) > 0;
      case MOTION_OR_REFUSAL -> honest;
      case REFUSAL -> refusedByName();
    };
  }

  private boolean refusedByName() {
    if (!refusal.isEmpty()) {
      return refusal.contains(wanted.part());
    }
    return methods.stream()
        .allMatch(
            outcome ->
                outcome.verdict() == MethodOutcome.Verdict.SAID_WHY
                    && outcome.run().cause().contains(wanted.part()));
  }

  /** Returns how many methods had an outcome. */
  public long count(MethodOutcome.Verdict verdict) {
    return methods.stream().filter(outcome -> outcome.verdict() == verdict).count();
  }

  /** Returns the fewest steps of a method that met the bound; 0 if none did. */
  public long fewestSteps() {
    return methods.stream()
        .filter(outcome -> outcome.verdict() == MethodOutcome.Verdict.MET)
        .mapToLong(outcome -> outcome.run().steps())
        .min()
        .orElse(0);
  }
}
