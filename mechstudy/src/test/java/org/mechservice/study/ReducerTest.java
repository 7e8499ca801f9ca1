package org.mechservice.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.result.Variable;

/** Reductions of rows against the closed values of straight lines. */
class ReducerTest {
  /** x falls from 2 to -4, then rises to 0, at unequal distances. */
  private static final double[][] ROWS = {{1, 2}, {2, -1}, {3, -4}, {5, 0}};

  private static double[] reduced(String... reductions) {
    Reducer reducer = new Reducer(Stream.of(reductions).map(Reduction::parse).toList());
    reducer.begin(List.of(new Variable("t", "s"), new Variable("a,b (c)", "m")));
    for (double[] row : ROWS) {
      reducer.row(row.clone());
    }
    return reducer.values();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "last(a,b (c)); 0",
        "a,b (c); 0",
        "at(a,b (c), 2); -1",
        "at(a,b (c), 4); -2",
        "at(a,b (c), 1); 2",
        "min(a,b (c)); -4",
        "max(a,b (c)); 2",
        "integral(a,b (c)); -6",
        "mean(a,b (c)); -1.5",
        // squares of the straight lines: 1, 7, 32/3
        "rms(a,b (c)); 2.160246899469287",
        "crossing(a,b (c), 0); 1.6666666666666667",
        "crossing(a,b (c), -4); 3",
        "crossing(a,b (c), 3); NaN",
      })
  void valueIsThatOfTheStraightLinesThroughTheRows(String reduction, double expected) {
    assertThat(reduced(reduction)[0]).isCloseTo(expected, within(1e-15));
  }

  @Test
  void runAfterAnotherStartsAfresh() {
    Reducer reducer = new Reducer(List.of(Reduction.parse("max(x)"), Reduction.parse("mean(x)")));
    List<Variable> columns = List.of(new Variable("t", "s"), new Variable("x", "m"));
    reducer.begin(columns);
    reducer.row(new double[] {0, 100});
    reducer.row(new double[] {1, 100});
    reducer.begin(columns);
    reducer.row(new double[] {0, 1});

    assertThat(reducer.values()).containsExactly(1, 1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"last(x)", "at(x,2.5)", "crossing(x,0)", "series(x)", "series(x,0.1)"})
  void textualFormReadsBack(String text) {
    assertThat(Reduction.parse(text)).hasToString(text);
    assertThat(Reduction.parse(Reduction.parse(text).toString())).isEqualTo(Reduction.parse(text));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "maxx(x); did you mean",
        "at(x); lacks the time",
        "at(x,soon); is no number",
        "max(); names no column",
        "series(x,0); above 0"
      })
  void otherTextIsRefusedWithWhatToWrite(String text, String why) {
    assertThatThrownBy(() -> Reduction.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(why);
  }
}
