package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The Python package with the JARs of this build: its tests, and those of its page. */
class PythonIT {
  private static final Path PACKAGE = WorkingTree.TOP.resolve("python");

  /** Made by .ci/run, which installs what the package needs into it. */
  private static final Path PYTHON = PACKAGE.resolve(".venv/bin/python");

  @TempDir Path directory;

  @Test
  @SuppressWarnings("try") // the server runs until the tests have passed
  void testsOfThePackagePass() {
    assumeTrue(
        Files.isExecutable(PYTHON),
        "the Python package is not tested: it needs python/.venv, which .ci/run makes");
    Terminal terminal = new Terminal(WorkingTree.TOP);
    terminal.run(PACKAGE.resolve("take-jars").toString()).orFail();
    int port = Service.freePort();
    try (Terminal.Running server = Service.startServer(directory, port)) {
      assertThat(testsPass(terminal, Service.url(port))).contains(" passed");
    }
  }

  private static String testsPass(Terminal terminal, String server) {
    return terminal
        .run(
            "env",
            "MECHSERVICE_TEST_SERVER=" + server,
            "PYTHONPATH=" + PACKAGE.resolve("src"),
            "PYTHONDONTWRITEBYTECODE=1",
            PYTHON.toString(),
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            PACKAGE.resolve("tests").toString())
        .orFail()
        .stdout();
  }

  @Test
  void wheelHasTheJarsAndIsTyped() {
    assumeTrue(
        Files.isExecutable(PYTHON),
        "the Python wheel is not tested: it needs python/.venv, which .ci/run makes");
    Terminal terminal = new Terminal(WorkingTree.TOP);
    terminal
        .run(
            "env",
            "SKIP_MAVEN=yes",
            "PIP_OPTIONS=--no-build-isolation",
            "PYTHON=" + PYTHON,
            PACKAGE.resolve("build-wheel").toString(),
            directory.toString())
        .orFail();
    String files =
        terminal
            .shell(PYTHON + " -m zipfile -l " + directory + "/mechservice-0.1.0-py3-none-any.whl")
            .orFail()
            .stdout();
    assertThat(files).contains("mechservice/py.typed", "mechservice/_builder.pyi");
    assertThat(files).contains("jars/mechservice-0.1.0.jar", "jars/asm-", "jars/jacorb-");
    assertThat(files).doesNotContain("picocli").doesNotContain("bcprov").doesNotContain("mechcli-");
  }
}
