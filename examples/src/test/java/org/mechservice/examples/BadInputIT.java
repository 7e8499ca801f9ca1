package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Each input error causes one message with its position, and no file is left behind. */
class BadInputIT {
  private static final Pattern CODE = Pattern.compile("\\b[MNS]-\\d{3}\\b");

  @TempDir Path directory;
  private Terminal terminal;

  @BeforeEach
  void openTerminal() {
    terminal = new Terminal(directory);
  }

  /**
   * Each row makes the pendulum invalid: the text to replace (its last occurrence), and the
   * replacement.
   */
  @ParameterizedTest(name = "{0}")
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "not well-formed | <cog x=\"0.5\" y | <cog x=\"0.5 y",
        "unknown element | <mass value=\"1.0\"/> | <weight value=\"1.0\"/>",
        "unknown attribute | <mass value=\"1.0\"/> | <mass wert=\"1.0\"/>",
        "unknown joint type | type=\"R\" | type=\"Q\"",
        "unknown joint name | <jointVal name=\"j5\" | <jointVal name=\"j55\"",
        "unknown body name | <body1 name=\"bar4\" | <body1 name=\"bar44\"",
        "unknown point name | <body1 name=\"bar4\" point=\"p2\" | <body1 name=\"bar4\""
            + " point=\"p3\"",
        "unknown vector name | point=\"p2\" vector=\"u2\" | point=\"p2\" vector=\"u3\"",
        "vector of length zero | vx=\"0.0\" vy=\"-0.6\" vz=\"0.8\" | vx=\"0.0\" vy=\"0.0\""
            + " vz=\"0.0\"",
        "not a number | <mass value=\"1.0\"/> | <mass value=\"1,0\"/>",
        "division by zero | Izz=\"1.0/12.0\" | Izz=\"1.0/0.0\"",
        "Java in a value | <mass value=\"1.0\"/> | <mass value=\"System.exit(0)\"/>",
        "negative tolerance | relTol=\"1e-05\" | relTol=\"-1e-05\"",
        "end before start | tend=\"3\" | tend=\"-3\"",
      })
  void modelErrorIsToldWithFileLineAndColumn(String what, String part, String replacement)
      throws IOException {
    int line = writeSpoilt(part, replacement);

    Mechanic.Done run = inThisProcess("simulate bad.xml --out r.csv");

    assertOneMessage(run, 2);
    assertThat(run.err()).contains("bad.xml:" + line + ":").containsPattern("\\bM-\\d{3}\\b");
    assertOnlyFilesAre("bad.xml");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "simulate bad.xml --out r.csv",
        "check bad.xml",
        "build bad.xml -o p.jar",
        "build bad.xml -o p.jar --standalone"
      })
  void everyCommandThatReadsAModelRefusesABadOne(String command) throws IOException {
    int line = writeSpoilt("<body1 name=\"bar4\"", "<body1 name=\"bar44\"");

    Terminal.Ended run = terminal.mech(command.split(" "));

    assertOneMessage(run, 2);
    assertThat(run.stderr()).contains("bad.xml:" + line + ":").contains("bar44");
    assertOnlyFilesAre("bad.xml");
  }

  @ParameterizedTest
  @CsvSource({
    "simulate nowhere.xml, nowhere.xml",
    "simulate MODEL --rtoll 1e-5, --rtoll",
    "simulate MODEL --rtol -1, -1",
    "simulate MODEL --mode sideways, sideways",
    "simulate MODEL --integrator euler, euler",
    "simulate MODEL --t-step 0, 0",
    "simulate MODEL --out nodir/r.csv, nodir",
    "simulate MODEL --out r.xyz, r.xyz",
    "simulate MODEL --columns colours, colours",
    "simulate MODEL --server http://x/y --out r.csv, http://x/y",
    "build MODEL -o nodir/p.jar, nodir"
  })
  void usageErrorNamesWhatWasWrong(String command, String named) throws IOException {
    Mechanic.Done run = inThisProcess(command);

    assertOneMessage(run, 2);
    assertThat(run.err()).contains(named);
    assertOnlyFilesAre();
  }

  @ParameterizedTest
  @CsvSource({"simulate MODEL --rtol abc, abc", "simulte MODEL, simulte"})
  void usageErrorIsAllThatTheProcessSays(String command, String named) throws IOException {
    Terminal.Ended run =
        terminal.mech(command.replace("MODEL", WorkingTree.PENDULUM.toString()).split(" "));

    assertOneMessage(run, 2);
    assertThat(run.stderr()).contains(named);
    assertOnlyFilesAre();
  }

  /** Runs a command whose files are in the test's folder. */
  private Mechanic.Done inThisProcess(String command) {
    return Mechanic.mech(
        Stream.of(command.split(" "))
            .map(
                word ->
                    word.matches("[\\w/]+\\.\\w{3}") ? directory.resolve(word).toString() : word)
            .map(word -> word.equals("MODEL") ? WorkingTree.PENDULUM.toString() : word)
            .toArray(String[]::new));
  }

  @Test
  void unreachableServerIsNamed() throws IOException {
    String url = Service.url(Service.freePort());

    Terminal.Ended run = simulateOn(url);

    assertOneMessage(run, 3);
    assertThat(run.stderr()).contains(url.substring(url.indexOf('@') + 1, url.indexOf("/Mech")));
    assertOnlyFilesAre();
  }

  @Test
  void somethingElseThanAMechServerIsNamed() throws IOException {
    try (ServerSocket mute = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
      Terminal.Ended run = simulateOn(Service.url(mute.getLocalPort()));

      assertOneMessage(run, 3);
      assertThat(run.stderr()).contains("127.0.0.1:" + mute.getLocalPort());
    }
    assertOnlyFilesAre();
  }

  @Test
  void serverOnAPortInUseNamesThePort() throws IOException {
    try (ServerSocket other = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
      int port = other.getLocalPort();

      Terminal.Ended run = terminal.mech("server", "--port", Integer.toString(port));

      assertOneMessage(run, 3);
      assertThat(run.stderr()).contains(Integer.toString(port));
    }
  }

  @Test
  void hostOfAnUnreachableServerNamesTheServer() {
    int port = Service.freePort();

    Terminal.Ended run =
        terminal.mech(
            "simhost",
            "--server",
            Service.url(port),
            "--listen",
            "127.0.0.1:" + Service.freePort(),
            "--name",
            "workshop");

    assertOneMessage(run, 3);
    assertThat(run.stderr()).contains("127.0.0.1:" + port);
  }

  @Test
  void administratorOfAnUnreachableServerIsTold() {
    int port = Service.freePort();

    Terminal.Ended run = terminal.mech("admin", "--server", Service.url(port), "status");

    assertOneMessage(run, 3);
    assertThat(run.stderr()).contains("127.0.0.1:" + port);
  }

  private Terminal.Ended simulateOn(String url) {
    return terminal.mech(
        "simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--out", "r.csv");
  }

  private int writeSpoilt(String part, String replacement) throws IOException {
    String model = Files.readString(WorkingTree.PENDULUM);
    int place = model.lastIndexOf(part);
    assertThat(place).as("place of " + part).isPositive();
    Files.writeString(
        directory.resolve("bad.xml"),
        model.substring(0, place) + replacement + model.substring(place + part.length()));
    return 1 + (int) model.substring(0, place).chars().filter(c -> c == '\n').count();
  }

  private static void assertOneMessage(Terminal.Ended run, int exitStatus) {
    assertOneMessage(new Mechanic.Done(run.exitStatus(), run.stdout(), run.stderr()), exitStatus);
  }

  private static void assertOneMessage(Mechanic.Done run, int exitStatus) {
    assertThat(run.status()).as(run.toString()).isEqualTo(exitStatus);
    assertThat(run.out()).isEmpty();
    assertThat(run.err()).doesNotContain("\tat ", "Exception", "null");
    assertThat(CODE.matcher(run.err()).results().count()).as(run.err()).isEqualTo(1);
  }

  private void assertOnlyFilesAre(String... names) throws IOException {
    try (Stream<Path> files = Files.list(directory)) {
      List<String> found = files.map(file -> file.getFileName().toString()).toList();
      assertThat(found).containsExactlyInAnyOrder(names);
    }
  }
}
