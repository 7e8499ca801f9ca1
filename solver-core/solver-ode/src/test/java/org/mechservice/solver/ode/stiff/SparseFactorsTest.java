package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.solve.MassMatrix;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;
import org.mechservice.solver.ode.solve.OdeProblem;
import org.mechservice.solver.ode.solve.OdeSolution;

/** A pattern that is given changes what a stiff problem costs, and not its solution. */
class SparseFactorsTest {
  private static final OdeOptions OPTIONS = OdeOptions.standard().rtol(1e-5).atol(1e-8);

  /** Heat that flows and is made in a square with cold edges, at m × m points. */
  private record Square(int m) implements OdeSystem {
    @Override
    public int dimension() {
      return m * m;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      double perArea = (m + 1.0) * (m + 1.0);
      for (int k = 0; k < m * m; k++) {
        double flow = -4 * y[k];
        flow += k >= m ? y[k - m] : 0;
        flow += k < m * m - m ? y[k + m] : 0;
        flow += k % m > 0 ? y[k - 1] : 0;
        flow += k % m < m - 1 ? y[k + 1] : 0;
        yDot[k] = perArea * flow + 10 * y[k] * (1 - y[k]);
      }
    }

    int[] neighbours(int k) {
      return IntStream.of(k - m, k - 1, k, k + 1, k + m)
          .filter(i -> i >= 0 && i < m * m)
          .filter(i -> i / m == k / m || i % m == k % m)
          .toArray();
    }

    double[] start() {
      return IntStream.range(0, m * m)
          .mapToDouble(k -> wave(1, k / m) * (wave(1, k % m) + 0.5 * wave(2, k % m)))
          .toArray();
    }

    private double wave(int halves, int at) {
      return StrictMath.sin(halves * Math.PI * (at + 1) / (m + 1));
    }

    OdeProblem problem() {
      return Ode.system(this);
    }

    OdeProblem sparse() {
      return problem().withPattern(SparseSystem.byColumns(this::neighbours));
    }
  }

  @Test
  void sparseFactorsGiveTheSolutionOfDenseOnes() {
    Square square = new Square(16);
    OdeOptions options = OPTIONS.method(OdeMethod.ODE15S);
    OdeSolution dense = Ode.solve(square.problem(), 0, square.start(), 0.2, options);
    OdeSolution sparse = Ode.solve(square.sparse(), 0, square.start(), 0.2, options);
    assertThat(sparse.endState()).containsExactly(dense.endState(), within(1e-6));
    assertThat(sparse.statistics().evaluations())
        .isLessThan(dense.statistics().evaluations() - 200);
  }

  @Test
  void probedPatternIsTheOneThatIsGiven() {
    Square square = new Square(12);
    OdeOptions options = OPTIONS.method(OdeMethod.ODE15S);
    OdeProblem probed = square.problem().withProbedPattern(0, square.start());
    OdeSolution given = Ode.solve(square.sparse(), 0, square.start(), 0.2, options);
    assertThat(Ode.solve(probed, 0, square.start(), 0.2, options).endState())
        .isEqualTo(given.endState());
  }

  @Test
  void residualFormSolvesTheSame() {
    Square square = new Square(16);
    double[] ones = new double[256];
    Arrays.fill(ones, 1);
    OdeSolution dense = Ode.solve(square.problem(), 0, square.start(), 0.2, OPTIONS);
    OdeSolution sparse =
        Ode.solve(
            square.sparse().withMass(MassMatrix.diagonal(ones)),
            0,
            square.start(),
            0.2,
            OPTIONS.method(OdeMethod.ODE15SR));
    assertThat(sparse.endState()).containsExactly(dense.endState(), within(1e-4));
  }

  @Test
  void evaluationsDoNotGrowWithTheNumberOfUnknowns() {
    Square small = new Square(12);
    Square large = new Square(60);
    OdeOptions options = OPTIONS.method(OdeMethod.ODE15S);
    long few = Ode.solve(small.sparse(), 0, small.start(), 0.2, options).statistics().evaluations();
    long many =
        Ode.solve(large.sparse(), 0, large.start(), 0.2, options).statistics().evaluations();
    assertThat(many).isLessThan(few + 40);
  }

  @Tag("soak")
  @Test
  void hundredThousandUnknownsInAPlaneAreSolved() {
    Square square = new Square(316);
    OdeSolution solution =
        Ode.solve(square.sparse(), 0, square.start(), 0.5, OPTIONS.keepSteps(false));
    assertThat(solution.end()).isEqualTo(0.5);
    assertThat(solution.statistics().evaluations()).isLessThan(400);
  }
}
