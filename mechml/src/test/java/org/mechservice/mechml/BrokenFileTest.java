package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.catalogue.MessageCode;

/** What is said about broken files, word for word: broken/NAME.xml gives broken/NAME.txt. */
class BrokenFileTest {
  /** What is said of robots; the tests of the module mechrobot have them. */
  private static final Set<MessageCode> SAID_OF_ROBOTS =
      Set.of(
          MessageCode.NOT_A_ROBOT,
          MessageCode.ROBOT_MISSING,
          MessageCode.ROBOT_NUMBER,
          MessageCode.ROBOT_TREE,
          MessageCode.ROBOT_JOINT,
          MessageCode.ROBOT_LOST,
          MessageCode.ROBOT_LOST_CONTACT,
          MessageCode.ROBOT_LOST_PICTURE,
          MessageCode.ROBOT_FILE,
          MessageCode.ROBOT_ROOT,
          MessageCode.URDF_CANNOT,
          MessageCode.URDF_LOST);

  /** Files that are broken by what is asked of them. */
  private static final Map<String, ReadOptions> ASKED =
      Map.of(
          "asked-for-another-simulation", ReadOptions.choosing("modes"),
          "asked-to-set-what-is-not-there", ReadOptions.setting(Map.of("lenght", "1")),
          "asked-to-set-no-number", ReadOptions.setting(Map.of("length", "1+")),
          "asked-to-set-too-much", ReadOptions.setting(Map.of("length", "1e308")));

  static Stream<String> names() throws IOException {
    return Resources.text("broken")
        .lines()
        .filter(f -> f.endsWith(".xml"))
        .map(f -> f.substring(0, f.length() - 4));
  }

  @ParameterizedTest
  @MethodSource("names")
  void messagesAreThoseOfTheGoldenFile(String name) throws IOException {
    String messages = diagnostics(name).stream().map(d -> d + "\n").collect(Collectors.joining());
    assertThat(messages).isEqualTo(Resources.text("broken/" + name + ".txt"));
  }

  @Test
  void everyMessageOfTheCatalogueHasABrokenFile() throws IOException {
    Set<MessageCode> shown =
        names()
            .flatMap(name -> diagnostics(name).stream())
            .map(Diagnostic::code)
            .collect(Collectors.toSet());
    assertThat(shown)
        .containsExactlyInAnyOrderElementsOf(
            Arrays.stream(MessageCode.values())
                .filter(message -> message.code().startsWith("M-"))
                .filter(message -> !SAID_OF_ROBOTS.contains(message))
                .toList());
  }

  @Test
  void everyErrorOfAReadableFileNamesItsElement() throws IOException {
    assertThat(
            names()
                .filter(name -> !ASKED.containsKey(name))
                .flatMap(name -> diagnostics(name).stream()))
        .filteredOn(
            d ->
                d.code().compareTo(MessageCode.UNKNOWN_NAME) >= 0
                    && d.code() != MessageCode.MORE_MESSAGES)
        .allMatch(d -> d.line() > 0 && d.column() > 0 && d.path().matches("(MechML|subsystem)/.*"));
  }

  private static List<Diagnostic> diagnostics(String name) {
    try {
      return MechmlReader.read(
              name + ".xml",
              Resources.bytes("broken/" + name + ".xml"),
              ASKED.getOrDefault(name, ReadOptions.NONE))
          .warnings();
    } catch (MechmlException e) {
      return e.diagnostics();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
