package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.program.SteppedModel;
import org.mechservice.solver.api.result.ColumnGroup;

/** States that a program sets between two steps: held, closed, at once in all columns, refused. */
class SteppedStateTest {
  private static final Path FOUR_BAR = Path.of("../examples/four-bar/four-bar.xml");
  private static final Path LEVER = Path.of("../examples/pendulum/pendulum.xml");

  private static SteppedModel fourBar(String formulation, String integrator) throws Exception {
    return MechModel.read(FOUR_BAR)
        .formulation(formulation)
        .integrator(integrator)
        .tolerances(1e-9, 1e-11)
        .until(1)
        .stepped(0.01);
  }

  private static int component(SteppedModel run, String name) {
    // time is the first column, the state follows
    for (int i = 0; i < run.columns().size(); i++) {
      if (run.columns().get(i).name().equals(name)) {
        return i - 1;
      }
    }
    throw new AssertionError(name);
  }

  /** Distance of the rocker's end from joint D, which is cut, m. */
  private static double gap(SteppedModel run) {
    double crank = run.value("A.q");
    double coupler = crank + run.value("B.q");
    double rocker = coupler + run.value("C.q");
    double x = x(0, 0.1, crank) + x(0.3, 0.15, coupler) + x(-0.05, -0.25, rocker);
    double z = z(0, 0.1, crank) + z(0.3, 0.15, coupler) + z(-0.05, -0.25, rocker);
    return Math.hypot(x - 0.25, z);
  }

  private static double x(double alongX, double alongZ, double angle) {
    return alongX * Math.cos(angle) + alongZ * Math.sin(angle);
  }

  private static double z(double alongX, double alongZ, double angle) {
    return alongZ * Math.cos(angle) - alongX * Math.sin(angle);
  }

  @ParameterizedTest
  @CsvSource({
    "DSR, ode113, projection",
    "RR, ode15sR, projection",
    "RR-JF, ode15sR, projection",
    "DSR, ode113, penalty",
    "RR-JF, ode15sR, penalty"
  })
  void coordinateThatIsSetIsHeldAndTheOthersFollow(
      String formulation, String integrator, String closure) throws Exception {
    String text =
        Files.readString(FOUR_BAR)
            .replace(
                "</dynamic>",
                "<formulation name='%s' closure='%s'/></dynamic>".formatted(formulation, closure));
    for (String name : new String[] {"A.q", "B.q", "C.q"}) {
      SteppedModel run =
          MechModel.of("four-bar.xml", text)
              .integrator(integrator)
              .tolerances(1e-9, 1e-11)
              .until(1)
              .stepped(0.01);
      run.step();
      double[] state = run.state();
      int set = component(run, name);
      state[set] += 0.05;
      run.state(state);
      assertThat(run.state()[set]).as(name).isCloseTo(state[set], within(1e-9));
      assertThat(run.value(name)).isEqualTo(run.state()[set]);
      assertThat(gap(run)).isCloseTo(0, within(1e-10));
      // the velocities fit the positions: so do differences over a short step
      double before = run.value("C.q");
      double rate = run.value("C.v");
      run.step();
      assertThat(gap(run)).isCloseTo(0, within(1e-9));
      assertThat(run.value("C.q") - before)
          .isCloseTo(0.01 * (rate + run.value("C.v")) / 2, within(5e-4));
    }
  }

  @Test
  void velocityThatIsSetIsHeld() throws Exception {
    SteppedModel run = fourBar("DSR", "ode113");
    double[] state = run.state();
    state[component(run, "A.v")] = 3;
    run.state(state);
    assertThat(run.value("A.v")).isCloseTo(3, within(1e-12));
    double before = gap(run);
    double moved = run.value("C.q");
    double rate = run.value("C.v");
    assertThat(Math.abs(rate)).isGreaterThan(0.1);
    run.step();
    assertThat(gap(run)).isCloseTo(before, within(1e-9));
    assertThat(run.value("C.q") - moved)
        .isCloseTo(0.01 * (rate + run.value("C.v")) / 2, within(5e-4));
  }

