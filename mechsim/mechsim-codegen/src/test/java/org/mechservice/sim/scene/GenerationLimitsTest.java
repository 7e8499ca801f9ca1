package org.mechservice.sim.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.mechanism.Mechanism;

class GenerationLimitsTest {
  /** 30 links on Hooke joints and balls: the method that calls all others had 10 173 bytes. */
  @Test
  void jacobianTooLongForAClassFileIsLeftToTheDataDrivenForm() {
    assertThat(GenerationLimits.tooLong(380_512))
        .containsExactly("a Jacobian of more than 200000 operations (it has 380512)");
    assertThat(GenerationLimits.tooLong(60_116)).isEmpty();
  }

  @Test
  void compositeInertiasThatDataEvaluateAsFastAreLeftToThem() {
    assertThat(GenerationLimits.noFaster("DSR", 41_439))
        .containsExactly(
            "DSR of more than 30000 operations (it has 41439), which data evaluate as fast");
    assertThat(GenerationLimits.noFaster("DSR", 24_494)).isEmpty();
  }

  /** The sum of d (d + 2) for d = 0 .. 999; its equations would not fit into memory. */
  @Test
  void aChainWhoseFactorsAloneAreTooManyIsLeftToTheDataBeforeItIsDerived()
      throws IOException, MechmlException {
    Path file = Path.of("..", "..", "examples", "extremes", "chain_1000.xml");
    Mechanism chain = MechmlReader.read("chain_1000.xml", Files.readAllBytes(file)).mechanism();
    assertThat(
            GenerationLimits.notGenerated(
                chain, new FormulationChoice("DSR", "none", "asked for"), () -> 0))
        .containsExactly(
            "DSR of more than 30000 operations (its factors alone take 333832500), which data"
                + " evaluate as fast");
  }

  @Test
  void largeTreeIsLeftToThePrintedSteps() throws IOException, MechmlException {
    Path file = Path.of("..", "..", "examples", "extremes", "chain_1000.xml");
    Mechanism chain = MechmlReader.read("chain_1000.xml", Files.readAllBytes(file)).mechanism();
    FormulationChoice dtr = new FormulationChoice("DTR", "none", "asked for");
    assertThat(GenerationLimits.leftToData(chain, dtr, () -> 0))
        .containsExactly(
            "articulated bodies of more than 200 velocities (it has 1000), whose printed steps are"
                + " sooner done");
    assertThat(GenerationLimits.notGenerated(chain, dtr, () -> 0)).isEmpty();
  }

  @Test
  void whatGrowsWithTheLengthOfAChainAloneIsGenerated() {
    assertThat(GenerationLimits.noFaster("DTR", 68_147)).isEmpty();
    assertThat(GenerationLimits.noFaster("RR", 68_147)).isEmpty();
  }
}
