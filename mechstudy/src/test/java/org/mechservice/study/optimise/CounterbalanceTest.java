package org.mechservice.study.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.library.MechModel;

/** The four-bar of the examples, whose counterweights are known. */
final class CounterbalanceTest {
  /**
   * Berkof and Lowen 1969: the coupler acts as 0.4 kg at each hinge. The moments are 0.3 * 0.05 +
   * 0.4 * 0.1 kg m about the crank's bearing and (0.6 / 2 + 0.4) times its length about the
   * rocker's; the weights are at 0.08 m and at 0.4 of the length.
   */
  @Test
  void counterweightsAreThoseOfTheory() throws Exception {
    Path file = Path.of("..", "examples", "counterbalance", "counterbalance.xml");
    DesignProblem problem =
        new ModelDesign(
                MechModel.read(file),
                List.of(
                    new DesignVariable("mc", 0.01, 5, 0.1), new DesignVariable("mr", 0.01, 5, 0.1)))
            .minimise("rms(mount.fx)^2 + rms(mount.fz)^2")
            .problem();
    Optimum optimum = Optimiser.minimise(problem, OptimiserSettings.DEFAULT.with(Method.SQP));
    assertThat(optimum.best().point())
        .containsExactly(new double[] {0.055 / 0.08, 0.7 / 0.4}, within(1e-5));
  }
}
