package org.mechservice.study.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.mechservice.library.MechModel;
import org.mechservice.study.PointModel;
import org.mechservice.study.Reduction;
import org.mechservice.study.gradient.RowGradients;

/** The height of the tie rod of the five-point suspension, examples/optimise/suspension.xml. */
class SuspensionOptimumTest {
  private static final Path FILE = Path.of("../examples/optimise/suspension.xml");
  private static final List<DesignVariable> RACK =
      List.of(new DesignVariable("rack", -0.2, 0, -0.1));

  private static Optimum found(Method method, boolean exact) throws Exception {
    DesignProblem problem =
        new ModelDesign(MechModel.read(FILE), RACK).minimise("rms(toe)").problem(exact);
    return Optimiser.minimise(
        problem, new OptimiserSettings(method, 1, 1, 100, 1e-4, OptionalDouble.empty(), 1));
  }

  /** Points of a mechanism with loops: geometry, forces and assembly are in the derivative. */
  @Test
  void optimumWithGradientIsThatWithout() throws Exception {
    Optimum exact = found(Method.SQP, true);
    Optimum without = found(Method.BOBYQA, false);

    // the objective is flat there: where it is known to 1e-9 of it, the height is known to 1e-7 m
    assertThat(exact.best().point()[0]).isCloseTo(-0.08317986, within(1e-7));
    assertThat(without.best().point()[0]).isCloseTo(exact.best().point()[0], within(1e-7));
    assertThat(exact.best().objective()).isCloseTo(2.838788e-4, within(1e-10));
    assertThat(without.best().objective()).isCloseTo(exact.best().objective(), within(1e-10));
    assertThat(exact.runs()).isLessThan(20);
  }

  @Test
  void rowsChangeByGeometryAsRunsBesideItSay() throws Exception {
    MechModel model = MechModel.read(FILE).until(0.4);
    List<Reduction> outputs =
        List.of(Reduction.parse("rms(toe)"), Reduction.parse("at(travel,0.305)"));
    RowGradients gradients = RowGradients.of(model, List.of("k", "rack"), outputs);
    PointModel points = PointModel.of(model, List.of("k", "rack"), outputs);
    double h = 1e-4;
    // the second point has equations of its own, the third those of the second
    for (double[] at : new double[][] {{20000, -0.1}, {20000, -0.09}, {25000, -0.09}}) {
      double[][] slopes = gradients.at(at);
      for (int j = 0; j < 2; j++) {
        double move = j == 0 ? h * at[0] : h;
        double[] up = run(points, at, j, move);
        double[] down = run(points, at, j, -move);
        for (int i = 0; i < 2; i++) {
          double difference = (up[i] - down[i]) / (2 * move);
          // error of the difference: (1e-4)² of the curvature, and 1e-9 of the values / 1e-4
          assertThat(slopes[i][j])
              .isCloseTo(difference, within(2e-5 * Math.abs(difference) + 1e-11 / move));
        }
      }
    }
  }

  private static double[] run(PointModel points, double[] at, int j, double move)
      throws PointFailedException {
    return ModelDesign.reduced(
        points, Map.of("k", at[0] + (j == 0 ? move : 0), "rack", at[1] + (j == 1 ? move : 0)));
  }

  @Test
  void rowsAtTimesThatDependOnAParameterHaveNoDerivativeByIt() throws Exception {
    String text =
        Files.readString(FILE)
            .replace("tstep=\"0.01\"", "tstep=\"dt\"")
            .replace("<Parameters>", "<Parameters><parameter name='dt' value='0.01' unit='s'/>");
    MechModel model = MechModel.of("timed", text);
    assertThatThrownBy(
            () -> RowGradients.of(model, List.of("dt"), List.of(Reduction.parse("rms(toe)"))))
        .hasMessageContaining("the times of the rows depend on dt");
  }
}
