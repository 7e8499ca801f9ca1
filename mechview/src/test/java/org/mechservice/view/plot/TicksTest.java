package org.mechservice.view.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Numbers of an axis are round, few and different. */
class TicksTest {
  @Test
  void numbersAreRoundAndTellThePlacesApart() {
    Ticks ticks = new Ticks(0, 3, 0, 9);

    assertThat(ticks.labels()).containsExactly("0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0");
    assertThat(ticks.title("t", "s")).isEqualTo("t (s)");
    assertThat(ticks.part(1.5)).isEqualTo(0.5);
  }

  @Test
  void negativeNumbersHaveAMinusSign() {
    assertThat(new Ticks(-2, 2, 0, 5).labels()).containsExactly("−2", "−1", "0", "1", "2");
  }

  @Test
  void smallAndLargeNumbersAreMultiplesOfAPowerOfTen() {
    assertThat(new Ticks(0, 4e-7, 0, 5).title("q", "m")).isEqualTo("q (10⁻⁹ m)");
    assertThat(new Ticks(0, 4e-7, 0, 5).labels()).contains("100", "400");
    assertThat(new Ticks(-3e9, 0, 0, 5).title("F", "N")).isEqualTo("F (10⁹ N)");
    assertThat(new Ticks(0, 2e12, 0, 5).title("", "")).isEqualTo("10¹²");
  }

  @Test
  void latestDigitsAreWrittenAsADifference() {
    Ticks ticks = new Ticks(1000, 1000.00004, 0, 4);

    assertThat(ticks.title("x", "m")).startsWith("x − 1000").endsWith("(10⁻⁵ m)");
    assertThat(ticks.labels()).doesNotHaveDuplicates().allMatch(label -> label.length() < 3);
  }

  @Test
  void constantHasRoomAround() {
    for (double constant : new double[] {0, 5, -1e-9, 1e200}) {
      Ticks ticks = new Ticks(constant, constant, 0.05, 5);
      assertThat(ticks.part(constant)).isBetween(0.3, 0.7);
      assertThat(ticks.labels()).doesNotHaveDuplicates().hasSizeBetween(2, 9);
    }
  }

  @Test
  void anyRangeOfNumbersHasAFewDifferentLabels() {
    for (double[] range :
        List.of(
            new double[] {-1.7e308, 1.7e308},
            new double[] {1e-320, 3e-320},
            new double[] {1, 1 + 1e-15},
            new double[] {-1e5, 1e5},
            new double[] {0.00099, 0.001},
            new double[] {99999, 100001},
            new double[] {-7, 1e6})) {
      Ticks ticks = new Ticks(range[0], range[1], 0.05, 6);
      assertThat(ticks.labels())
          .as(range[0] + " to " + range[1])
          .doesNotHaveDuplicates()
          .hasSizeBetween(2, 12)
          .allMatch(label -> label.length() < 10);
      assertThat(ticks.parts()).allMatch(part -> part > -1e-6 && part < 1 + 1e-6);
    }
  }
}
