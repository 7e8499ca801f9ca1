package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Steps and states are told in the course of the integration, with bounded memory. */
class StreamedSolutionTest {
  private static final OdeFunction ROTATION =
      (t, y, yDot) -> {
        yDot[0] = y[1];
        yDot[1] = -y[0];
      };

  private static OdeOptions with(OdeMethod method) {
    return OdeOptions.standard().rtol(1e-8).atol(1e-10).method(method);
  }

  private static OdeSolution rotate(double t0, double t1, OdeOptions options) {
    return Ode.solve(
        ROTATION, t0, new double[] {StrictMath.cos(t0), -StrictMath.sin(t0)}, t1, options);
  }

  @ParameterizedTest
  @EnumSource
  void outputHasTheBitsOfTheSolution(OdeMethod method) {
    double[] times = {0, 0.1, 0.1, 3.7, 9.99, 10};
    List<double[]> told = new ArrayList<>();
    List<Double> when = new ArrayList<>();
    OdeSolution solution =
        rotate(
            0,
            10,
            with(method)
                .output(
                    times,
                    (t, y) -> {
                      when.add(t);
                      told.add(y.clone());
                    }));
    assertThat(when).containsExactly(0.0, 0.1, 0.1, 3.7, 9.99, 10.0);
    for (int i = 0; i < times.length; i++) {
      assertThat(told.get(i)).isEqualTo(solution.at(times[i]));
    }
  }

  @Test
  void equalDistancesRunFromTheStartToTheEnd() {
    List<Double> forth = new ArrayList<>();
    List<Double> back = new ArrayList<>();
    List<Double> beside = new ArrayList<>();
    OdeOptions options = with(OdeMethod.ODE113);
    rotate(0, 0.3, options.outputEvery(0.1, (t, y) -> forth.add(t)));
    rotate(1, 0, options.outputEvery(0.25, (t, y) -> back.add(t)));
    rotate(0, 1, options.outputEvery(0.4, (t, y) -> beside.add(t)));
    assertThat(forth).containsExactly(0.0, 0.1, 0.2, 0.3);
    assertThat(back).containsExactly(1.0, 0.75, 0.5, 0.25, 0.0);
    assertThat(beside).containsExactly(0.0, 0.4, 0.8);
  }

