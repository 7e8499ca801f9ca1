package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each command with each way of bringing code, started as users do: nothing of it runs without
 * consent, nothing gets out with it, and what is harmless runs behind both walls.
 */
class ForeignCodeIT {
  /** Each command that reads a model and may run it; m.xml is the model. */
  private static final List<String> COMMANDS =
      List.of(
          "check m.xml",
          "simulate m.xml",
          "simulate m.xml --mode local",
          "simulate m.xml --out r.glb",
          "build m.xml -o m.jar",
          "view m.xml -o m.html",
          "report m.xml -o report --budget 5",
          "sweep m.xml --set k=1:2:2",
          "study s.xml -o s.csv",
          "optimise m.xml --minimise max(e) --by k=0:1",
          "identify m.xml --data data.csv --by k=0:1",
          "gradient m.xml --of last(e) --by k");

  @TempDir private Path folder;

  static Stream<String> commands() {
    return COMMANDS.stream();
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

  /** Turns the source into a class file. */
  private void compile() throws IOException {
    Path source = folder.resolve("Drag.java");
    String classPath = System.getProperty("java.class.path");
    String[] words = {"--release", "17", "-cp", classPath, "-d", folder.toString(), "" + source};
    assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, words)).isZero();
    Files.delete(source);
  }

  private Terminal.Ended mech(String command, String... more) {
    List<String> words = new ArrayList<>(List.of(command.split(" ", -1)));
    words.addAll(List.of(more));
    return new Terminal(folder).mech(words.toArray(String[]::new));
  }

  @MethodSource("commands")
  @ParameterizedTest
  void codeBesideTheModelDoesNotRunUnasked(String command) throws IOException {
    writeSource("static { " + escape() + " }", escape(), escape());
    Terminal.Ended ended = mech(command);
    assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
    assertThat(ended.stderr()).contains("S-169", "--user-code " + folder.toRealPath());

    compile();
    Terminal.Ended compiled = mech(command);
    assertThat(compiled.exitStatus()).as(compiled.toString()).isNotZero();
    assertThat(compiled.stderr()).contains("S-169");
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
    } else if (confines()) {
      assertThat(ended.exitStatus()).as(ended.toString()).isZero();
      assertThat(ended.stderr()).doesNotContain("S-175");
    } else if (!command.startsWith("check") && !command.startsWith("build")) {
      assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
      assertThat(ended.stderr()).contains("S-168", "--unconfined");
    }
  }

  /** In a source build the class path is one JAR, whose manifest has the others. */
  private boolean confines() {
    return Stream.of(System.getenv("PATH").split(":", -1), new String[] {"/usr/bin"})
        .flatMap(Stream::of)
        .anyMatch(place -> Files.isExecutable(Path.of(place, "bwrap")));
  }

  @Test
  void runThatIsUnconfinedSaysSo() throws IOException {
    assumeTrue(!confines(), "this machine confines");
    writeSource("", "", "");
    for (String command :
        List.of("simulate m.xml", "simulate m.xml --mode local", "sweep m.xml --set k=1:2:2")) {
      Terminal.Ended ended = mech(command, "--user-code", ".", "--unconfined").orFail();
      assertThat(ended.stdout() + ended.stderr()).contains("S-175");
    }
  }
}
