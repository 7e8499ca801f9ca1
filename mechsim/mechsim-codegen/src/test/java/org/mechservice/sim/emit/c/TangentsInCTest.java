package org.mechservice.sim.emit.c;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.gradient.ModelFunctions;
import org.mechservice.sim.gradient.VariationalEquations;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlForces;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Derivatives of x' in C: of open chains they are the bits of the tangents on the Java machine, and
 * all are those that differences of x' show, by states, parameters and inputs.
 */
@Tag("slow")
class TangentsInCTest {
  private static final int FEW = 3;
  private static final int MANY = 100;

  /**
   * Reads t and x; writes the result of the Jacobian, it, how many of its numbers are not those of
   * the directional derivatives, and the largest difference of these from central differences,
   * relative to the largest element of a column, or 1; the same along dx/dt, which does not leave
   * the loops.
   */
  private static final String DRIVER =
      """
      #include "MODEL.h"
      #include <math.h>
      #include <stdio.h>
      #include <string.h>

      enum { N = MODEL_NX + MODEL_NP + MODEL_NU };

      static double *known(MODEL_t *m, double *x, int k) {
        return k < MODEL_NX ? x + k
               : k < MODEL_NX + MODEL_NP ? m->p + (k - MODEL_NX)
                                         : m->u + (k - MODEL_NX - MODEL_NP);
      }

      int main(void) {
        static MODEL_t m;
        static double given[MODEL_NX + 1], jacobian[MODEL_NX * MODEL_NX + 1];
        static double column[MODEL_NX + 1], above[MODEL_NX + 1], below[MODEL_NX + 1], seed[N + 1];
        MODEL_init(&m);
        while (fread(given, sizeof(double), MODEL_NX + 1, stdin) == MODEL_NX + 1) {
          double *x = given + 1, result, others = 0, apart = 0;
          result = MODEL_jacobian(&m, given[0], x, jacobian);
          for (int k = 0; k < N; k++) {
            double *one = known(&m, x, k), value = *one, h = 1e-6 * (1 + fabs(value)), size = 1;
            memset(seed, 0, sizeof seed);
            seed[k] = 1;
            MODEL_directional(&m, given[0], x, seed, column);
            *one = value + h;
            MODEL_derivatives(&m, given[0], x, above);
            *one = value - h;
            MODEL_derivatives(&m, given[0], x, below);
            *one = value;
            for (int i = 0; i < MODEL_NX; i++) {
              others += k < MODEL_NX && column[i] != jacobian[i * MODEL_NX + k];
              size = fmax(size, fabs(column[i]));
            }
            for (int i = 0; i < MODEL_NX; i++) {
              double error = fabs(column[i] - (above[i] - below[i]) / (2 * h)) / size;
              apart = error > apart || error != error ? error : apart;
            }
          }
          fwrite(&result, sizeof(double), 1, stdout);
          fwrite(jacobian, sizeof(double), MODEL_NX * MODEL_NX, stdout);
          fwrite(&others, sizeof(double), 1, stdout);
          fwrite(&apart, sizeof(double), 1, stdout);
          {
            double dx[MODEL_NX + 1], y[MODEL_NX + 1], largest = 1, h, size = 1;
            MODEL_derivatives(&m, given[0], x, dx);
            memset(seed, 0, sizeof seed);
            memcpy(seed, dx, MODEL_NX * sizeof(double));
            MODEL_directional(&m, given[0], x, seed, column);
            for (int i = 0; i < MODEL_NX; i++) {
              largest = fmax(largest, fabs(dx[i]));
              size = fmax(size, fabs(column[i]));
            }
            h = 1e-5 / largest;
            for (int i = 0; i < MODEL_NX; i++) {
              y[i] = x[i] + h * dx[i];
            }
            MODEL_derivatives(&m, given[0], y, above);
            for (int i = 0; i < MODEL_NX; i++) {
              y[i] = x[i] - h * dx[i];
            }
            MODEL_derivatives(&m, given[0], y, below);
            apart = 0;
            for (int i = 0; i < MODEL_NX; i++) {
              double error = fabs(column[i] - (above[i] - below[i]) / (2 * h)) / size;
              apart = error > apart || error != error ? error : apart;
            }
            fwrite(&apart, sizeof(double), 1, stdout);
          }
        }
        return 0;
      }
      """;

  @TempDir private Path folder = Path.of("");

  private Path compiled(CModel model, List<String> flags) throws IOException {
    Path place = Files.createTempDirectory(folder, "scene");
    return CCode.compiled(model, place, flags, DRIVER.replace("MODEL", model.name()));
  }

