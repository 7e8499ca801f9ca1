package org.mechservice.cli.simulate;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.MechConnection;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.jar.JarCache;
import org.mechservice.client.run.ReattachedRun;
import org.mechservice.client.run.RunResult;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech fetch}: the results of a run whose client is gone. */
@Command(
    name = "fetch",
    description = {
      "Fetches the results of a run at a server by its id, all rows from the first on; of one that"
          + " goes on, also those to come.",
      "An ended run is kept for the server's retention time; one that goes on ends with the lease"
          + " of the client that has started it, unless this command holds it."
    },
    footer = "mech fetch 0f3a5c7e --server 127.0.0.1:15000 --out r.csv",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class FetchCommand implements Callable<Integer> {
  @Parameters(
      paramLabel = "ID",
      description = "Id of the run; mech simulate --server prints it, mech admin sims lists it.")
  private String id = "";

  @Mixin private ServerOption server = new ServerOption();

  @Mixin private ResultOptions results = new ResultOptions();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    results.requireUsable(false);
    if (server.address().isEmpty()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " fetch: name the server that has the run with --server URL");
    }
    try (MechConnection connection =
            MechConnection.open(server.address(), JarCache.ofUser(), server.identity());
        ReattachedRun run = connection.reattach(id);
        ResultFiles files = results.open(OptionalLong.empty(), List.of())) {
      return fetch(run, files);
    }
  }

  private int fetch(ReattachedRun run, ResultFiles files) throws IOException {
    PrintWriter err = spec.commandLine().getErr();
    if (!run.id().equals(id)) {
      err.println(
          MessageCode.RUN_MOVED
              + " run "
              + id
              + " has moved and is "
              + run.id()
              + " now; the rows before its move were handed to its client, those since then"
              + " are fetched");
    }
    RunResult result;
    try {
      result = run.toEnd(files);
    } catch (ServiceException e) {
      err.println(e.getMessage() + ResultOptions.keptRows(files));
      return ExitStatus.SERVER;
    }
    return results.report(result, files);
  }
}
