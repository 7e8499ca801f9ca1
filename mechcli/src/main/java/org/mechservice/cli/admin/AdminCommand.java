package org.mechservice.cli.admin;

import com.google.gson.JsonElement;
import java.io.PrintWriter;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.AdminJson;
import org.mechservice.admin.AdminTarget;
import org.mechservice.admin.DetailJson;
import org.mechservice.admin.DetailText;
import org.mechservice.admin.KnownSimulation;
import org.mechservice.admin.PlainText;
import org.mechservice.admin.QuantityText;
import org.mechservice.admin.ServerReading;
import org.mechservice.admin.StatusText;
import org.mechservice.admin.TextTable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.TlsOption;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.SessionSummary;
import org.mechservice.idl.SimDetail;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/**
 * {@code mech admin}: the commands that read; those that change something are in {@link
 * AdminActions}.
 */
@Command(
    name = "admin",
    description = "Shows servers, their hosts and simulations, and controls them.",
    subcommands = {
      AdminActions.Stop.class,
      AdminActions.End.class,
      AdminActions.Drain.class,
      AdminActions.Undrain.class,
      AdminActions.Shutdown.class,
      AdminActions.Limits.class,
      AdminActions.Placement.class,
      AdminWatchCommand.class,
      AdminWebCommand.class,
      CommandLine.HelpCommand.class
    },
    synopsisSubcommandLabel = "[COMMAND]",
    footer = {"mech admin status", "mech admin --server sim.example.org --tls keys/root watch"},
    mixinStandardHelpOptions = true,
    scope = ScopeType.INHERIT,
    versionProvider = MechVersion.class)
public final class AdminCommand implements Callable<Integer> {
  private static final int LOG_LINES_KEPT = 1000;

  /** Reads from the console and prints. */
  interface Work {
    int with(AdminConsole console, PrintWriter out) throws Exception;
  }

  @Option(
      names = "--server",
      paramLabel = "URL",
      scope = ScopeType.INHERIT,
      split = ",",
      description =
          "Server as host:port or URL; may be given several times (default: localhost:15000).")
  private List<String> servers = List.of();

  @Option(
      names = "--timeout",
      paramLabel = "S",
      scope = ScopeType.INHERIT,
      description = "Longest wait for a server's answer, s (default: 4).")
  private int timeout = (int) AdminConsole.PATIENCE.toSeconds();

  @Mixin private TlsOption tls = new TlsOption();

  @Option(
      names = "--json",
      scope = ScopeType.INHERIT,
      description = "Print one JSON object instead of text.")
  private boolean json;

  @Spec private CommandSpec spec = CommandSpec.create();

  private List<String> servers() {
    return servers.isEmpty() ? List.of("localhost:15000") : servers;
  }

  boolean asJson() {
    return json;
  }

  PrintWriter out() {
    return spec.commandLine().getOut();
  }

  PrintWriter err() {
    return spec.commandLine().getErr();
  }

