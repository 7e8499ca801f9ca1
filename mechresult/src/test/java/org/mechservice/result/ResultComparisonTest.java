package org.mechservice.result;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.result.Variable;

class ResultComparisonTest {
  private static final Variable TIME = new Variable("t", "s");

  private static double[] times(int steps) {
    return IntStream.rangeClosed(0, steps).mapToDouble(i -> 10.0 * i / steps).toArray();
  }

  private static SignalTable signal(double[] times, DoubleUnaryOperator x) {
    return new SignalTable(
        List.of(TIME, new Variable("x", "m")),
        List.of(times, DoubleStream.of(times).map(x).toArray()));
  }

  private static ResultComparison compare(SignalTable first, SignalTable second, double tolerance) {
    return ResultComparison.of(first, second, tolerance, OptionalDouble.empty());
  }

  @Test
  void sameResultIsEqualWithoutTolerance() {
    SignalTable sine = signal(times(100), Math::sin);

    assertThat(compare(sine, sine, 0).isEqual()).isTrue();
    assertThat(compare(sine, signal(times(100), Math::sin), 0).isEqual()).isTrue();
  }

  @Test
  void lastBitIsADifferenceWithoutTolerance() {
    SignalTable sine = signal(times(100), Math::sin);
    SignalTable other = signal(times(100), t -> t == 5 ? Math.nextUp(Math.sin(t)) : Math.sin(t));

    ResultComparison comparison = compare(sine, other, 0);

    assertThat(comparison.isEqual()).isFalse();
    assertThat(comparison.signals().get(0).time()).isEqualTo(5);
  }

  @Test
  void toleranceIsRelativeToTheRangeOfTheSignal() {
    SignalTable large = signal(times(1000), t -> 1e6 * Math.sin(t));
    SignalTable shifted = signal(times(1000), t -> 1e6 * Math.sin(t) + 1900);

    assertThat(compare(large, shifted, 1e-3).isEqual()).isTrue();
    assertThat(compare(large, shifted, 1e-4).isEqual()).isFalse();
  }

  @Test
  void otherTimesAreInterpolated() {
    SignalTable fine = signal(times(1000), t -> 3 * t);
    SignalTable coarse = signal(times(7), t -> 3 * t);

    assertThat(compare(fine, coarse, 1e-12).isEqual()).isTrue();
    assertThat(compare(coarse, fine, 1e-12).isEqual()).isTrue();
  }

  @Test
  void jumpALittleLaterIsNoDifferenceWithinTheTimeTolerance() {
    SignalTable jump = signal(times(1000), t -> t < 5 ? 0 : 1);
    SignalTable later = signal(times(1000), t -> t < 5.05 ? 0 : 1);

    assertThat(ResultComparison.of(jump, later, 1e-3, OptionalDouble.of(0.1)).isEqual()).isTrue();
    assertThat(ResultComparison.of(jump, later, 1e-3, OptionalDouble.of(0.01)).isEqual()).isFalse();
    assertThat(compare(jump, later, 1e-3).timeTolerance()).isEqualTo(1e-2);
  }

  @Test
  void peakOfEitherResultIsADifferenceWithItsTimeAndSize() {
    SignalTable flat = signal(times(10), t -> Math.min(t, 5));
    SignalTable peak = signal(times(1000), t -> Math.min(t, 5) + (t == 7.77 ? 2 : 0));

    SignalDifference second = compare(flat, peak, 1e-3).signals().get(0);
    assertThat(second.time()).isEqualTo(7.77);
    assertThat(second.first()).isEqualTo(5);
    assertThat(second.second()).isEqualTo(7);
    assertThat(second.difference()).isEqualTo(2);
    SignalDifference first = compare(peak, flat, 1e-3).signals().get(0);
    assertThat(first.first()).isEqualTo(7);
    assertThat(first.relative()).isEqualTo(second.relative());
  }

  @Test
  void windowOverManyRowsIsSearchedWhole() {
    double[] times = times(10_000);
    SignalTable saw = signal(times, t -> t < 2 || t > 8 ? 0 : t % 1);
    SignalTable shifted = signal(times, t -> t < 2.37 || t > 8.37 ? 0 : (t - 0.37) % 1);

    assertThat(ResultComparison.of(saw, shifted, 1e-3, OptionalDouble.of(0.4)).isEqual()).isTrue();
    assertThat(ResultComparison.of(saw, shifted, 1e-3, OptionalDouble.of(0.3)).isEqual()).isFalse();
  }

  @Test
  void roundingErrorsOfASignalThatIsZeroAreNoDifference() {
    List<Variable> columns = List.of(TIME, new Variable("x", "m"), new Variable("y", "m"));
    double[] times = times(100);
    double[] x = DoubleStream.of(times).map(Math::sin).toArray();
    double[] noise = DoubleStream.of(times).map(t -> 1e-17 * Math.cos(50 * t)).toArray();
    SignalTable noisy = new SignalTable(columns, List.of(times, x, noise));
    SignalTable still = new SignalTable(columns, List.of(times, x, new double[times.length]));

    assertThat(compare(noisy, still, 1e-6).isEqual()).isTrue();
  }

  /** The unit's largest signal is in one of them only. */
  @Test
  void orderOfTheResultsDoesNotMatter() {
    double[] times = times(10);
    Variable small = new Variable("small", "m");
    double[] noise = new double[times.length];
    noise[3] = 1e-12;
    double[] large = new double[times.length];
    Arrays.fill(large, 1);
    SignalTable noisy = new SignalTable(List.of(TIME, small), List.of(times, noise));
    SignalTable still =
        new SignalTable(
            List.of(TIME, small, new Variable("large", "m")),
            List.of(times, new double[times.length], large));

    SignalDifference there = compare(noisy, still, 0.01).signals().get(0);
    SignalDifference back = compare(still, noisy, 0.01).signals().get(0);

    assertThat(there.relative()).isEqualTo(back.relative()).isLessThan(0.01);
  }

  @Test
  void constantSignalIsComparedByItsValue() {
    SignalTable five = signal(times(10), t -> 5);

    assertThat(compare(five, signal(times(10), t -> 5 + 1e-6), 1e-3).isEqual()).isTrue();
    assertThat(compare(five, signal(times(10), t -> 5.1), 1e-3).isEqual()).isFalse();
  }

  @Test
  void numberBesideNoNumberIsADifference() {
    SignalTable sine = signal(times(10), Math::sin);
    SignalTable hole = signal(times(10), t -> t == 4 ? Double.NaN : Math.sin(t));

    assertThat(compare(sine, hole, 0.1).isEqual()).isFalse();
    assertThat(compare(hole, hole, 0).isEqual()).isTrue();
  }

  @Test
  void otherColumnsUnitsAndIntervalsAreNamed() {
    SignalTable first =
        new SignalTable(
            List.of(TIME, new Variable("x", "m"), new Variable("a", "N")),
            List.of(times(10), times(10), times(10)));
    double[] half = DoubleStream.of(times(10)).map(t -> t / 2).toArray();
    SignalTable second =
        new SignalTable(
            List.of(TIME, new Variable("x", "mm"), new Variable("b", "N")),
            List.of(half, half, half));

    assertThat(compare(first, second, 1e-3).remarks())
        .containsExactly(
            "column a is in the first result only",
            "column x is in m and in mm",
            "column b is in the second result only",
            "the first result ends at 10.0 s, the second at 5.0 s");
  }
}
