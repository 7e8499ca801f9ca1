package org.mechservice.cli.admin;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.mechservice.admin.AdminAction;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.AdminFailure;
import org.mechservice.admin.AdminFailure.Reason;
import org.mechservice.admin.AdminJson;
import org.mechservice.admin.AdminTarget;
import org.mechservice.admin.KnownSimulation;
import org.mechservice.admin.PlainText;
import org.mechservice.admin.TextTable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.idl.Limit;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;

/** The commands of {@code mech admin} that change something; the page's buttons do the same. */
final class AdminActions {
  private AdminActions() {}

  /** An action on servers. */
  abstract static class Acting implements Callable<Integer> {
    @ParentCommand private AdminCommand admin = new AdminCommand();

    AdminCommand admin() {
      return admin;
    }

    /** Performs an action on a server and prints that it was done. */
    int perform(AdminConsole console, String server, AdminAction action) {
      console.perform(server, action);
      if (admin.asJson()) {
        JsonObject json = new JsonObject();
        json.addProperty("done", true);
        json.addProperty("server", server);
        json.addProperty("action", action.summary());
        admin.print(json);
      } else {
        admin.out().println("done at " + server + ": " + PlainText.of(action.summary()));
      }
      return ExitStatus.DONE;
    }

    /** Without a name, the only server of the command is meant. */
    static AdminTarget place(AdminConsole console, String name) {
      if (!name.isEmpty()) {
        return AdminTarget.named(console.read(), name);
      } else if (console.servers().size() == 1) {
        return new AdminTarget(console.servers().get(0), "");
      }
      throw new AdminFailure(
          Reason.NOT_USABLE,
          MessageCode.AMBIGUOUS_NAME
              + " "
              + String.join(", ", console.servers())
              + " are asked; say which one is meant");
    }
  }

  /** {@code mech admin stop}. */
  @Command(
      name = "stop",
      description = "Ends a simulation; its rows so far are kept.",
      footer = "mech admin stop 3f2a --reason 'maintenance at noon'")
  static final class Stop extends Acting {
    @Parameters(
        paramLabel = "ID",
        description = "Id of the simulation, or its first characters (at least four).")
    private String id = "";

    @Option(
        names = "--reason",
        paramLabel = "TEXT",
        description = "What its owner is told (default: ${DEFAULT-VALUE}).")
    private String reason = "stopped by the operator";

    @Override
    public Integer call() throws Exception {
      return admin()
          .console(
              (console, out) -> {
                KnownSimulation known = KnownSimulation.find(console.read(), id);
                return perform(
                    console,
                    known.server(),
                    new AdminAction.StopSimulation(known.summary().simId, reason));
              });
    }
  }

  /** {@code mech admin end}. */
  @Command(
      name = "end",
      description = "Ends a session, or all sessions of a user, with their simulations.",
      footer = {"mech admin end 3f2a", "mech admin end --user ann --reason 'too many models'"})
  static final class End extends Acting {
    /** Fewer characters would mean too many sessions by accident. */
    private static final int FEWEST_CHARACTERS = 4;

    @Parameters(
        arity = "0..1",
        paramLabel = "ID",
        description = "Id of the session, or its first characters (at least four).")
    private String id = "";

    @Option(names = "--user", paramLabel = "NAME", description = "End all sessions of this user.")
    private String user = "";

    @Option(
        names = "--reason",
        paramLabel = "TEXT",
        description = "What the owner is told (default: ${DEFAULT-VALUE}).")
    private String reason = "ended by the operator";

