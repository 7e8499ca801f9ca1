package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * What is said about broken robots, word for word: broken-urdf/NAME.urdf gives
 * broken-urdf/NAME.txt.
 */
class BrokenRobotTest {
  static Stream<String> robots() throws IOException {
    return text("broken-urdf")
        .lines()
        .filter(f -> f.endsWith(".urdf"))
        .map(f -> f.substring(0, f.length() - 5));
  }

  @ParameterizedTest
  @MethodSource("robots")
  void messagesAboutARobotAreThoseOfTheGoldenFile(String name) throws IOException {
    String messages = ofRobot(name).stream().map(d -> d + "\n").collect(Collectors.joining());
    assertThat(messages).isEqualTo(text("broken-urdf/" + name + ".txt"));
  }

  @Test
  void everyMessageAboutRobotsHasABrokenFile() throws IOException {
    Set<MessageCode> shown =
        robots()
            .flatMap(name -> ofRobot(name).stream())
            .map(Diagnostic::code)
            .collect(Collectors.toSet());
    assertThat(shown)
        .contains(
            MessageCode.NOT_A_ROBOT,
            MessageCode.ROBOT_MISSING,
            MessageCode.ROBOT_NUMBER,
            MessageCode.ROBOT_TREE,
            MessageCode.ROBOT_JOINT,
            MessageCode.ROBOT_LOST,
            MessageCode.ROBOT_LOST_CONTACT,
            MessageCode.ROBOT_LOST_PICTURE);
  }

  private static List<Diagnostic> ofRobot(String name) {
    try {
      byte[] content = bytes("broken-urdf/" + name + ".urdf");
      return RobotImport.of(name + ".urdf", content).losses();
    } catch (MechmlException e) {
      return e.diagnostics();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static byte[] bytes(String name) throws IOException {
    try (InputStream stream =
        Objects.requireNonNull(BrokenRobotTest.class.getResourceAsStream(name), name)) {
      return stream.readAllBytes();
    }
  }

  private static String text(String name) throws IOException {
    return new String(bytes(name), StandardCharsets.UTF_8);
  }
}