  @Test
  void outputTimesOutOfOrderOrIntervalAreRefused() {
    OdeOptions options = with(OdeMethod.ODE113);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> rotate(0, 1, options.output(new double[] {0.5, 2}, (t, y) -> {})))
        .withMessageContaining("output time 1 is 2.0")
        .withMessageContaining("between the start 0.0 and the end 1.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> rotate(0, 1, options.output(new double[] {0.5, 0.2}, (t, y) -> {})))
        .withMessageContaining("comes after 0.5");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> options.outputEvery(0, (t, y) -> {}))
        .withMessageContaining("distance of output times is 0.0");
  }

  @ParameterizedTest
  @EnumSource
  void stepsToldFollowEachOther(OdeMethod method) {
    double[] last = {0};
    long[] count = {0};
    double[] y = new double[2];
    double[] yDot = new double[2];
    OdeSolution solution =
        rotate(
            0,
            10,
            with(method)
                .onStep(
                    step -> {
                      assertThat(step.start()).isEqualTo(last[0]);
                      last[0] = step.end();
                      count[0]++;
                      double middle = 0.5 * (step.start() + step.end());
                      step.at(middle, y, yDot);
                      assertThat(y[0]).isCloseTo(StrictMath.cos(middle), within(3e-6));
                      assertThat(step.order()).isPositive();
                      assertThatIllegalArgumentException()
                          .isThrownBy(() -> step.at(step.end() + 1, y))
                          .withMessageContaining("outside of the step");
                    }));
    assertThat(last[0]).isEqualTo(10);
    assertThat(count[0]).isEqualTo(solution.statistics().steps());
  }

  @Test
  void stepHandlerStopsTheIntegration() {
    OdeSolution solution =
        rotate(
            0,
            10,
            with(OdeMethod.ODE113)
                .onStep(
                    step -> {
                      if (step.end() > 3) {
                        step.stop();
                      }
                    }));
    assertThat(solution.endReason()).isEqualTo(EndReason.STOPPED);
    assertThat(solution.end()).isBetween(3.0, 5.0);
    assertThat(solution.at(2)[0]).isCloseTo(StrictMath.cos(2), within(1e-6));
  }

  @ParameterizedTest
  @EnumSource
  void memoryDoesNotGrowWithTheRunIfStepsAreNotKept(OdeMethod method) {
    OdeOptions options =
        with(method)
            .keepSteps(false)
            .event(OdeEvent.when((t, y) -> y[0] - 2).terminal())
            .onStep(SolvedStep::end)
            .outputEvery(0.1, (t, y) -> {});
    long few = allocated(10, options);
    long many = allocated(200, options);
    // The report of the statistics names the components that had steps rejected.
    assertThat(many).isLessThan(few + 200);
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE15S", "AUTO"})
  void memoryDoesNotGrowInOtherFormsEither(OdeMethod method) {
    OdeOptions options =
        with(method).keepSteps(false).event(OdeEvent.when((t, y) -> y[0] - 2).terminal());
    OdeProblem pairs =
        Ode.system(
            4,
            (t, y, yDot) -> {
              for (int i = 0; i < 4; i += 2) {
                yDot[i] = y[i + 1];
                yDot[i + 1] = -y[i];
              }
            });
    double[] y0 = {1, 0, 0, 1};
    List<OdeProblem> forms =
        List.of(
            pairs.withPattern((i, j) -> i / 2 == j / 2),
            pairs.withBlocks(2),
            pairs.withBand(1, 1),
            pairs.withJacobianProduct(
                (t, y, v, product) -> {
                  for (int i = 0; i < 4; i += 2) {
                    product[i] = v[i + 1];
                    product[i + 1] = -v[i];
                  }
                }));
    for (OdeProblem form : forms) {
      long few = allocated(() -> Ode.solve(form, 0, y0, 5, options));
      long many = allocated(() -> Ode.solve(form, 0, y0, 50, options));
      assertThat(many).as("form %d", forms.indexOf(form)).isLessThan(few + 400);
    }
  }

  @ParameterizedTest
  @EnumSource
  void memoryDoesNotGrowWithAMassMatrixEither(OdeMethod method) {
    OdeOptions options = with(method).keepSteps(false);
    OdeProblem circle =
        Ode.system(
            2,
            (t, y, yDot) -> {
              yDot[0] = 2 * y[1] - y[0];
              yDot[1] = y[1] - 3 * y[0];
            });
    List<MassProblem> problems =
        List.of(
            circle.withMass(MassMatrix.full(new double[][] {{2, 1}, {1, 3}})),
            circle.withMass(MassMatrix.banded(2, 1, 1, 0, 2, 1, 1, 3, 0)),
            circle.withMass(MassMatrix.diagonal(2, 1)));
    double[] y0 = {1, 0};
    for (MassProblem problem : problems) {
      long few = allocated(() -> Ode.solve(problem, 0, y0, 5, options));
      long many = allocated(() -> Ode.solve(problem, 0, y0, 100, options));
      assertThat(many).as("matrix %d", problems.indexOf(problem)).isLessThan(few + 400);
    }
  }

  /** Returns the least that a run allocates; the virtual machine may add something of its own. */
  private static long allocated(double t1, OdeOptions options) {
    return allocated(() -> rotate(0, t1, options));
  }

  private static long allocated(Runnable integration) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    for (int run = 0; run < 20; run++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      integration.run();
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    return least;
  }

  @Test
  void keptStepsTakeWhatTheirPolynomialsNeed() {
    OdeOptions options = with(OdeMethod.ODE113);
    OdeSolution solution = rotate(0, 1000, options);
    long numbers =
        solution.steps().stream()
            .mapToLong(step -> 2 + step.order() + 2L * (step.order() + 2))
            .sum();
    long kept = allocated(1000, options) - allocated(1000, options.keepSteps(false));
    // Twice as much while the lists grow, and blocks that are not full.
    assertThat(kept).isLessThan(3 * 8 * numbers);
  }

  @Test
  void evaluatingTheSolutionAllocatesNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    for (OdeMethod method : OdeMethod.values()) {
      OdeSolution solution = rotate(0, 10, with(method));
      double[] y = new double[2];
      long least = Long.MAX_VALUE;
      for (int run = 0; run < 20; run++) {
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int i = 1; i < 1000; i++) {
          solution.at(0.01 * i, y);
        }
        least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
      }
      assertThat(least).isZero();
    }
  }
}
