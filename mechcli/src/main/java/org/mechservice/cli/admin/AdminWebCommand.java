package org.mechservice.cli.admin;

import com.google.gson.JsonObject;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import org.jspecify.annotations.Nullable;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.web.AccessTokens;
import org.mechservice.admin.web.AdminWeb;
import org.mechservice.cli.service.ListenOptions;
import org.mechservice.cli.service.ServingProcess;
import org.mechservice.cli.shell.ExitStatus;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;

/** {@code mech admin web}: the console in a browser of this machine. */
@Command(
    name = "web",
    description = "Serves the console as a page on this machine, until it is stopped with Ctrl-C.",
    footer = "mech admin web --port 15080 --tokens tokens.json --audit audit.jsonl")
final class AdminWebCommand implements Callable<Integer> {
  private static final int DEFAULT_PORT = 15080;

  @ParentCommand private AdminCommand admin = new AdminCommand();

  @Option(
      names = "--port",
      paramLabel = "P",
      description = "Port of the page; 0: any free one (default: ${DEFAULT-VALUE}).")
  private int port = DEFAULT_PORT;

  @Option(
      names = "--tokens",
      paramLabel = "FILE",
      description =
          "Keep the tokens monitor and admin in this file; made if it is missing. If left out,"
              + " they are new at every start.")
  private @Nullable Path tokenFile;

  @Option(
      names = "--audit",
      paramLabel = "FILE",
      description = "Add what is done and refused to this file, one JSON object a line.")
  private @Nullable Path auditFile;

  @Override
  public Integer call() throws Exception {
    ListenOptions.usable(port);
    AccessTokens tokens = tokenFile == null ? AccessTokens.random() : AccessTokens.kept(tokenFile);
    try (AdminConsole console = admin.open();
        AdminWeb web = new AdminWeb(console, port, tokens, Optional.ofNullable(auditFile))) {
      print(web.url(tokens.monitor()), web.url(tokens.admin()));
      admin.out().flush();
      ServingProcess.untilEnded(web, new CountDownLatch(1)::await);
    }
    return ExitStatus.DONE;
  }

  private void print(String monitor, String steering) {
    if (admin.asJson()) {
      JsonObject json = new JsonObject();
      json.addProperty("monitor", monitor);
      json.addProperty("admin", steering);
      admin.print(json);
    } else {
      admin.out().println("to see:   " + monitor);
      admin.out().println("to steer: " + steering);
    }
  }
}
