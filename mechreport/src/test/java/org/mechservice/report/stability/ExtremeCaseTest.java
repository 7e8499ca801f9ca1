package org.mechservice.report.stability;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.solver.catalogue.MethodNames;

class ExtremeCaseTest {
  private static final SimulationMethod METHOD =
      new SimulationMethod("DTR", MethodNames.NONE, "ode113");

  private static ExtremeCase wanted(ExtremeCase.Expectation expectation, String part) {
    return new ExtremeCase(
        "x.xml", "hard", expectation, part, 1e-8, ExtremeCase.JudgedBy.REFERENCE, 1e-5);
  }

  private static CaseOutcome outcome(ExtremeCase wanted, double error, String cause) {
    MeasuredRun run =
        new MeasuredRun(
            METHOD.name(),
            1e-8,
            0,
            cause,
            0,
            0,
            1,
            0,
            2,
            0,
            0,
            new MeasuredRun.Errors(error, error, error, error, Double.NaN, Double.NaN),
            0,
            Map.of());
    MethodOutcome method = MethodOutcome.of(METHOD, run, wanted);
    return new CaseOutcome(wanted, List.of(method), "", List.of(), "");
  }

  @Test
  void suiteHasItsScenesAndMoreThanTwentyFiveOfItsOwn() {
    List<ExtremeCase> suite = ExtremeCase.suite();
    assertThat(suite).hasSizeGreaterThanOrEqualTo(11 + 25);
    assertThat(suite).allSatisfy(one -> assertThat(one.content()).isNotEmpty());
  }

  @Test
  void motionWithinTheBoundIsAsExpected() {
    ExtremeCase wanted = wanted(ExtremeCase.Expectation.MOTION, "");
    assertThat(outcome(wanted, 1e-6, "").asExpected()).isTrue();
  }

  @Test
  void motionThatEndsWellAndIsWrongIsNot() {
    ExtremeCase wanted = wanted(ExtremeCase.Expectation.MOTION_OR_REFUSAL, "");
    assertThat(outcome(wanted, 1e-4, "").asExpected()).isFalse();
    assertThat(outcome(wanted, Double.POSITIVE_INFINITY, "").asExpected()).isFalse();
  }

  @Test
  void failureMustHaveACode() {
    ExtremeCase wanted = wanted(ExtremeCase.Expectation.MOTION_OR_REFUSAL, "");
    assertThat(outcome(wanted, Double.NaN, "N-001 t=0.1 s: too stiff").asExpected()).isTrue();
    assertThat(outcome(wanted, Double.NaN, "went wrong").asExpected()).isFalse();
  }

  @Test
  void refusalMustNameThePart() {
    ExtremeCase wanted = wanted(ExtremeCase.Expectation.REFUSAL, "ja");
    assertThat(outcome(wanted, Double.NaN, "N-010 joint ja is locked").asExpected()).isTrue();
    assertThat(outcome(wanted, Double.NaN, "N-010 something is locked").asExpected()).isFalse();
    assertThat(outcome(wanted, 1e-9, "").asExpected()).isFalse();
  }
}
