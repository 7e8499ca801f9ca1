package org.mechservice.sim.equations;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.symbol.Program;

class ArticulatedBodyEquationsTest {
  /** The bound of docs/theory/formulations.md#agreement; the longest chain needs 1e-14. */
  private static final double AGREES = 1e-11;

  private static Program withJointForces(Mechanism mechanism) {
    int n = mechanism.velocityCount();
    return ArticulatedBodyEquations.derive(Links.of(mechanism), link -> 2 * n + link.joint());
  }

  @ParameterizedTest
  @ValueSource(strings = {"pend5", "pend5s", "driver41", "chain200"})
  void accelerationsOfTheTimingModelsEqualPinocchios(String name) {
    Scenes.TimingModel model = Scenes.timingModel(name);
    int n = model.accelerations().length;
    double[] yDot = new double[2 * n];
    assertThat(withJointForces(model.mechanism()).evaluate(model.input(), yDot)).isEqualTo(-1);
    double worst = 0;
    double largest = 0;
    for (int i = 0; i < n; i++) {
      worst = Math.max(worst, Math.abs(yDot[n + i] - model.accelerations()[i]));
      largest = Math.max(largest, Math.abs(model.accelerations()[i]));
    }
    assertThat(worst).isLessThan(AGREES * largest);
  }

  /**
   * Counts of the first prototype; a rise above them means that something structural was lost. The
   * prototype had 840 of pend5s: it merged constants of two operations, which stay apart.
   */
  @ParameterizedTest
  @CsvSource({"pend5, 259", "pend5s, 842", "driver41, 6790", "chain200, 56341"})
  void noMoreOperationsThanThePrototype(String name, int prototype) {
    assertThat(withJointForces(Scenes.timingModel(name).mechanism()).operationCount())
        .isLessThanOrEqualTo(prototype);
  }

  @Test
  void aPlanarModelCollapsesToPlanarAlgebra() {
    Links links = Links.of(Scenes.timingModel("pend5").mechanism());
    assertThat(links.links()).noneMatch(Link::hasConstantTurn);
  }

  @Test
  void everyJointTurnsAboutZOfItsComputingFrame() {
    for (Link link : Links.of(Scenes.pendulum()).links()) {
      assertThat(link.axes().isPermutation() || link.axes().turn().isPresent()).isTrue();
    }
  }

  @Test
  void onlyMasslessBodiesAreGuarded() {
    Program pendulum = ArticulatedBodyEquations.derive(Links.of(Scenes.pendulum()));
    assertThat(pendulum.sections()).allMatch(section -> section.guards().isEmpty());
    Mechanism driver = Scenes.timingModel("driver41").mechanism();
    long guards =
        ArticulatedBodyEquations.derive(Links.of(driver)).sections().stream()
            .mapToLong(section -> section.guards().size())
            .sum();
    assertThat(guards).isEqualTo(20);
  }

  @Test
  void theSameMechanismGivesTheSameProgram() {
    Mechanism mechanism = Scenes.timingModel("driver41").mechanism();
    Program first = ArticulatedBodyEquations.derive(Links.of(mechanism));
    Program second = ArticulatedBodyEquations.derive(Links.of(mechanism));
    assertThat(second.uses()).isEqualTo(first.uses());
    assertThat(second.expressions().size()).isEqualTo(first.expressions().size());
  }
}
