package org.mechservice.report.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class SuiteTimeBudgetTest {
  private static final double RESOLUTION = 1e-9;

  private double now = 1000;

  private SuiteTimeBudget budget(double limit, double total) {
    return new SuiteTimeBudget(limit, total, () -> Math.round(now * 1e9));
  }

  @Test
  void withoutATotalEveryRunHasTheLimit() {
    SuiteTimeBudget budget = budget(5, Double.POSITIVE_INFINITY);
    budget.beginCase(1);
    now += 1e6;
    assertThat(budget.forRun(10)).isEqualTo(5);
    assertThat(budget.sentence()).isEqualTo("Runs were stopped after 5.00 s.");
  }

  @Test
  void runsShareTheTimeOfTheirCaseEqually() {
    SuiteTimeBudget budget = budget(5, 60);
    budget.beginCase(6);
    assertThat(budget.forRun(10)).isCloseTo(1, within(RESOLUTION));
    assertThat(budget.sentence()).contains("within 60.0 s");
  }

  @Test
  void whatARunLeavesGoesToTheNext() {
    SuiteTimeBudget budget = budget(5, 60);
    budget.beginCase(6);
    now += 0.1;
    assertThat(budget.forRun(9)).isCloseTo(1.1, within(RESOLUTION));
  }

  @Test
  void whatACaseLeavesGoesToTheNext() {
    SuiteTimeBudget budget = budget(50, 60);
    budget.beginCase(6);
    now += 5;
    budget.beginCase(5);
    assertThat(budget.forRun(1)).isCloseTo(11, within(RESOLUTION));
  }

  @Test
  void afterItsEndThereIsNoTimeLeft() {
    SuiteTimeBudget budget = budget(5, 60);
    now += 100;
    budget.beginCase(3);
    assertThat(budget.forRun(2)).isZero();
  }
}
