package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.ErrorWeightGroups;
import org.mechservice.solver.ode.JacobianSystem;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.UnitNormGroups;

/** What is known of a problem is given part by part and stays when the problem is wrapped. */
class ProblemPartsTest {
  private static final int N = 60;

  /** Diffusion along a rod with a reaction, y_i' = 100 (y_{i−1} − 2 y_i + y_{i+1}) − y_i². */
  private static final OdeFunction ROD =
      (t, y, yDot) -> {
        for (int i = 0; i < y.length; i++) {
          double left = i == 0 ? 0 : y[i - 1];
          double right = i == y.length - 1 ? 0 : y[i + 1];
          yDot[i] = 100 * (left - 2 * y[i] + right) - y[i] * y[i];
        }
      };

  private static final OdeProblem.Jacobian BAND =
      (t, y, fy) -> {
        for (int i = 0; i < y.length; i++) {
          fy[3 * i] = 100;
          fy[3 * i + 1] = -200 - 2 * y[i];
          fy[3 * i + 2] = 100;
        }
      };

  private static final OdeProblem.JacobianProduct PRODUCT =
      (t, y, v, product) -> {
        for (int i = 0; i < y.length; i++) {
          double left = i == 0 ? 0 : v[i - 1];
          double right = i == y.length - 1 ? 0 : v[i + 1];
          product[i] = 100 * left + (-200 - 2 * y[i]) * v[i] + 100 * right;
        }
      };

  private static final OdeOptions STIFF = OdeOptions.standard().method(OdeMethod.ODE15S);

  private static double[] ones() {
    double[] y = new double[N];
    Arrays.fill(y, 1);
    return y;
  }

  private static OdeSolution solve(OdeSystem rod) {
    return Ode.solve(rod, 0, ones(), 1, STIFF);
  }

  private static void assertSame(OdeSolution one, OdeSolution other) {
    assertThat(other.endState()).isEqualTo(one.endState());
    assertThat(other.statistics()).isEqualTo(one.statistics());
  }

  @Test
  void bandSavesEvaluationsAndStaysWhenTheFunctionIsWrapped() {
    AtomicLong count = new AtomicLong();
    OdeProblem banded = Ode.system(N, ROD).withBand(1, 1);
    OdeProblem counted =
        banded.withFunction(
            f ->
                (t, y, yDot) -> {
                  count.incrementAndGet();
                  f.evaluate(t, y, yDot);
                });
    OdeSolution plain = solve(banded);
    OdeSolution wrapped = solve(counted);
    OdeSolution full = solve(Ode.system(N, ROD));
    assertSame(plain, wrapped);
    assertThat(count.get()).isEqualTo(plain.statistics().evaluations());
    assertThat(plain.statistics().evaluations()).isLessThan(full.statistics().evaluations());
    assertThat(plain.endState()[30]).isCloseTo(full.endState()[30], within(1e-7));
  }

  /** Six pieces of ten components of a rod that are cut off from each other. */
  @Test
  void blocksSaveEvaluationsAndChangeNothingButRounding() {
    int size = N / 6;
    OdeFunction pieces =
        (t, y, yDot) -> {
          for (int i = 0; i < N; i++) {
            double left = i % size == 0 ? 0 : y[i - 1];
            double right = i % size == size - 1 ? 0 : y[i + 1];
            yDot[i] = 100 * (left - 2 * y[i] + right) - (1 + i / size) * y[i] * y[i];
          }
        };
    OdeProblem.Jacobian known =
        (t, y, fy) -> {
          for (int i = 0; i < N; i++) {
            int diagonal = i * size + i % size;
            fy[diagonal] = -200 - 2 * (1 + i / size) * y[i];
            if (i % size > 0) {
              fy[diagonal - 1] = 100;
            }
            if (i % size < size - 1) {
              fy[diagonal + 1] = 100;
            }
          }
        };
    OdeProblem blocks = Ode.system(N, pieces).withBlocks(size);
    OdeSolution full = solve(Ode.system(N, pieces));
    OdeSolution differences = solve(blocks);
    OdeSolution analytic = solve(blocks.withJacobian(known));
    assertThat(differences.statistics().steps()).isEqualTo(full.statistics().steps());
    assertThat(differences.statistics().evaluations() + 40)
        .isLessThan(full.statistics().evaluations());
    assertThat(analytic.statistics().evaluations())
        .isLessThan(differences.statistics().evaluations());
    assertThat(differences.endState()).containsExactly(full.endState(), within(1e-12));
    assertThat(analytic.endState()).containsExactly(full.endState(), within(1e-7));
  }

  @Test
  void systemOfAnotherClassKeepsItsPartsInsideAProblem() {
    OdeProblem inner = Ode.system(N, ROD).withBand(1, 1).withJacobian(BAND);
    OdeProblem outer = Ode.system((OdeSystem) inner).withBreakpoints(0.5);
    assertThat(outer.part(BandedSystem.class)).isPresent();
    assertThat(outer.part(JacobianSystem.class)).isPresent();
    assertThat(outer.part(SparseSystem.class)).isEmpty();
    assertThat(solve(outer).times()).contains(0.5);
  }

  @Test
  void analyticJacobianAndItsProductGiveTheSameBits() {
    OdeProblem banded = Ode.system(N, ROD).withBand(1, 1);
    OdeSolution analytic = solve(banded.withJacobian(BAND));
    OdeSolution product = solve(banded.withJacobianProduct(PRODUCT));
    OdeSolution differences = solve(banded);
    assertSame(analytic, product);
    assertThat(analytic.statistics().evaluations())
        .isLessThan(differences.statistics().evaluations());
  }

