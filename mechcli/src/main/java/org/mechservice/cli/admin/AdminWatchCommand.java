package org.mechservice.cli.admin;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.watch.Watch;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParentCommand;

/** {@code mech admin watch}: the console over the whole screen of a terminal. */
@Command(
    name = "watch",
    description = "Shows servers, hosts and simulations live; keys sort, inspect and cancel.",
    footer = "mech admin --server sim.example.org watch")
final class AdminWatchCommand implements Callable<Integer> {
  @ParentCommand private AdminCommand admin = new AdminCommand();

  @Override
  public Integer call() throws IOException {
    try (Terminal terminal = terminal();
        AdminConsole console = admin.open()) {
      new Watch(console, terminal).run();
    }
    return ExitStatus.DONE;
  }

  private static Terminal terminal() throws IOException {
    try {
      return TerminalBuilder.builder().system(true).dumb(false).build();
    } catch (IllegalStateException e) {
      throw new UsageException(
          MessageCode.WATCH_NEEDS_TERMINAL
              + " watch needs a terminal; for scripts there is mech admin status --json");
    }
  }
}
