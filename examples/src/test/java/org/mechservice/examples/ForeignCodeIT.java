package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Each command with each way of bringing code, started as users do: nothing of it runs without
 * consent, nothing gets out with it, and what is harmless runs behind both walls.
 */
class ForeignCodeIT {
  @TempDir private Path folder;

  static Stream<String> commands() {
    return CodePaths.COMMANDS.stream();
  }

  @BeforeEach
  void writeModel() throws IOException {
    Files.writeString(folder.resolve("m.xml"), DraggedBob.MODEL);
    Files.writeString(
        folder.resolve("s.xml"),
        "<study model=\"m.xml\"><factor name=\"k\" values=\"1,2\"/><output name=\"e\""
            + " of=\"last(e)\"/></study>");
    Files.writeString(folder.resolve("data.csv"), "t,e\n0,0\n0.1,0.05\n0.2,0.1\n");
  }

  private Path escaped() {
    return folder.resolve("ESCAPED");
  }

  /** Code that writes a file, in an initialiser, in a declaration or in an evaluation. */
  private String escape() {
    return "try { java.nio.file.Files.writeString(java.nio.file.Path.of(\""
        + escaped()
        + "\"), \"x\"); } catch (java.io.IOException e) { throw new IllegalStateException(e); }";
  }

  private void writeSource(String inClass, String inDeclare, String inApply) throws IOException {
    DraggedBob.writeSource(folder, inClass, inDeclare, inApply);
  }

  private Terminal.Ended mech(String command, String... more) {
    List<String> words = new ArrayList<>(List.of(command.split(" ", -1)));
    words.addAll(List.of(more));
    return new Terminal(folder).mech(words.toArray(String[]::new));
  }

  static Stream<CodePaths.Way> ways() {
    return CodePaths.ways();
  }

  /**
   * Each way of bringing code, by three commands, and so each command by three ways or more:
   * refused by name, and nothing of it has run.
   */
  @MethodSource("ways")
  @ParameterizedTest
  void codeThatNobodyConsentedToDoesNotRun(CodePaths.Way way) throws IOException {
    requireRefused(way, CodePaths.someCommands(way));
  }

  /** Each way by each command. */
  @Tag("soak")
  @MethodSource("ways")
  @ParameterizedTest
  void codeThatNobodyConsentedToDoesNotRunByAnyCommand(CodePaths.Way way) throws IOException {
    requireRefused(way, CodePaths.COMMANDS);
  }

  private void requireRefused(CodePaths.Way way, List<String> commands) throws IOException {
    way.into(folder);
    for (String command : commands) {
      way.refusedBy("'" + WorkingTree.MECH + "'", command, new Terminal(folder), folder);
    }
  }

  @Test
  void refusalSaysHowToConsent() throws IOException {
    writeSource("", "", "");
    assertThat(mech("simulate m.xml").stderr())
        .contains("S-169", "--user-code " + folder.toRealPath());
  }

  /** Settings of the ORB in the working folder, which a model may have come with. */
  @Test
  void settingsBesideTheModelAreNotRead() throws IOException {
    String settings =
        "jacorb.logfile="
            + escaped()
            + "\njacorb.log.default.verbosity=4\n"
            + "org.omg.PortableInterceptor.ORBInitializerClass.evil=Evil\n"
            + "custom.props="
            + folder.resolve("more.properties")
            + "\n";
    for (String name : List.of("orb", "jacorb", "more", "atlas")) {
      Files.writeString(folder.resolve(name + ".properties"), settings);
    }
    Files.copy(WorkingTree.PENDULUM, folder.resolve("p.xml"));
    mech("simulate p.xml --out r.csv").orFail();
    assertThat(escaped()).doesNotExist();
  }

  @MethodSource("commands")
  @ParameterizedTest
  void codeThatReachesOutIsRefusedAlsoWithConsent(String command) throws IOException {
    writeSource("static { " + escape() + " }", escape(), escape());
    Terminal.Ended ended = mech(command, "--user-code", ".", "--unconfined");
    // To check or build a model runs nothing of it.
    boolean runs = !command.startsWith("check") && !command.startsWith("build");
    if (runs) {
      assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
      assertThat(ended.stderr()).contains("S-156");
    }
    assertThat(escaped()).doesNotExist();
  }

  @MethodSource("commands")
  @ParameterizedTest
  void harmlessCodeRunsConfinedOrNotAtAll(String command) throws IOException {
    writeSource("", "", "");
    Terminal.Ended ended = mech(command, "--user-code", ".");
    if (command.startsWith("gradient")) {
      // There is none of a class; nothing of it runs.
      assertThat(ended.stderr()).contains("S-216");
    } else if (command.endsWith(".fmu")) {
      // There is no C of a class, either.
      assertThat(ended.stderr()).contains("S-170");
    } else if (confines()) {
      assertThat(ended.exitStatus()).as(ended.toString()).isZero();
      assertThat(ended.stderr()).doesNotContain("S-175");
    } else if (!command.startsWith("check") && !command.startsWith("build")) {
      assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
      assertThat(ended.stderr()).contains("S-168", "--unconfined");
    }
  }

  /** Returns whether this machine confines: a source build has to find out, too. */
  static boolean confines() {
    return Stream.of(System.getenv("PATH").split(":", -1), new String[] {"/usr/bin"})
        .flatMap(Stream::of)
        .anyMatch(place -> Files.isExecutable(Path.of(place, "bwrap")));
  }