  @Test
  void productIsAskedOncePerGroupOfColumns() {
    AtomicLong products = new AtomicLong();
    OdeProblem.JacobianProduct counted =
        (t, y, v, product) -> {
          products.incrementAndGet();
          PRODUCT.evaluate(t, y, v, product);
        };
    OdeProblem full = Ode.system(N, ROD).withJacobianProduct(counted);
    long jacobians = solve(full).statistics().jacobians();
    assertThat(products.get()).isEqualTo(N * jacobians);
    products.set(0);
    jacobians = solve(full.withPattern((i, j) -> Math.abs(i - j) <= 1)).statistics().jacobians();
    assertThat(products.get()).isEqualTo(3 * jacobians);
    products.set(0);
    jacobians = solve(full.withBand(1, 1)).statistics().jacobians();
    assertThat(products.get()).isEqualTo(3 * jacobians);
  }

  @Test
  void laterJacobianReplacesTheEarlierOne() {
    OdeProblem banded = Ode.system(N, ROD).withBand(1, 1);
    OdeProblem.JacobianProduct wrong = (t, y, v, product) -> Arrays.fill(product, Double.NaN);
    OdeSolution right = solve(banded.withJacobian(BAND));
    assertSame(right, solve(banded.withJacobianProduct(wrong).withJacobian(BAND)));
    assertSame(
        right,
        solve(
            banded
                .withJacobian((t, y, fy) -> Arrays.fill(fy, Double.NaN))
                .withJacobianProduct(PRODUCT)));
  }

  @Test
  void patternSavesEvaluations() {
    OdeProblem ring =
        Ode.system(
            N,
            (t, y, yDot) -> {
              for (int i = 0; i < N; i++) {
                yDot[i] = 100 * (y[(i + N - 1) % N] - 2 * y[i] + y[(i + 1) % N]) - y[i] * y[i];
              }
            });
    OdeProblem known = ring.withPattern((i, j) -> i == j || i == (j + 1) % N || j == (i + 1) % N);
    assertThat(solve(known).statistics().evaluations())
        .isLessThan(solve(ring).statistics().evaluations());
  }

  @ParameterizedTest
  @EnumSource
  void breakpointEndsAStepInEveryMethod(OdeMethod method) {
    OdeProblem force =
        Ode.system(1, (t, y, yDot) -> yDot[0] = t < 0.3 ? 1 : -1).withBreakpoints(0.3);
    OdeSolution solution =
        Ode.solve(force, 0, new double[] {0}, 1, OdeOptions.standard().method(method));
    assertThat(solution.times()).contains(0.3);
    assertThat(solution.endState()[0]).isCloseTo(-0.4, within(1e-12));
  }

  /** Two Euler parameters of a rotation about one axis, and a third component. */
  private static final UnitNormGroups PAIR =
      new UnitNormGroups() {
        @Override
        public int groupCount() {
          return 1;
        }

        @Override
        public int groupStart(int group) {
          return 0;
        }

        @Override
        public int groupSize(int group) {
          return 2;
        }
      };

  @Test
  void groupOfNormOneAlsoSharesItsErrorWeight() {
    OdeProblem rotation =
        Ode.system(
                2,
                (t, y, yDot) -> {
                  yDot[0] = y[1];
                  yDot[1] = -y[0];
                })
            .with(UnitNormGroups.class, PAIR);
    assertThat(rotation.part(ErrorWeightGroups.class)).containsSame(PAIR);
    double[] end = Ode.solve(rotation, 0, new double[] {1, 0}, 1000).endState();
    assertThat(Math.hypot(end[0], end[1])).isCloseTo(1, within(1e-6));
  }

  @Test
  void partThatNoIntegratorAsksForIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.system(3, ROD).with(String.class, "band"))
        .withMessageContaining("kind String")
        .withMessageContaining("BandedSystem")
        .withMessageContaining("JacobianSystem");
    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> Dae.system(3, (t, y, yDot, r) -> {}).with(OdeSystem.class, Ode.system(3, ROD)))
        .withMessageContaining("kind OdeSystem")
        .withMessageContaining("ResidualJacobianSystem");
  }

  @Test
  void oneProblemIsSolvedByManyThreads() {
    OdeProblem shared = Ode.system(N, ROD).withBand(1, 1).withJacobianProduct(PRODUCT);
    MassProblem heavy =
        Ode.system(2, (t, y, yDot) -> yDot[0] = yDot[1] = -y[0] - y[1])
            .withMass(MassMatrix.full(new double[][] {{2, 1}, {1, 3}}));
    double[] one = solve(shared).endState();
    double[] other = Ode.solve(heavy, 0, new double[] {1, 2}, 1).endState();
    IntStream.range(0, 16)
        .parallel()
        .forEach(
            i -> {
              assertThat(solve(shared).endState()).isEqualTo(one);
              assertThat(Ode.solve(heavy, 0, new double[] {1, 2}, 1).endState()).isEqualTo(other);
            });
  }

  @Test
  void bandWiderThanTheMatrixIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.system(3, ROD).withBand(3, 0))
        .withMessageContaining("diagonals below the main one is 3")
        .withMessageContaining("from 0 to 2");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Ode.system(-1, ROD))
        .withMessageContaining("number of unknowns is -1");
  }
}