  /** What cannot be is refused by name, and the run goes on as if nothing had been set. */
  @ParameterizedTest
  @ValueSource(strings = {"DSR", "RR-JF"})
  void stateThatDoesNotCloseIsRefused(String formulation) throws Exception {
    String integrator = formulation.equals("DSR") ? "ode113" : "ode15sR";
    SteppedModel run = fourBar(formulation, integrator);
    SteppedModel untouched = fourBar(formulation, integrator);
    run.step();
    untouched.step();
    double[] state = run.state();
    double[] other = state.clone();
    other[component(run, "A.q")] += 2.5;
    other[component(run, "C.q")] -= 2;
    assertThatThrownBy(() -> run.state(other))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("S-195")
        .hasMessageContaining("do not close with A.q, C.q as set")
        .hasMessageContaining("set fewer coordinates");
    assertThat(run.state()).isEqualTo(state);
    for (int i = 0; i < 5; i++) {
      run.step();
      untouched.step();
      assertThat(run.value("A.q")).isCloseTo(untouched.value("A.q"), within(1e-9));
    }
  }

  /** What a program gives a mechanism is work, once. */
  @Test
  void energyOfAStateThatIsSetIsWork() throws Exception {
    SteppedModel run =
        MechModel.read(LEVER)
            .columns(ColumnGroup.ENERGY)
            .tolerances(1e-10, 1e-12)
            .until(0.5)
            .stepped(0.01);
    double[] state = run.state();
    double first = run.value("energy.kinetic") + run.value("energy.potential");
    state[state.length - 1] += 3;
    run.state(state);
    double given = run.value("energy.kinetic") + run.value("energy.potential") - first;
    assertThat(given).isGreaterThan(0.01);
    assertThat(run.value("energy.work")).isCloseTo(given, within(1e-12));
    run.step();
    assertThat(run.value("energy.kinetic") + run.value("energy.potential"))
        .isCloseTo(first + run.value("energy.work"), within(1e-8));
  }

  @Test
  void eulerParametersAreTakenWithNormOne() throws Exception {
    SteppedModel run =
        MechModel.read(Path.of("../examples/elements/rotationFriction.xml")).stepped(0.1);
    double[] state = run.state();
    state[0] = 2;
    state[1] = 2;
    run.state(state);
    assertThat(run.state()[0]).isCloseTo(Math.sqrt(0.5), within(1e-15));
    assertThat(run.state()[1]).isCloseTo(Math.sqrt(0.5), within(1e-15));
    state[0] = 0;
    state[1] = 0;
    assertThatThrownBy(() -> run.state(state))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("all zero");
    assertThat(run.state()[0]).isCloseTo(Math.sqrt(0.5), within(1e-15));
  }

  @Test
  void runBeginsAgainWithTheSameBits() throws Exception {
    SteppedModel run = MechModel.read(LEVER).until(0.2).stepped(0.01);
    double[] first = run.row();
    while (run.isRunning()) {
      run.step();
    }
    double[] last = run.row();
    run.reset();
    assertThat(run.isRunning()).isTrue();
    assertThat(run.row()).isEqualTo(first);
    double[] state = run.state();
    state[0] += 0.3;
    run.state(state);
    assertThat(run.value(run.columns().get(1).name())).isEqualTo(state[0]);
    run.step();
    run.reset();
    while (run.isRunning()) {
      run.step();
    }
    assertThat(run.row()).isEqualTo(last);
  }

  /** A thousand million steps are no memory: as a list of times they were 24 GB. */
  @Test
  void memoryDoesNotDependOnTheEnd() throws Exception {
    SteppedModel run = MechModel.read(LEVER).until(1e6).stepped(0.001);
    run.step();
    assertThat(run.time()).isEqualTo(0.001);
  }

  @Test
  void stepIsInterruptedFromAnotherThread() throws Exception {
    SteppedModel run = MechModel.read(LEVER).until(1e9).stepped(1e8);
    run.interrupt();
    Thread stopping =
        new Thread(
            () -> {
              while (run.isRunning()) {
                run.interrupt();
                Thread.onSpinWait();
              }
            });
    stopping.start();
    run.step();
    stopping.join();
    assertThat(run.isRunning()).isFalse();
    assertThat(run.time()).isLessThan(1e8);
    assertThatThrownBy(run::step).isInstanceOf(IllegalStateException.class);
  }
}