  private static BuildOptions options() {
    return new BuildOptions("DTR", EnumSet.of(ColumnGroup.JOINTS), Scenes.SETTINGS);
  }

  private void compareTree(int seed, int states, List<String> flags) throws IOException {
    Mechanism tree = RandomMechmlTrees.ofAllJoints(seed, 2 + seed % 5);
    compareTree(seed, RandomMechmlForces.on(tree, seed), states, flags);
  }

  private void compareTree(int seed, Mechanism tree, int states, List<String> flags)
      throws IOException {
    MechmlModel model = Scenes.model(tree);
    CModel inC = ModelFactory.inC(model, options());
    int n = inC.states().size();
    VariationalEquations java =
        new ModelFunctions(model, Scenes.SETTINGS, List.of(), new int[0]).equations();
    Random random = new Random(seed);
    double[] given = random.doubles((long) states * (n + 1), -2, 2).toArray();
    double[] written = CCode.run(compiled(inC, flags), List.of(), given);
    int row = n * n + 4;
    double[] out = new double[2 * n];
    int compared = 0;
    for (int s = 0; s < states; s++) {
      double[] x = Arrays.copyOfRange(given, s * (n + 1) + 1, (s + 1) * (n + 1));
      for (int k = 0; k < n; k++) {
        double[] direction = new double[n + 1];
        direction[k] = 1;
        int result = java.tangent(given[s * (n + 1)], x, direction, out);
        boolean regular = result == ExplicitModel.REGULAR;
        assertThat(written[s * row]).isEqualTo(regular ? 0.0 : -1.0);
        compared += regular ? 1 : 0;
        for (int i = 0; regular && i < n; i++) {
          assertThat(written[s * row + 1 + i * n + k])
              .as("seed %d, d x'[%d] / d x[%d]", seed, i, k)
              .isEqualTo(out[n + i]);
        }
      }
      assertThat(written[s * row + 1 + n * n]).isZero();
    }
    // A state where a mass matrix is singular is met by chance alone.
    assertThat(compared).isGreaterThanOrEqualTo(n * states * 9 / 10);
  }

  @Test
  void jacobianOfOpenChainsHasTheBitsOfJava() throws IOException {
    CCode.compiler();
    for (int seed = 1; seed <= FEW; seed++) {
      // Optimising takes nearly all of the time; in the long run all are.
      compareTree(seed, 10, seed == 1 ? CCode.FAST : CCode.PLAIN);
    }
  }

  /** Its code is of methods that links of a kind share. */
  @Test
  void jacobianOfALargeTreeHasTheBitsOfJava() throws IOException {
    CCode.compiler();
    compareTree(1, RandomMechmlTrees.tree(1, 104), 1, CCode.PLAIN);
  }

  @Tag("soak")
  @Test
  void jacobiansOfManyOpenChainsHaveTheBitsOfJava() throws IOException {
    CCode.compiler();
    for (int seed = 1; seed <= MANY; seed++) {
      compareTree(seed, 100, CCode.FAST);
    }
  }

  /**
   * Differences of 1e-6 err by 1e-10 of x', which is up to 1e5 times as large as its derivatives in
   * some column. Bennett's loop moves by its special lengths alone: beside its motion its equations
   * contradict each other, and there is no derivative to compare.
   */
  @ParameterizedTest
  @CsvSource({
    "elements/input, 1e-6",
    "elements/sampled, 1e-6",
    "pendulum/pendulum, 1e-6",
    "extremes/bennett, 1",
    "extremes/fourbar_redundant, 1e-6",
    "benchmarks/A03_andrews, 1e-5",
    "benchmarks/slider_crank_planar, 1e-6",
    "five-point-suspension/variants/elements, 1e-5"
  })
  void derivativesAreThoseOfDifferences(String scene, double tolerance) throws Exception {
    CCode.compiler();
    Path file = Path.of("..", "..", "examples").resolve(scene + ".xml");
    ReadOptions reading = ReadOptions.NONE.withInputsAsParameters();
    MechmlModel model = MechmlReader.read("scene.xml", Files.readAllBytes(file), reading);
    CModel inC = ModelFactory.inC(model, options());
    double[] given = new double[inC.states().size() + 1];
    given[0] = 0.1234;
    for (int i = 1; i < given.length; i++) {
      given[i] = inC.states().get(i - 1).start();
    }
    double[] written = CCode.run(compiled(inC, CCode.PLAIN), List.of(), given);
    assertThat(written[0]).isZero();
    assertThat(written[written.length - 3]).as("jacobian and directional").isZero();
    assertThat(written[written.length - 2]).isCloseTo(0, within(tolerance));
    assertThat(written[written.length - 1]).as("along the motion").isCloseTo(0, within(1e-6));
  }
}
