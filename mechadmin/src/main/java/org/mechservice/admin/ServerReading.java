package org.mechservice.admin;

import java.util.List;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.SimSummary;

/** The answer of one server to a request for its state, or its failure. */
public sealed interface ServerReading {
  /** Returns the address of the server. */
  String address();

  /** Returns the server's name, or its address while it does not answer. */
  String name();

  /**
   * The server answered.
   *
   * @param address the server's address
   * @param status the server as a whole
   * @param hosts the hosts it knows
   * @param simulations those that wait, run or ended lately, oldest first
   */
  record Answering(
      String address, ServerStatus status, List<HostStatus> hosts, List<SimSummary> simulations)
      implements ServerReading {
    public Answering {
      hosts = List.copyOf(hosts);
      simulations = List.copyOf(simulations);
    }

    @Override
    public String name() {
      return status.info.serverName;
    }
  }

  /**
   * The first answer of the server is still outstanding.
   *
   * @param address the server's address
   */
  record Connecting(String address) implements ServerReading {
    @Override
    public String name() {
      return address;
    }
  }

  /**
   * The server did not answer, or only that it does not answer to us.
   *
   * @param address the server's address
   * @param why the failure, with its code
   * @param refused whether it answers, but not to us
   */
  record Silent(String address, String why, boolean refused) implements ServerReading {
    /** A server that does not answer. */
    public Silent(String address, String why) {
      this(address, why, false);
    }

    /** Returns the word for it. */
    public String label() {
      return refused ? "refused" : "no answer";
    }

    @Override
    public String name() {
      return address;
    }
  }
}
