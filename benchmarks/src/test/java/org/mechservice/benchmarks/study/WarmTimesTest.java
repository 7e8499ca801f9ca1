package org.mechservice.benchmarks.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class WarmTimesTest {
  private static final WarmTimes TIMES = new WarmTimes(1, 0.3);

  private final List<String> order = new ArrayList<>();

  /** A run that costs five times as much until its method has worked for half a second. */
  private final class Compiled {
    private final String method;
    private double worked;

    Compiled(String method) {
      this.method = method;
    }

    WarmTimes.Run run(double warm) {
      return new WarmTimes.Run(
          method,
          () -> {
            double cost = worked < 0.5 ? 5 * warm : warm;
            worked += cost;
            order.add(method);
            return cost;
          });
    }
  }

  @Test
  void shortRunsAreTimedAsWarmAsLongOnes() {
    List<WarmTimes.Run> runs =
        List.of(new Compiled("short").run(0.001), new Compiled("long").run(0.1));
    TIMES.warm(runs);
    assertThat(TIMES.medians(runs, 3)).containsExactly(0.001, 0.1);
  }

  @Test
  void runsOfOneMethodWarmEachOther() {
    Compiled method = new Compiled("DTR");
    List<WarmTimes.Run> runs = List.of(method.run(0.01), method.run(0.1));
    TIMES.warm(runs);
    assertThat(method.worked).isBetween(1.0, 1.5);
  }

  @Test
  void methodsTakeTurns() {
    List<WarmTimes.Run> runs = List.of(new Compiled("a").run(0.01), new Compiled("b").run(0.01));
    TIMES.medians(runs, 3);
    assertThat(order).containsExactly("a", "b", "a", "b", "a", "b");
  }

  @Test
  void longRunsAreTimedOnce() {
    List<WarmTimes.Run> runs = List.of(new Compiled("a").run(0.4), new Compiled("b").run(0.01));
    TIMES.medians(runs, 3);
    assertThat(order).containsExactly("a", "b", "b", "b");
  }
}
