package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.force.ForceOracle;
import org.mechservice.solver.force.RandomForces;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.oracle.OracleForce;

/** Random closed mechanisms against the maximal coordinates of the oracle. */
@Tag("slow")
class RandomLoopsTest {
  private int compared;

  @Test
  void accelerationsAndReactionsAreThoseOfMaximalCoordinates() {
    LongStream.rangeClosed(1, 60).forEach(this::compare);
    assertThat(compared).isGreaterThan(25);
  }

  /** Mechanisms of more velocities than matrices are dense for. */
  @Test
  void accelerationsAndReactionsOfLargeMechanismsAreThoseOfMaximalCoordinates() {
    LongStream.rangeClosed(1, 40)
        .mapToObj(seed -> RandomLoops.of(seed, 42, 2 + (int) (seed % 7)))
        .filter(mechanism -> mechanism.velocityCount() > LoopEquations.LARGE)
        .limit(12)
        .forEach(this::compare);
    assertThat(compared).isGreaterThan(3);
  }

  /** Forces between bodies of a mechanism with loops, written down a second time. */
  @ParameterizedTest
  @EnumSource(
      value = RandomForces.Kind.class,
      names = {
        "SPRING_BOTH",
        "SPRING_ABOVE",
        "SPRING_BELOW",
        "BUSHING_ENERGY",
        "BUSHING_LINEAR",
        "CONTACT_PLANE",
        "LAW"
      })
  void accelerationsAndReactionsUnderForcesAreThoseOfMaximalCoordinates(RandomForces.Kind kind) {
    LongStream.rangeClosed(1, 40)
        .mapToObj(seed -> new RandomForces(seed, LoopComparison.mechanism(seed)).with(kind))
        .forEach(mechanism -> compare(mechanism, ForceOracle.of(mechanism.forces())));
    assertThat(compared).isGreaterThan(15);
  }

  private void compare(long seed) {
    compare(LoopComparison.mechanism(seed));
  }

  private void compare(Mechanism mechanism) {
    compare(mechanism, List.of());
  }

  private void compare(Mechanism mechanism, List<OracleForce> forces) {
    String seed = mechanism.name();
    if (LoopComparison.leftOut(mechanism).isPresent()) {
      return;
    }
    LoopComparison comparison = LoopComparison.of(mechanism, forces);
    comparison
        .forward()
        .forEach(
            (formulation, error) ->
                assertThat(error)
                    .as("seed %s, %s", seed, formulation)
                    .isLessThan(comparison.forwardBound()));
    assertThat(comparison.missing()).as("seed %s", seed).isLessThan(LoopComparison.MISSING);
    compared++;
  }

  /** Among them loops of bodies that cannot move, and one equation more than independent ones. */
  @ParameterizedTest
  @ValueSource(longs = {2, 7, 42, 68, 72})
  void motionIsTheSameInEveryFormulation(long seed) {
    Mechanism mechanism = LoopComparison.mechanism(seed);
    double[] expected = atEnd(mechanism, "DSR", "ode113", 1e-10);
    for (String formulation : List.of("DSR penalty", "RR", "RR-JF", "RR-JF penalty")) {
      boolean residual = formulation.startsWith("RR");
      double tolerance = residual ? 1e-7 : 1e-9;
      double[] actual = atEnd(mechanism, formulation, residual ? "ode15sR" : "DE", tolerance);
      for (int i = 1; i <= mechanism.positionCount(); i++) {
        // a thousand tolerances, as for references
        assertThat(actual[i])
            .as("%s, position %s", formulation, i - 1)
            .isCloseTo(expected[i], within(1000 * tolerance * (1 + Math.abs(expected[i]))));
      }
    }
  }

  private static double[] atEnd(
      Mechanism mechanism, String formulation, String integrator, double tolerance) {
    SceneRun run =
        LoopModels.run(mechanism, formulation, SceneRun.settings(0.1, 0.1, integrator, tolerance));
    assertThat(run.report.outcome()).as(formulation).isEqualTo(new Outcome.Completed());
    return run.at(0.1);
  }
}
