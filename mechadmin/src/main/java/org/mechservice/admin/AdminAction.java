package org.mechservice.admin;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.mechservice.idl.Limit;
import org.mechservice.idl.MechAdmin;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.TRANSIENT;
import org.omg.CORBA.UserException;

/**
 * An administrative action on a server, a host or a simulation. Each is one call of the
 * administration interface, and each has a command line that does the same.
 */
public sealed interface AdminAction {
  /** Calls the server. */
  void perform(MechAdmin admin) throws UserException;

  /** Returns the action in words. */
  String summary();

  /** Returns the words that do it after {@code mech admin --server ADDRESS}. */
  List<String> words();

  /** Returns the command line that does it, quoted for a shell. */
  default String commandLine(String address) {
    List<String> all = new ArrayList<>(List.of("mech", "admin", "--server", address));
    all.addAll(words());
    return all.stream().map(AdminAction::quoted).collect(Collectors.joining(" "));
  }

  private static String quoted(String word) {
    return word.matches("[A-Za-z0-9._:/@=,-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
  }

  private static String place(String host) {
    return host.isEmpty() ? "the server" : "host " + host;
  }

  private static List<String> onPlace(String command, String host) {
    return host.isEmpty() ? List.of(command) : List.of(command, "host:" + host);
  }

  /**
   * Ends a simulation.
   *
   * @param simId its full id
   * @param reason the reason that its owner receives
   */
  record StopSimulation(String simId, String reason) implements AdminAction {
    @Override
    public void perform(MechAdmin admin) throws UserException {
      admin.killSimulation(simId, reason);
    }

    @Override
    public String summary() {
      return "stop simulation " + simId + " (" + reason + ")";
    }

    @Override
    public List<String> words() {
      return List.of("stop", simId, "--reason", reason);
    }
  }

  /**
   * Ends sessions with their runs.
   *
   * @param owner whose; empty: the one of the id
   * @param sessionId its full id; empty: all of the owner
   * @param reason the reason that the owner receives
   */
  record EndSessions(String owner, String sessionId, String reason) implements AdminAction {
    @Override
    public void perform(MechAdmin admin) throws UserException {
      var unused = admin.endSessions(owner, sessionId, reason);
    }

    @Override
    public String summary() {
      String which = sessionId.isEmpty() ? "the sessions of " + owner : "session " + sessionId;
      return "end " + which + " (" + reason + ")";
    }

    @Override
    public List<String> words() {
      return sessionId.isEmpty()
          ? List.of("end", "--user", owner, "--reason", reason)
          : List.of("end", sessionId, "--reason", reason);
    }
  }

  /**
   * Admits no new simulation; running ones continue.
   *
   * @param host which host; empty: the whole server
   */
  record Drain(String host) implements AdminAction {
    @Override
    public void perform(MechAdmin admin) throws UserException {
      admin.drain(host);
    }

    @Override
    public String summary() {
      return "drain " + place(host);
    }

    @Override
    public List<String> words() {
      return onPlace("drain", host);
    }
  }

  /**
   * Admits new sessions and simulations again.
   *
   * @param host which host; empty: the whole server
   */
  record Undrain(String host) implements AdminAction {
    @Override
    public void perform(MechAdmin admin) throws UserException {
      admin.undrain(host);
    }

    @Override
    public String summary() {
      return "undrain " + place(host);
    }

    @Override
    public List<String> words() {
      return onPlace("undrain", host);
    }
  }

  /**
   * Ends the server.
   *
   * @param graceSeconds time that running simulations may still take, s
   */
  record Shutdown(int graceSeconds) implements AdminAction {
    public Shutdown {
      if (graceSeconds < 0) {
        throw new IllegalArgumentException(
            MessageCode.REQUEST_UNUSABLE
                + " a grace of "
                + graceSeconds
                + " s makes no sense; write 0 or more");
      }
    }

    @Override
    public void perform(MechAdmin admin) throws UserException {
      try {
        admin.shutdownServer(graceSeconds);
      } catch (COMM_FAILURE e) {
        // A server that ends at once may close the connection before its answer is through.
        if (answers(admin)) {
          throw e;
        }
      }
    }

    private static boolean answers(MechAdmin admin) throws UserException {
      try {
        var unused = admin.getStatus();
        return true;
      } catch (COMM_FAILURE | TRANSIENT e) {
        return false;
      }
    }

    @Override
    public String summary() {
      return "shut the server down within " + graceSeconds + " s";
    }

    @Override
    public List<String> words() {
      return List.of("shutdown", "--grace", Integer.toString(graceSeconds));
    }
  }

  /**
   * Changes limits; the others stay as they are.
   *
   * @param host which host; empty: the server and all its hosts
   * @param values name and value; -1 is unlimited
   */
  record SetLimits(String host, Map<String, Long> values) implements AdminAction {
    public SetLimits {
      values = Map.copyOf(values);
    }

    @Override
    public void perform(MechAdmin admin) throws UserException {
      admin.setLimits(
          host,
          new TreeMap<>(values)
              .entrySet().stream()
                  .map(value -> new Limit(value.getKey(), "", value.getValue(), ""))
                  .toArray(Limit[]::new));
    }

    private List<String> settings() {
      return new TreeMap<>(values)
          .entrySet().stream().map(value -> value.getKey() + "=" + value.getValue()).toList();
    }

    @Override
    public String summary() {
      return "set " + String.join(", ", settings()) + " for " + place(host);
    }

    @Override
    public List<String> words() {
      List<String> words = new ArrayList<>(List.of("limits"));
      if (!host.isEmpty()) {
        words.addAll(List.of("--host", host));
      }
      words.addAll(settings());
      return words;
    }
  }

  /**
   * Changes how hosts are chosen.
   *
   * @param policy one of the policies the server knows
   */
  record SetPlacement(String policy) implements AdminAction {
    @Override
    public void perform(MechAdmin admin) throws UserException {
      admin.setPlacement(policy);
    }

    @Override
    public String summary() {
      return "choose hosts by \"" + policy + "\"";
    }

    @Override
    public List<String> words() {
      return List.of("placement", policy);
    }
  }
}