  /** Opens a console. */
  AdminConsole open() {
    if (timeout < 1) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --timeout is " + timeout + "; it must be 1 or more");
    }
    return new AdminConsole(servers(), Duration.ofSeconds(timeout), tls.identity());
  }

  /** Opens a console for some work. */
  int console(Work work) throws Exception {
    try (AdminConsole console = open()) {
      return work.with(console, out());
    }
  }

  /** Prints JSON. */
  void print(JsonElement object) {
    out().println(AdminJson.text(object));
  }

  /** Names the servers that do not answer; the others are shown all the same. */
  int printSilent(List<ServerReading> readings) {
    int status = ExitStatus.DONE;
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Silent silent) {
        err().println(PlainText.of(silent.why()));
        status = ExitStatus.SERVER;
      }
    }
    return status;
  }

  private static boolean anyAnswers(List<ServerReading> readings) {
    return readings.stream().anyMatch(ServerReading.Answering.class::isInstance);
  }

  /** Prints a table of all servers, as text or as JSON. */
  private int show(
      Function<List<ServerReading>, JsonElement> asJson,
      Function<List<ServerReading>, Object> asText)
      throws Exception {
    return console(
        (console, out) -> {
          List<ServerReading> readings = console.read();
          if (json) {
            print(asJson.apply(readings));
          } else if (anyAnswers(readings)) {
            out.print(asText.apply(readings));
          }
          return printSilent(readings);
        });
  }

  private static StatusText text() {
    return new StatusText(Instant.now());
  }

  @Override
  public Integer call() throws Exception {
    return status();
  }

  /** Prints the state of every server. */
  @Command(
      name = "status",
      description = "Lists servers, hosts and running simulations.",
      footer = {"mech admin status", "mech admin --json status"})
  int status() throws Exception {
    return show(AdminJson::status, readings -> text().all(readings));
  }

  /** Prints the servers. */
  @Command(
      name = "servers",
      description = "Lists servers.",
      footer = "mech admin --server a.example.org,b.example.org servers")
  int listServers() throws Exception {
    return show(AdminJson::servers, readings -> text().servers(readings));
  }

  /** Prints the hosts. */
  @Command(
      name = "hosts",
      description = "Lists hosts with their load, also those lately lost.",
      footer = "mech admin hosts")
  int listHosts() throws Exception {
    return show(AdminJson::hosts, readings -> text().hosts(readings));
  }

  /** Prints simulations. */
  @Command(
      name = "sims",
      description = "Lists simulations that wait or run; with --all or --state also others.",
      footer = {"mech admin sims", "mech admin sims --state failed"})
  int listSimulations(
      @Option(names = "--all", description = "Also those that have ended.") boolean all,
      @Option(
              names = "--state",
              paramLabel = "S",
              description =
                  "Those that are created, queued, running, paused, done, failed or cancelled.")
          @Nullable String state)
      throws Exception {
    if (state != null && !KnownSimulation.states().contains(state)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --state takes "
              + String.join(" or ", KnownSimulation.states())
              + ", not "
              + state);
    }
    Function<List<ServerReading>, List<KnownSimulation>> chosen =
        readings ->
            KnownSimulation.all(readings).stream()
                .filter(
                    known ->
                        state == null ? all || known.isUnfinished() : known.state().equals(state))
                .toList();
    return show(
        readings ->
            AdminJson.named(
                "simulations", AdminJson.list(chosen.apply(readings), AdminJson::simulation)),
        readings -> text().simulations(chosen.apply(readings)));
  }

  /** Prints sessions. */
  @Command(
      name = "sessions",
      description = "Lists the sessions of clients with what they hold.",
      footer = {"mech admin sessions", "mech admin sessions --user ann"})
  int listSessions(
      @Option(names = "--user", paramLabel = "NAME", description = "Those of this user.")
          @Nullable String user)
      throws Exception {
    return console(
        (console, out) -> {
          List<SessionSummary> found = new ArrayList<>();
          for (String server : console.servers()) {
            found.addAll(console.sessions(server));
          }
          found.removeIf(session -> user != null && !session.owner.equals(user));
          if (json) {
            print(AdminJson.named("sessions", AdminJson.list(found, AdminJson::session)));
          } else {
            out.print(text().sessions(found));
          }
          return ExitStatus.DONE;
        });
  }

  /** Prints one simulation in full. */
  @Command(
      name = "show",
      description = "Shows one simulation in full.",
      footer = {"mech admin show 3f2a", "mech admin show 3f2a --model"})
  int show(
      @Parameters(
              paramLabel = "ID",
              description = "Id of the simulation, or its first characters (at least four).")
          String id,
      @Option(names = "--model", description = "Print the model's text instead.") boolean model)
      throws Exception {
    return console(
        (console, out) -> {
          KnownSimulation known = KnownSimulation.find(console.read(), id);
          SimDetail detail = console.show(known.server(), known.summary().simId);
          if (model) {
            out.print(PlainText.lines(detail.modelText));
          } else if (json) {
            print(DetailJson.of(known.server(), detail));
          } else {
            out.print(new DetailText(Instant.now()).format(detail));
          }
          return ExitStatus.DONE;
        });
  }

  /** Prints log lines. */
  @Command(
      name = "logs",
      description = "Shows the latest log lines of servers or of a host.",
      footer = "mech admin logs host2 --lines 20")
  int logs(
      @Parameters(
              arity = "0..1",
              paramLabel = "NAME",
              description = "A host or server; all servers if left out.")
          @Nullable String name,
      @Option(
              names = "--lines",
              paramLabel = "N",
              defaultValue = "100",
              description = "The latest N lines (default: ${DEFAULT-VALUE}).")
          int lines)
      throws Exception {
    if (lines < 1) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --lines is " + lines + "; it must be 1 or more");
    }
    return console(
        (console, out) -> {
          List<LogLine> found = new ArrayList<>();
          List<AdminTarget> places = placesOf(console, name);
          for (AdminTarget place : places) {
            List<LogLine> there = console.logs(place.server(), place.host(), 0, LOG_LINES_KEPT);
            if (places.size() > 1) {
              there.forEach(line -> line.source += " " + place.server());
            }
            found.addAll(there);
          }
          found.sort(Comparator.comparingLong(line -> line.writtenAt));
          List<LogLine> latest = found.subList(Math.max(0, found.size() - lines), found.size());
          if (json) {
            print(AdminJson.named("lines", AdminJson.list(latest, AdminJson::logLine)));
          } else {
            out.print(table(latest));
          }
          return ExitStatus.DONE;
        });
  }

  private static List<AdminTarget> placesOf(AdminConsole console, @Nullable String name) {
    return name == null
        ? console.servers().stream().map(server -> new AdminTarget(server, "")).toList()
        : List.of(AdminTarget.named(console.read(), name));
  }

  private static TextTable table(List<LogLine> lines) {
    TextTable table = new TextTable("AT", "LEVEL", "OF", "LINE");
    lines.forEach(
        line ->
            table.add(QuantityText.instant(line.writtenAt), line.level, line.source, line.text));
    return table;
  }
}
