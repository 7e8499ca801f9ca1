package org.mechservice.sim.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Loads are means over seconds, not what the last microseconds happened to be. */
class MachineLoadTest {
  private static final long SECOND = 1_000_000_000L;

  private long now;

  /** A machine of four processors, of which this process uses one and others two. */
  private final class Busy implements MachineLoad.Source {
    private long askedAt = now;

    @Override
    public double machineSinceLastAsked() {
      // Over less than a tick of 10 ms the system counts nothing or everything.
      double load = now - askedAt < SECOND / 100 ? now / 7 % 2 : 0.75;
      askedAt = now;
      return load;
    }

    @Override
    public long processNanos() {
      return now;
    }
  }

  private MachineLoad load(MachineLoad.Source source) {
    return new MachineLoad(source, () -> now, 4);
  }

  @Test
  void hostsOfOneMachineAgreeHoweverOftenTheyAreAsked() {
    MachineLoad often = load(new Busy());
    MachineLoad seldom = load(new Busy());
    List<Double> seen = new ArrayList<>();
    for (int i = 0; i < 100_000; i++) {
      now += SECOND / 1000;
      double machine = often.now().machine();
      if (now > 2 * SECOND) {
        seen.add(machine);
      }
    }
    assertThat(seen).containsOnly(0.75);
    assertThat(seldom.now().machine()).isEqualTo(0.75);
    assertThat(often.now().process()).isCloseTo(0.25, within(1e-12));
  }

  @Test
  void loadThatTheSystemDoesNotKnowIsThatOfTheProcess() {
    MachineLoad load =
        load(
            new MachineLoad.Source() {
              @Override
              public double machineSinceLastAsked() {
                return -1;
              }

              @Override
              public long processNanos() {
                return 2 * now;
              }
            });
    now += 3 * SECOND;
    assertThat(load.now()).isEqualTo(new MachineLoad.Sample(0.5, 0.5));
  }

  @Test
  void sharesAreBetweenNoneAndAll() {
    MachineLoad load =
        load(
            new MachineLoad.Source() {
              @Override
              public double machineSinceLastAsked() {
                return 1.2;
              }

              @Override
              public long processNanos() {
                return 9 * now;
              }
            });
    now += 3 * SECOND;
    assertThat(load.now()).isEqualTo(new MachineLoad.Sample(1, 1));
  }
}