    @Override
    public Integer call() throws Exception {
      if (id.isEmpty() == user.isEmpty()) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE
                + " end: name a session, or a user with --user; mech admin sessions lists them");
      }
      return admin()
          .console(
              (console, out) -> {
                if (!user.isEmpty()) {
                  return endOfUser(console);
                }
                Map<String, String> meant = new LinkedHashMap<>();
                for (String server : console.servers()) {
                  console.sessions(server).stream()
                      .filter(session -> session.sessionId.startsWith(id))
                      .forEach(session -> meant.put(session.sessionId, server));
                }
                if (meant.size() != 1 || id.length() < FEWEST_CHARACTERS) {
                  throw new AdminFailure(
                      Reason.NOT_USABLE,
                      MessageCode.NOTHING_OF_THAT_NAME
                          + " "
                          + meant.size()
                          + " sessions begin with \""
                          + id
                          + "\"; mech admin sessions lists them");
                }
                Map.Entry<String, String> one = meant.entrySet().iterator().next();
                return perform(
                    console, one.getValue(), new AdminAction.EndSessions("", one.getKey(), reason));
              });
    }

    /** A user may have sessions at some of the servers. */
    private int endOfUser(AdminConsole console) throws Exception {
      List<String> there = new ArrayList<>();
      for (String server : console.servers()) {
        if (console.sessions(server).stream().anyMatch(session -> session.owner.equals(user))) {
          there.add(server);
        }
      }
      if (there.isEmpty()) {
        throw new AdminFailure(
            Reason.NOT_USABLE,
            MessageCode.NOTHING_OF_THAT_NAME
                + " \""
                + user
                + "\" has no session; mech admin sessions lists them");
      }
      int status = ExitStatus.DONE;
      for (String server : there) {
        status =
            Math.max(
                status, perform(console, server, new AdminAction.EndSessions(user, "", reason)));
      }
      return status;
    }
  }

  /** An action on a host or a server. */
  abstract static class ActingAtPlace extends Acting {
    @Parameters(
        arity = "0..1",
        paramLabel = "HOST|SERVER",
        description = "Its name; the server asked if left out.")
    private String name = "";

    /** Returns the action; the host is empty if a server is meant. */
    abstract AdminAction action(String host);

    @Override
    public Integer call() throws Exception {
      return admin()
          .console(
              (console, out) -> {
                AdminTarget place = place(console, name);
                return perform(console, place.server(), action(place.host()));
              });
    }
  }

  /** {@code mech admin drain}. */
  @Command(
      name = "drain",
      description = {
        "Lets a host or server take nothing new; what runs moves to other hosts or finishes.",
        "A server is emptied together with the host in its process; other hosts by their names."
      },
      footer = "mech admin drain host2")
  static final class Drain extends ActingAtPlace {
    @Override
    AdminAction action(String host) {
      return new AdminAction.Drain(host);
    }
  }

  /** {@code mech admin undrain}. */
  @Command(
      name = "undrain",
      description = "Lets a host or server take new work again.",
      footer = "mech admin undrain host2")
  static final class Undrain extends ActingAtPlace {
    @Override
    AdminAction action(String host) {
      return new AdminAction.Undrain(host);
    }
  }

  /** {@code mech admin shutdown}. */
  @Command(
      name = "shutdown",
      description = "Ends a server.",
      footer = "mech admin --server sim.example.org:15000 shutdown")
  static final class Shutdown extends Acting {
    @Parameters(
        arity = "0..1",
        paramLabel = "SERVER",
        description = "Its name or address; the server asked if left out.")
    private String name = "";

    @Option(
        names = "--grace",
        paramLabel = "S",
        description = "Seconds that what runs may go on (default: ${DEFAULT-VALUE}).")
    private int grace = 30;

    @Override
    public Integer call() throws Exception {
      AdminAction action = new AdminAction.Shutdown(grace);
      return admin()
          .console(
              (console, out) -> {
                String server = name.startsWith("server:") ? name : "server:" + name;
                AdminTarget place = place(console, name.isEmpty() ? "" : server);
                return perform(console, place.server(), action);
              });
    }
  }

  /** {@code mech admin limits}. */
  @Command(
      name = "limits",
      description = "Shows what is bounded, or sets bounds.",
      footer = {"mech admin limits", "mech admin limits --host host2 wallTime=3600 queue=100"})
  static final class Limits extends Acting {
    @Option(
        names = "--host",
        paramLabel = "HOST",
        description = "Of this host; of the servers asked and all their hosts if left out.")
    private String host = "";

    @Parameters(
        paramLabel = "NAME=VALUE",
        description = "Limits to set; \"unlimited\" is a value, too. None: show them.")
    private Map<String, String> values = Map.of();

    @Override
    public Integer call() throws Exception {
      Map<String, Long> numbers = new TreeMap<>();
      values.forEach((limit, text) -> numbers.put(limit, number(limit, text)));
      return admin()
          .console(
              (console, out) -> {
                for (AdminTarget place : places(console)) {
                  if (!numbers.isEmpty()) {
                    perform(
                        console, place.server(), new AdminAction.SetLimits(place.host(), numbers));
                  }
                }
                return numbers.isEmpty() ? show(console) : ExitStatus.DONE;
              });
    }

    private static long number(String limit, String text) {
      if (text.equals("unlimited")) {
        return -1;
      }
      try {
        return Long.parseLong(text);
      } catch (NumberFormatException e) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE
                + " "
                + limit
                + " takes a whole number or unlimited, not "
                + text);
      }
    }

    private List<AdminTarget> places(AdminConsole console) {
      return host.isEmpty()
          ? console.servers().stream().map(server -> new AdminTarget(server, "")).toList()
          : List.of(AdminTarget.named(console.read(), "host:" + host));
    }

    private int show(AdminConsole console) {
      JsonArray all = new JsonArray();
      for (AdminTarget place : places(console)) {
        List<Limit> limits = console.limits(place.server(), place.host());
        if (admin().asJson()) {
          all.add(AdminJson.limits(place, limits));
        } else {
          admin().out().println(place);
          admin().out().print(table(limits));
        }
      }
      if (admin().asJson()) {
        admin().print(AdminJson.named("places", all));
      }
      return ExitStatus.DONE;
    }

    private static TextTable table(List<Limit> limits) {
      TextTable table = new TextTable("LIMIT", "VALUE", "UNIT", "WHAT");
      for (Limit limit : limits) {
        String value = limit.value == -1 ? "unlimited" : Long.toString(limit.value);
        table.add(limit.name, value, limit.unit, limit.text);
      }
      return table;
    }
  }

  /** {@code mech admin placement}. */
  @Command(
      name = "placement",
      description = "Shows how hosts are chosen, or sets it: order, least-loaded, pinned.",
      footer = {"mech admin placement", "mech admin placement least-loaded"})
  static final class Placement extends Acting {
    @Parameters(arity = "0..1", paramLabel = "POLICY", description = "None: show it.")
    private String policy = "";

    @Override
    public Integer call() throws Exception {
      return admin()
          .console(
              (console, out) -> {
                JsonObject all = new JsonObject();
                for (String server : console.servers()) {
                  if (!policy.isEmpty()) {
                    perform(console, server, new AdminAction.SetPlacement(policy));
                  } else if (admin().asJson()) {
                    all.addProperty(server, console.placement(server));
                  } else {
                    out.println(server + "  " + PlainText.of(console.placement(server)));
                  }
                }
                if (policy.isEmpty() && admin().asJson()) {
                  admin().print(AdminJson.named("placement", all));
                }
                return ExitStatus.DONE;
              });
    }
  }
}
