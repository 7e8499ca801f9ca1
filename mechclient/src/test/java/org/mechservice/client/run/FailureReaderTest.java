package org.mechservice.client.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.StepTried;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.catalogue.MessageCode;

class FailureReaderTest {
  private static final List<Failure.Step> STEPS =
      List.of(
          new Failure.Step(0.1, 1e-3, 4, 0.25, "accepted"),
          new Failure.Step(0.2, 2e-3, 5, 17.5, "error too large"),
          new Failure.Step(0.2, 1e-3, 1, Double.NaN, Failure.Step.UNSOLVED));
  private static final Failure FAILURE =
      new Failure(
          MessageCode.STEP_TOO_SMALL,
          "The error test fails.",
          0.2,
          1e-3,
          1,
          "joint a: b",
          "Wait.",
          STEPS);

  private static FailureRecord onTheWire() {
    return new FailureRecord(
        FAILURE.code().code(),
        FAILURE.cause(),
        FAILURE.time(),
        FAILURE.stepSize(),
        FAILURE.order(),
        FAILURE.part(),
        FAILURE.advice(),
        STEPS.stream()
            .map(s -> new StepTried(s.time(), s.stepSize(), s.order(), s.error()))
            .toArray(StepTried[]::new));
  }

  @Test
  void failureOfARemoteRunIsThatOfALocalOne() {
    String lines = STEPS.stream().map(Failure.Step::toString).collect(Collectors.joining("\n"));
    assertThat(FailureReader.of(onTheWire(), Map.of("lastSteps", lines))).isEqualTo(FAILURE);
  }

  @Test
  void failureWithoutAReportHasNoStepsAndTheSameMessage() {
    Failure told = FailureReader.of(onTheWire(), Map.of("outcome", "failed"));
    assertThat(told.lastSteps()).isEmpty();
    assertThat(told.message()).isEqualTo(FAILURE.message());
  }
}
