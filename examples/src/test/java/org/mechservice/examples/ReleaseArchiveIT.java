package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * The release archive, unpacked in an empty folder, on a Java without compiler. {@code mvn -Pdist
 * verify} makes the archive and runs this test.
 */
@EnabledIfSystemProperty(
    named = "mech.released",
    matches = "true",
    disabledReason = "mvn -Pdist verify makes the release archive")
class ReleaseArchiveIT {
  /** What a Java run time of a distribution has, as far as MechService uses it. */
  private static final String MODULES =
      "java.se,jdk.crypto.ec,jdk.httpserver,jdk.management,jdk.unsupported";

  @TempDir Path directory;

  private Terminal terminal;
  private String mech;

  @BeforeEach
  void unpack() throws IOException {
    terminal = new Terminal(directory);
    Path java = directory.resolve("java");
    StringWriter said = new StringWriter();
    ToolProvider jlink = ToolProvider.findFirst("jlink").orElseThrow();
    PrintWriter out = new PrintWriter(said);
    assertThat(jlink.run(out, out, "--add-modules", MODULES, "--output", java.toString()))
        .as(said.toString())
        .isZero();
    Path archive;
    try (Stream<Path> made = Files.list(WorkingTree.TOP.resolve("target"))) {
      archive = made.filter(file -> file.toString().endsWith(".tar.gz")).findFirst().orElseThrow();
    }
    terminal.shell("tar xzf " + archive).orFail();
    Path release;
    try (Stream<Path> unpacked = Files.list(directory)) {
      release =
          unpacked
              .filter(folder -> folder.getFileName().toString().startsWith("mechservice-"))
              .findFirst()
              .orElseThrow();
    }
    mech = "JAVA_HOME='" + java + "' '" + release.resolve("bin/mech") + "' ";
    for (String part :
        List.of(
            "LICENSE",
            "NOTICE",
            "licences/MIT.txt",
            "docs/README.md",
            "bin/mech.cmd",
            "share/man/man1/mech-simulate.1")) {
      assertThat(release.resolve(part)).isNotEmptyFile();
    }
    Files.createSymbolicLink(directory.resolve("examples"), release.resolve("examples"));
  }

  @Test
  void runsAsTheSourcesDo() {
    assertThat(terminal.shell(mech + "--version").orFail().stdout()).startsWith("mech ");
    String simulate = "simulate examples/pendulum/pendulum.xml --out ";
    terminal.shell(mech + simulate + "released.csv").orFail();
    new Terminal(directory)
        .mech("simulate", WorkingTree.PENDULUM.toString(), "--out", "built.csv")
        .orFail();
    assertThat(directory.resolve("released.csv"))
        .hasSameBinaryContentAs(directory.resolve("built.csv"));

    int port = Service.freePort();
    try (Terminal.Running server =
        terminal.start("sh", "-c", "exec env " + mech + "server --port " + port)) {
      server.awaitThat(Service.url(port), () -> server.stdout().contains(Service.url(port)));
      terminal.shell(mech + simulate + "served.csv --server 127.0.0.1:" + port).orFail();
    }
    assertThat(directory.resolve("served.csv"))
        .hasSameBinaryContentAs(directory.resolve("built.csv"));
  }

  /** The same refusals as a source build, on a Java without compiler. */
  @Test
  void codeThatNobodyConsentedToDoesNotRun() throws IOException {
    for (CodePaths.Way way : CodePaths.ways().toList()) {
      Path folder = Files.createTempDirectory(directory, "way");
      way.into(folder);
      for (String command : CodePaths.someCommands(way)) {
        way.refusedBy(mech, command, new Terminal(folder), folder);
      }
    }
  }

  @Test
  void onlySourcesOfForcesNeedACompiler() {
    Terminal.Ended refused =
        terminal.shell(
            mech
                + "simulate examples/driver/driver-c0.xml --user-code examples/driver --unconfined"
                + " --out d.csv");
    assertThat(refused.exitStatus()).isNotZero();
    assertThat(refused.stderr()).contains("S-084").contains("give the class file instead");
  }
}
