package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.stream.LongStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.oracle.GlobalFormulation;

/** Random closed mechanisms against the maximal coordinates of the oracle. */
class RandomLoopsTest {
  private int compared;

  @Test
  void accelerationsAreThoseOfMaximalCoordinates() {
    LongStream.rangeClosed(1, 60).forEach(this::compare);
    assertThat(compared).isGreaterThan(25);
  }

  @Test
  @Tag("soak")
  void accelerationsAreThoseOfMaximalCoordinatesForMany() {
    LongStream.rangeClosed(61, 1000).forEach(this::compare);
    System.out.println("random loops, seeds 61 to 1000: compared " + compared);
    assertThat(compared).isGreaterThan(400);
  }

  /** Leaves out what locks, starts in a singular position or does not close. */
  private void compare(long seed) {
    Mechanism mechanism = RandomLoops.of(seed, 2 + (int) (seed % 7), 1 + (int) (seed % 2));
    ClosedMechanism closed =
        new ClosedMechanism(mechanism, "DSR", SceneRun.settings(1, 0.1, "ode113", 1e-8));
    boolean usable =
        closed.isAssembled()
            && closed.freedom() > 0
            && closed.findings().stream()
                .noneMatch(finding -> finding.kind() == LoopFinding.Kind.SINGULAR_START);
    if (!usable) {
      return;
    }
    double[] y = closed.start();
    int nq = mechanism.positionCount();
    double[] v = Arrays.copyOfRange(y, nq, y.length);
    double[] expected = new GlobalFormulation(mechanism, List.of()).accelerations(0, y, v);
    double scale = 1 + Arrays.stream(expected).map(Math::abs).max().orElse(0);
    for (String formulation : List.of("DSR", "DSR penalty")) {
      LoopModel model =
          LoopModels.of(mechanism, formulation, SceneRun.settings(1, 0.1, "ode113", 1e-8));
      double[] yDot = new double[y.length];
      assertThat(model.derivative(0, y, yDot)).as("seed %s", seed).isEqualTo(ExplicitModel.REGULAR);
      double tolerance = Math.max(1e-11, 100 * Math.ulp(1.0) * condition(model, closed.rank()));
      for (int i = 0; i < expected.length; i++) {
        assertThat(yDot[nq + i])
            .as("seed %s, %s, a[%s]", seed, formulation, i)
            .isCloseTo(expected[i], within(tolerance * scale));
      }
      assertBodiesMoveAsJointsPush(seed, mechanism, model, y, yDot);
    }
    compared++;
  }

  /** Newton and Euler for every body, with the reactions of all joints, planes, lines and rods. */
  private static void assertBodiesMoveAsJointsPush(
      long seed, Mechanism mechanism, LoopModel model, double[] y, double[] yDot) {
    assertThat(model.react(0, y)).isEqualTo(ExplicitModel.REGULAR);
    Reactions reactions = model.reactions();
    int nq = mechanism.positionCount();
    double largest =
        Arrays.stream(reactions.onJoints).map(Math::abs).max().orElse(0)
            + Arrays.stream(reactions.multipliers).map(Math::abs).max().orElse(0);
    GlobalFormulation global =
        new GlobalFormulation(
            mechanism,
            List.of((t, pose, loads) -> ReactionsTest.apply(mechanism, reactions, pose, loads)));
    double[] v = Arrays.copyOfRange(y, nq, y.length);
    double[] a = Arrays.copyOfRange(yDot, nq, y.length);
    for (double missing : global.missing(0, y, v, a)) {
      assertThat(missing).as("seed %s", seed).isCloseTo(0, within(1e-9 * (1 + largest)));
    }
  }

  /**
   * Condition of the scaled mass matrix times the root of that of the scaled J Jᵀ (NUMERICS §5).
   */
  private static double condition(LoopModel model, int rank) {
    ClosedTree work = model.work;
    int n = work.nv;
    work.formMass();
    RealMatrix mass = new Array2DRowRealMatrix(n, n);
    RealMatrix rows = new Array2DRowRealMatrix(work.loops.count(), n);
    for (int i = 0; i < n; i++) {
      double perRoot = 1 / Math.sqrt(work.mass[i * n + i]);
      for (int j = 0; j < n; j++) {
        mass.setEntry(i, j, work.mass[i * n + j] * perRoot / Math.sqrt(work.mass[j * n + j]));
      }
      for (int row = 0; row < work.loops.count(); row++) {
        rows.setEntry(row, i, work.loops.jacobian[row * work.loops.width() + i] * perRoot);
      }
    }
    double ofMass = new SingularValueDecomposition(mass).getConditionNumber();
    if (rank == 0) {
      return ofMass;
    }
    double[] sigma = new SingularValueDecomposition(rows).getSingularValues();
    return ofMass * sigma[0] / sigma[rank - 1];
  }
}
