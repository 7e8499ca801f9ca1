package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.cli.service.ServerCommand;
import org.mechservice.cli.service.SimhostCommand;
import picocli.CommandLine;

/** What the release archive brings to run the service in production fits the program. */
class ReleaseFilesTest {
  private static final Path DIST = Path.of("../dist");
  private static final String START = "ExecStart=/opt/mechservice/bin/mech ";

  private static void assertUnderstood(List<String> words) {
    Object command = words.get(0).equals("server") ? new ServerCommand() : new SimhostCommand();
    String[] options = words.stream().skip(1).toArray(String[]::new);
    assertThat(new CommandLine(command).parseArgs(options).unmatched()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"mech-server.service", "mech-simhost.service"})
  void unitsAreThoseOfTheGuideAndNameOptionsThatThereAre(String unit) throws IOException {
    String text = Files.readString(DIST.resolve("conf").resolve(unit));
    assertThat(Files.readString(Path.of("../docs/service.md"))).contains(text);
    String command = text.lines().filter(line -> line.startsWith(START)).findFirst().orElseThrow();
    assertUnderstood(Arrays.asList(command.substring(START.length()).split(" ")));
  }

  @Test
  void clusterStartsCommandsWithOptionsThatThereAre() throws IOException {
    String manifest = Files.readString(DIST.resolve("kubernetes/mechservice.yaml"));
    List<List<String>> commands =
        Pattern.compile("args:\\n((?: +- \\S+\\n)+)")
            .matcher(manifest)
            .results()
            .map(ReleaseFilesTest::words)
            .toList();
    assertThat(commands).extracting(words -> words.get(0)).containsExactly("server", "simhost");
    commands.forEach(ReleaseFilesTest::assertUnderstood);
  }

  private static List<String> words(MatchResult arguments) {
    return arguments.group(1).lines().map(line -> line.strip().substring("- ".length())).toList();
  }

  @Test
  void imageIsOfThisVersion() throws IOException {
    String image = "mechservice:" + System.getProperty("project.version");
    assertThat(Files.readString(DIST.resolve("container/Containerfile"))).contains(image);
    assertThat(Files.readString(DIST.resolve("kubernetes/mechservice.yaml")))
        .contains("image: " + image);
  }
}
