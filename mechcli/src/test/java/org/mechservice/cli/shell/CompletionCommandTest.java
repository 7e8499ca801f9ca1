package org.mechservice.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.cli.Mech;

class CompletionCommandTest {
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int mech(String... words) {
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  /** Bash itself completes, as when the user presses the tab key. */
  @ParameterizedTest
  @CsvSource({
    "simu, simulate",
    "simulate --integ, --integrator",
    "admin dr, drain",
  })
  void bashCompletesCommandsAndOptions(String typed, String completed) throws Exception {
    mech("completion", "bash");
    Process bash = new ProcessBuilder("bash", "-s").redirectErrorStream(true).start();
    String question =
        out
            + "\nCOMP_WORDS=(mech "
            + typed
            + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); compopt() { :; }; _complete_mech;"
            + " echo \"${COMPREPLY[@]}\"\n";
    bash.getOutputStream().write(question.getBytes(StandardCharsets.UTF_8));
    bash.getOutputStream().close();
    String answer = new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(answer.strip()).isEqualTo(completed);
  }

  @Test
  void unknownShellIsNamedWithThoseThatAreKnown() {
    assertThat(mech("completion", "csh")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("\"csh\"; there are bash, zsh, fish");
  }

  @Test
  void fishScriptHasCommandsAtTheirPlaceAndOptionsWithValues() {
    assertThat(mech("completion", "fish")).isEqualTo(ExitStatus.DONE);
    assertThat(out.toString().lines())
        .allMatch(line -> line.startsWith("complete -c mech -n '"))
        .anyMatch(line -> line.contains("'not __fish_seen_subcommand_from new examples"))
        .anyMatch(line -> line.contains(" -f -a simulate -d '"))
        .anyMatch(
            line ->
                line.startsWith(
                    "complete -c mech -n '__fish_seen_subcommand_from admin; and"
                        + " __fish_seen_subcommand_from drain'"))
        .anyMatch(
            line ->
                line.contains("'__fish_seen_subcommand_from simulate'")
                    && line.contains(" -l integrator "));
  }
}
