package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.cli.shell.ExitStatus;

/** What the command line says to what nobody can do. */
class CommandLineTest {
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int mech(String... words) {
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "simulate m.xml --rtoll 1 | S-040 unknown option --rtoll; did you mean --rtol? (mech help"
            + " simulate lists what there is)",
        "simulate m.xml --view x.html | S-040 unknown option --view (mech help simulate lists what"
            + " there is)",
        "simulte m.xml | S-040 unknown command simulte; did you mean simulate? (mech help lists"
            + " what there is)",
        "simulate m.xml n.xml | S-040 unknown word n.xml (mech help simulate lists what there is)",
        "simulate | S-041 MODEL.xml is missing (mech help simulate lists what there is)",
        "simulate m.xml --rtol | S-041 --rtol lacks its value (mech help simulate lists what there"
            + " is)",
        "simulate m.xml --rtol abc | S-041 --rtol takes a number, not abc (mech help simulate lists"
            + " what there is)",
        "simulate m.xml --mode sideways | S-041 --mode takes remote or local, not sideways (mech"
            + " help simulate lists what there is)",
        "simulate m.xml --columns colours | S-041 --columns: \"colours\" is no column group; there"
            + " are joints, accelerations, bodies, energy, constraints, reactions, forces, outputs,"
            + " momentum, drives, and all",
        "simulate m.xml --out r.xls | S-044 --out r.xls: results are written to files whose names"
            + " end in .csv, .tsv, .mat, .json, .parquet, or as CSV to - (standard output)",
        "fetch 1 --server a:1 --out r.glb | S-044 --out r.glb: an animated scene needs a model;"
            + " write it by mech simulate MODEL.xml --out r.glb",
        "simulate m.xml --out r.csv --out ./r.csv | S-044 --out ./r.csv is given twice",
        "simulate m.xml --json --quiet=maybe | S-041 --quiet takes no value (mech help simulate"
            + " lists what there is)",
        "report -o r | S-041 report: name a model, or --compare with two files",
        "report m.xml | S-041 report: name the folder for the pages, -o DIR",
        "report m.xml -o r --budget 0 | S-041 --budget 0.0: the time for a report is a positive number"
            + " of seconds",
        "report m.xml -o r --budget -5 | S-041 --budget -5.0: the time for a report is a positive"
            + " number of seconds",
        "report m.xml -o r --budget NaN | S-041 --budget NaN: the time for a report is a positive"
            + " number of seconds",
        "report m.xml -o r --budget soon | S-041 --budget takes a number, not soon (mech help report"
            + " lists what there is)",
        "report --compare pom.xml pom.xml | S-041 --compare: pom.xml has no runs of a report",
        "stability -o r --limit x | S-041 --limit takes a number, not x (mech help stability lists"
            + " what there is)",
        "build m.xml | S-041 -o FILE.jar is missing, or --c DIR for the model in C, or --wasm"
            + " FILE.wasm for a module",
        "build m.xml --c d --standalone | S-041 -o FILE.jar is missing; --standalone needs it",
        "server --port 70000 | S-041 70000 is no port; there are ports from 0 (any free one) to"
            + " 65535",
        "server --listen 127.0.0.1:1 --port 2 | S-041 --port 2: --listen 127.0.0.1:1 already names"
            + " a port",
        "server --capacity -1 | S-041 --capacity is -1; it must be 0 or more",
        "simhost | S-041 --server is missing (mech help simhost lists what there is)",
        "simhost --server h:1 --capacity 0 | S-041 --capacity is 0; it must be 1 or more",
      })
  @ParameterizedTest
  void wrongUsageGetsOneMessageWithTheNearestThatExists(String line, String message) {
    assertThat(mech(line.split(" "))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString().strip()).isEqualTo(message);
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void everyCommandThatHelpListsIsThereByItself() {
    mech("help");
    List<String> names =
        out.toString()
            .lines()
            .filter(line -> line.matches("  [a-z]+ +[A-Z].*"))
            .map(line -> line.strip().split(" ", 2)[0])
            .filter(name -> !name.equals("help"))
            .toList();
    assertThat(names).hasSizeGreaterThan(10);
    for (String name : names) {
      out.getBuffer().setLength(0);
      assertThat(mech(name, "--help")).isEqualTo(ExitStatus.DONE);
      assertThat(out.toString()).startsWith("Usage: mech " + name + " ");
    }
  }

  @ValueSource(strings = {"limits", "status", "drain", "web"})
  @ParameterizedTest
  void commandsOfAdminExplainThemselves(String name) {
    assertThat(mech("admin", name, "--help")).isEqualTo(ExitStatus.DONE);
    assertThat(out.toString()).startsWith("Usage: mech admin " + name + " ");
  }

  @ValueSource(strings = {"simulate", "check", "admin status", "simhost"})
  @ParameterizedTest
  void unreachableServerIsNamedWithExitStatus3(String command, @TempDir Path folder)
      throws IOException {
    Path model = folder.resolve("m.xml");
    Files.writeString(model, "<MechML/>");
    boolean needsModel = command.equals("simulate") || command.equals("check");
    String line = command + (needsModel ? " " + model : "") + " --server 127.0.0.1:1";
    assertThat(mech(line.split(" "))).isEqualTo(ExitStatus.SERVER);
    assertThat(err.toString()).startsWith("S-0").contains("127.0.0.1:1").hasLineCount(1);
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void buildNamesTheFolderThatIsMissingBeforeItAsksAnyServer(@TempDir Path folder) {
    Path target = folder.resolve("none/p.jar");
    assertThat(mech("build", "m.xml", "-o", target.toString(), "--server", "127.0.0.1:1"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString())
        .startsWith("S-046 there is no folder " + target.getParent() + " for ");
  }

  @Test
  void emptyAddressOfAServerIsNotThisProcess() {
    assertThat(mech("check", "m.xml", "--server", "")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString().strip())
        .isEqualTo("S-041 --server lacks its value; leave it out to run here");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void buildTakesThePlaceOfNoDevice() {
    assertThat(mech("build", "m.xml", "-o", "/dev/null", "--server", "127.0.0.1:1"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString().strip()).isEqualTo("S-046 /dev/null is a device; name a file");
  }

  /** No system can spell a zero in a name, whatever the locale. */
  @Test
  void fileNameThatCannotBeSpelledIsNamed() {
    assertThat(mech("check", "a\0b.xml")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041 MODEL.xml takes a file name that this locale");
  }

  @Test
  void versionAndHelpAreAnswered() {
    assertThat(mech("--version")).isEqualTo(ExitStatus.DONE);
    assertThat(out.toString()).startsWith("mech 0.");
    assertThat(mech()).isEqualTo(ExitStatus.DONE);
    assertThat(out.toString()).contains("simulate", "check", "build", "server", "simhost", "admin");
  }

  @Test
  void helpNamesNoOptionThatDoesNotExistYet() {
    mech("help", "simulate");
    assertThat(out.toString())
        .contains("--formulation", "--columns")
        .doesNotContain("--view", "--plot");
  }

  /** Nobody has to know which of them a command has. */
  @Test
  void fileToWriteHasTheSameNamesInAllCommands() {
    assertThat(mech("help")).isEqualTo(ExitStatus.DONE);
    List<String> commands =
        out.toString().lines().filter(line -> line.matches("  [a-z]+ +[A-Z].*")).toList();
    assertThat(commands).hasSizeGreaterThan(20);
    int writing = 0;
    for (String line : commands) {
      String command = line.strip().split(" ", 2)[0];
      out.getBuffer().setLength(0);
      assertThat(mech("help", command)).as(command).isEqualTo(ExitStatus.DONE);
      String help = out.toString();
      if (help.contains("--out")) {
        writing++;
        assertThat(help).as(command).contains("-o, --out").contains("--output");
        assertThat(help).as(command).containsPattern("--out[,=]");
      }
    }
    assertThat(writing).isGreaterThan(10);
  }
}
