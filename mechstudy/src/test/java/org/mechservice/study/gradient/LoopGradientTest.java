package org.mechservice.study.gradient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.library.MechModel;
import org.mechservice.study.Reduction;

/** Derivatives of mechanisms with loops. */
final class LoopGradientTest {
  private static final double RACK = -0.1;

  /** Step of the differences of whole runs, m: their error is h² and 1e-10 / h. */
  private static final double H = 1e-4;

  private static double toe(MechModel model, double rack) throws Exception {
    return Gradients.of(model.set("rack", rack), List.of("k"), List.of(Reduction.parse("toe")))
        .compute(GradientMethod.FORWARD)
        .values()[0];
  }

  /** Geometry, forces and assembly of a five-point suspension, both ways and by whole runs. */
  @Test
  void toeOfASuspensionChangesAsRunsBesideItSay() throws Exception {
    Path file = Path.of("..", "examples", "optimise", "suspension.xml");
    MechModel model = MechModel.read(file).until(0.4);
    Gradients gradients =
        Gradients.of(model, List.of("rack", "k", "c"), List.of(Reduction.parse("toe")));
    Gradient forward = gradients.compute(GradientMethod.FORWARD);
    Gradient adjoint = gradients.compute(GradientMethod.ADJOINT);
    double[] slopes = forward.derivatives()[0];
    for (int k = 0; k < slopes.length; k++) {
      assertThat(adjoint.derivatives()[0][k])
          .isCloseTo(slopes[k], within(1e-6 * Math.abs(slopes[k])));
    }
    double difference = (toe(model, RACK + H) - toe(model, RACK - H)) / (2 * H);
    assertThat(slopes[0]).isCloseTo(difference, within(1e-5 * Math.abs(difference)));
    assertThat(forward.differenced()).containsExactly("rack");
  }
}
