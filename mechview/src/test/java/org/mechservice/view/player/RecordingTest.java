package org.mechservice.view.player;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.mechservice.view.scene.SceneDescription;

/** A recording keeps what a picture needs of a run, however long it is. */
class RecordingTest {
  @Test
  void shortRunKeepsAllRows() {
    assertThat(Pendulums.recording("bar", 101, 0.0025).frameCount()).isEqualTo(101);
  }

  @Test
  void denseRunIsThinnedToAboutSixtyFramesPerSecond() {
    Recording recording = Pendulums.recording("bar", 100_001, 0.0005);

    assertThat(recording.frameCount()).isBetween(50 * 30, 50 * 60 + 2);
  }

  @Test
  void longRunIsBoundedAndKeepsFirstAndLastRow() {
    Recording recording = Pendulums.recording("bar", 1_000_001, 1);

    assertThat(recording.frameCount()).isBetween(100_000, 250_001);
    assertThat(recording.value(0, 0)).isEqualTo(0);
    assertThat(recording.value(recording.frameCount() - 1, 0)).isEqualTo(1e6);
    for (int frame = 1; frame < recording.frameCount(); frame++) {
      assertThat(recording.value(frame, 0)).isGreaterThan(recording.value(frame - 1, 0));
    }
  }

  @Test
  void missingPoseIsNamed() {
    SceneDescription scene = Pendulums.scene("bar", "");

    assertThat(Recording.missing(scene, Pendulums.columns("other"))).contains("bar.x");
    assertThat(Recording.missing(scene, Pendulums.columns("bar"))).isEmpty();
  }
}
