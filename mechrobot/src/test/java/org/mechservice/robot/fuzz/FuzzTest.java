package org.mechservice.robot.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.time.Duration;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A slice of what {@link FuzzPageTest} does for long: same machinery, few files. */
@Tag("slow")
class FuzzTest {
  /** Far beyond what it needs: it only ends a test that would hang. */
  private static final Duration PATIENCE = Duration.ofMinutes(5);

  private static final int FILES = 400;

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void damagedExamplesAreReadOrRefusedWithAMessage(long seed) throws IOException {
    FuzzCampaign campaign = new FuzzCampaign(seed);
    assertTimeoutPreemptively(PATIENCE, () -> campaign.damagedExamples(FILES));
    assertThat(campaign.examples().read()).isPositive();
    assertThat(campaign.examples().refused()).isPositive();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void filesDrawnFromTheGrammarAreReadOrRefusedWithAMessage(long seed) throws IOException {
    FuzzCampaign campaign = new FuzzCampaign(seed);
    assertTimeoutPreemptively(PATIENCE, () -> campaign.drawnFiles(FILES));
    assertThat(campaign.drawn().read()).isPositive();
    assertThat(campaign.drawn().refused()).isPositive();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void damagedRobotsAreReadOrRefusedWithAMessage(long seed) throws IOException {
    FuzzCampaign campaign = new FuzzCampaign(seed);
    assertTimeoutPreemptively(PATIENCE, () -> campaign.damagedRobots(FILES));
    assertThat(campaign.robots().read()).isPositive();
    assertThat(campaign.robots().refused()).isPositive();
  }
}
