package org.mechservice.cli.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Ten lines of a report, in its order. */
class ResultOptionsTest {
  private static Map<String, Object> report(List<String> keys) {
    Map<String, Object> report = new LinkedHashMap<>();
    keys.forEach(key -> report.put(key, 1L));
    return report;
  }

  @Test
  void briefReportHasTheLinesThatMatterMost() {
    List<String> all =
        List.of(
            "scene",
            "outcome",
            "formulation",
            "integrator",
            "relativeTolerance",
            "absoluteTolerance",
            "steps",
            "rejectedSteps",
            "evaluations",
            "rows",
            "simulatedTime",
            "wallTime",
            "realTimeFactor",
            "energyDrift",
            "energyScale",
            "where");
    assertThat(ResultOptions.brief(report(all)).keySet())
        .containsExactly(
            "scene",
            "outcome",
            "formulation",
            "integrator",
            "relativeTolerance",
            "steps",
            "evaluations",
            "rows",
            "wallTime",
            "energyDrift");
  }

  @Test
  void reportWithoutAnIntegrationIsFilledUp() {
    List<String> all =
        List.of("scene", "outcome", "residual", "rows", "a", "b", "c", "d", "e", "f", "g", "h");
    assertThat(ResultOptions.brief(report(all)).keySet())
        .containsExactly("scene", "outcome", "residual", "rows", "a", "b", "c", "d", "e", "f");
  }

  @Test
  void analysisWithoutAnIntegratorHasNoLinesOfOne() {
    Map<String, Object> equilibrium =
        report(
            List.of(
                "scene",
                "formulation",
                "integrator",
                "relativeTolerance",
                "absoluteTolerance",
                "rows"));
    equilibrium.put("integrator", "none");
    assertThat(ResultOptions.brief(equilibrium).keySet())
        .containsExactly("scene", "formulation", "rows");
  }

  @Test
  void notesOnTheRunAreNeverLeftOut() {
    List<String> all =
        List.of("scene", "outcome", "a", "b", "c", "d", "e", "f", "g", "h", "i", "notes");
    assertThat(ResultOptions.brief(report(all)).keySet())
        .hasSize(ResultOptions.LINES + 1)
        .doesNotContain("i")
        .endsWith("notes");
  }
}
