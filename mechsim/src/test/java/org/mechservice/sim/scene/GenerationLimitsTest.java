package org.mechservice.sim.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

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

  @Test
  void whatGrowsWithTheLengthOfAChainAloneIsGenerated() {
    assertThat(GenerationLimits.noFaster("DTR", 68_147)).isEmpty();
    assertThat(GenerationLimits.noFaster("RR", 68_147)).isEmpty();
  }
}
