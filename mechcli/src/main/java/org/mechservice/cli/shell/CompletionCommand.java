package org.mechservice.cli.shell;

import java.util.List;
import java.util.concurrent.Callable;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech completion}: a script that completes commands and options in the shell. */
@Command(
    name = "completion",
    description = {
      "Prints a script that completes commands, options and their values.",
      "bash: source <(mech completion bash)%nzsh:  source <(mech completion zsh)%nfish: mech completion fish | source"
    },
    footer = {"mech completion bash", "mech completion fish"},
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class CompletionCommand implements Callable<Integer> {
  private static final List<String> SHELLS = List.of("bash", "zsh", "fish");

  @Parameters(paramLabel = "bash|zsh|fish", description = "The shell.")
  private String shell = "";

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() {
    if (!SHELLS.contains(shell)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " completion: there is no script for \""
              + shell
              + "\"; there are "
              + String.join(", ", SHELLS));
    }
    CommandLine root = spec.root().commandLine();
    // One script for bash and zsh: it makes zsh read bash's completions.
    String script =
        shell.equals("fish") ? FishCompletion.of(root) : AutoComplete.bash("mech", root);
    spec.commandLine().getOut().print(script);
    return ExitStatus.DONE;
  }
}
