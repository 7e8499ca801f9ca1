package org.mechservice.admin;

import java.util.List;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.SimSummary;

/** What asking one server gave. */
public sealed interface ServerReading {
  /** Returns the address that was asked. */
  String address();

  /** Returns what people call the server: its name, or its address while it is silent. */
  String name();

  /**
   * The server answered.
   *
   * @param address the address that was asked
   * @param status the server as a whole
   * @param hosts the hosts it knows
   * @param simulations what waits, runs, or ended lately, oldest first
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
   * The server did not answer.
   *
   * @param address the address that was asked
   * @param why what happened instead, with its code
   */
  record Silent(String address, String why) implements ServerReading {
    @Override
    public String name() {
      return address;
    }
  }
}