  /** A machine whose bubblewrap does not work. */
  private Terminal.Ended mechWithoutWall(String command) throws IOException {
    Path fake = Files.createDirectories(folder.resolve("bin")).resolve("bwrap");
    Files.writeString(fake, "#!/bin/sh\nexit 1\n");
    Files.setPosixFilePermissions(fake, PosixFilePermissions.fromString("rwxr-xr-x"));
    return new Terminal(folder)
        .shell("PATH=\"$PWD/bin:$PATH\" " + WorkingTree.MECH + " " + command);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"simulate m.xml", "simulate m.xml --mode local", "sweep m.xml --set k=1:2:2"})
  void withoutAWallCodeRunsOnlyIfItIsAskedForAndSaysSo(String command) throws IOException {
    writeSource("", "", "");
    Terminal.Ended refused = mechWithoutWall(command + " --user-code .");
    assertThat(refused.exitStatus()).as(refused.toString()).isNotZero();
    assertThat(refused.stderr()).contains("S-168", "--unconfined");
    Terminal.Ended ended = mechWithoutWall(command + " --user-code . --unconfined").orFail();
    assertThat(ended.stdout() + ended.stderr()).contains("S-175");
  }

  /** What a server has generated runs on the client's machine behind the same walls. */
  @Test
  void modelOfAServerRunsConfinedOrNotAtAll() throws IOException {
    int port = Service.freePort();
    String pendulum = WorkingTree.PENDULUM.toString();
    try (Terminal.Running server = Service.startServer(folder, port)) {
      assertThat(server.stdout()).isNotEmpty();
      String local = "simulate " + pendulum + " --server " + Service.url(port) + " --mode local";
      mech("simulate " + pendulum + " --out right.csv").orFail();
      if (confines()) {
        mech(local + " --out confined.csv").orFail();
        assertThat(folder.resolve("confined.csv"))
            .hasSameBinaryContentAs(folder.resolve("right.csv"));
      }
      Terminal.Ended refused = mechWithoutWall(local);
      assertThat(refused.exitStatus()).as(refused.toString()).isNotZero();
      assertThat(refused.stderr()).contains("S-168", "come from the server", "--unconfined");
      Terminal.Ended asked = mechWithoutWall(local + " --unconfined --out asked.csv").orFail();
      assertThat(asked.stdout() + asked.stderr()).contains("S-175");
      assertThat(folder.resolve("asked.csv")).hasSameBinaryContentAs(folder.resolve("right.csv"));
    }
  }

  /** A client without consent sends no class; a server without it takes none. */
  @Test
  void classTravelsToAServerOnlyIfBothSidesConsent() throws IOException {
    writeSource("static { " + escape() + " }", escape(), escape());
    for (String operator : List.of("", "--allow-user-code=unconfined")) {
      int port = Service.freePort();
      String[] options = operator.isEmpty() ? new String[0] : new String[] {operator};
      try (Terminal.Running server = Service.startServer(folder, port, options)) {
        assertThat(server.stdout()).isNotEmpty();
        for (String mode : List.of("remote", "local")) {
          String command = "simulate m.xml --server " + Service.url(port) + " --mode " + mode;
          Terminal.Ended unasked = mech(command);
          assertThat(unasked.exitStatus()).as(unasked.toString()).isNotZero();
          assertThat(unasked.stderr()).contains("S-169");
          Terminal.Ended asked = mech(command, "--user-code", ".");
          assertThat(asked.exitStatus()).as(asked.toString()).isNotZero();
          assertThat(asked.stderr())
              .as(asked.toString())
              .contains(operator.isEmpty() ? "S-120" : "S-156");
        }
      }
    }
    assertThat(escaped()).doesNotExist();
  }

  /** A program with the library on its class path, as the documentation starts one. */
  @Test
  void libraryRefusesWhatNobodyConsentedTo() throws IOException {
    writeSource("static { " + escape() + " }", escape(), escape());
    Files.writeString(
        folder.resolve("Try.java"),
        "import java.nio.file.Path; import org.mechservice.library.MechModel; class Try {"
            + " public static void main(String[] a) throws Exception {"
            + " MechModel.read(Path.of(\"m.xml\")).simulate(); } }");
    Path jar = WorkingTree.TOP.resolve("mechcli/target/mechcli.jar");
    Terminal.Ended ended = new Terminal(folder).shell("java -cp '" + jar + "' Try.java");
    assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
    assertThat(ended.stderr()).contains("S-169", "UserCode.in");
    assertThat(escaped()).doesNotExist();
  }

  @Test
  void pythonRefusesWhatNobodyConsentedTo() throws IOException {
    Path python = WorkingTree.TOP.resolve("python/.venv/bin/python");
    assumeTrue(Files.isExecutable(python), "it needs python/.venv, which .ci/run makes");
    Terminal terminal = new Terminal(folder);
    terminal.run(WorkingTree.TOP.resolve("python/take-jars").toString()).orFail();
    writeSource("static { " + escape() + " }", escape(), escape());
    Terminal.Ended ended =
        terminal.shell(
            "PYTHONPATH='"
                + WorkingTree.TOP.resolve("python/src")
                + "' '"
                + python
                + "' -c \"import mechservice; mechservice.read('m.xml').simulate()\"");
    assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
    assertThat(ended.stderr()).contains("S-169", "user_code");
    assertThat(escaped()).doesNotExist();
  }
}
