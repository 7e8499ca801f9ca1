package org.mechservice.sim.service;

import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.Severity;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Something operators hear of.
 *
 * @param kind one of the kinds the contract lists
 * @param level how bad it is
 * @param code entry of the error catalogue; empty: none
 * @param hostName host it is about; empty: that of the journal
 * @param sessionId session it is about; empty: none
 * @param simId simulation it is about; empty: none
 * @param owner client it is about; empty: none
 * @param text what happened
 */
public record Happening(
    String kind,
    Severity level,
    String code,
    String hostName,
    String sessionId,
    String simId,
    String owner,
    String text) {

  /** Something ordinary. */
  public static Happening info(String kind, String text) {
    return new Happening(kind, Severity.SEV_INFO, "", "", "", "", "", text);
  }

  /** Something an operator should look at. */
  public static Happening warning(String kind, MessageCode code, String text) {
    return new Happening(kind, Severity.SEV_WARNING, code.code(), "", "", "", "", text);
  }

  /** Returns the same about a host. */
  public Happening onHost(String name) {
    return new Happening(kind, level, code, name, sessionId, simId, owner, text);
  }

  /** Returns the same about a session. */
  public Happening inSession(String id, String client) {
    return new Happening(kind, level, code, hostName, id, simId, client, text);
  }

  /** Returns the same about a simulation. */
  public Happening ofSimulation(String id) {
    return new Happening(kind, level, code, hostName, sessionId, id, owner, text);
  }

  ServiceEvent event(String source) {
    return new ServiceEvent(
        0,
        System.currentTimeMillis(),
        kind,
        level,
        code,
        hostName.isEmpty() ? source : hostName,
        sessionId,
        simId,
        owner,
        text);
  }
}
