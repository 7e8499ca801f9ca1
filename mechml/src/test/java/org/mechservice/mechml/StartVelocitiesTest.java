package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.assembly.LoopFinding;

/** A four-bar whose start gives velocities to some of its hinges. */
class StartVelocitiesTest {
  private static final Path FOUR_BAR = Path.of("..", "examples", "four-bar", "four-bar.xml");

  private static ClosedStart start(String values) throws Exception {
    String text =
        Files.readString(FOUR_BAR)
            .replace(
                "<root name=\"ground\"/>",
                "<root name=\"ground\"/><relCoorVals>" + values + "</relCoorVals>");
    if (values.contains("driven")) {
      text = text.replaceAll("<jointForce[^>]*/>", "");
    }
    return MechmlReader.read("four-bar.xml", text.getBytes(StandardCharsets.UTF_8)).closedStart(0);
  }

  private static double velocity(ClosedStart start, int joint) {
    return start.state()[start.tree().mechanism().positionCount() + joint];
  }

  private static boolean isCorrected(ClosedStart start) {
    return start.findings().stream()
        .anyMatch(one -> one.kind() == LoopFinding.Kind.START_VELOCITY_CHANGED);
  }

  /**
   * The velocity of the crank is that of the file whether positions are given or not, the others
   * follow from it, and that is no fault of the file.
   */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "<jointVal name='A' velVals='10'/>",
        "<jointVal name='A' posVals='0' velVals='10'/>",
        "<jointVal name='A' posVals='0' velVals='10'/><jointVal name='B' posVals='0'/>"
            + "<jointVal name='C' posVals='0'/>",
      })
  void givenVelocityIsKeptAndTheOthersFollow(String values) throws Exception {
    ClosedStart start = start(values);
    assertThat(start.isAssembled()).isTrue();
    assertThat(isCorrected(start)).isFalse();
    assertThat(velocity(start, 0)).isEqualTo(10);
    // of the velocities of the two ends of the coupler: v_B = 10 (0.1; 0), and D at rest
    assertThat(velocity(start, 1)).isCloseTo(-250 / 27.0, within(1e-12));
    assertThat(velocity(start, 2)).isCloseTo(100 / 27.0, within(1e-12));
  }

  @Test
  void drivenCrankIsNoFaultOfTheFile() throws Exception {
    ClosedStart start = start("<jointVal name='A' driven='10*t'/>");
    assertThat(start.isAssembled()).isTrue();
    assertThat(isCorrected(start)).isFalse();
  }

  @Test
  void velocitiesThatContradictTheLoopAreCorrectedAndTold() throws Exception {
    ClosedStart start = start("<jointVal name='A' velVals='10'/><jointVal name='B' velVals='5'/>");
    assertThat(start.isAssembled()).isTrue();
    assertThat(isCorrected(start)).isTrue();
  }
}
