package org.mechservice.sim.service.contract;

import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.Severity;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * An event for operators.
 *
 * @param kind one of the kinds the contract lists
 * @param level severity
 * @param code entry of the error catalogue; empty: none
 * @param hostName host concerned; empty: that of the journal
 * @param sessionId session concerned; empty: none
 * @param simId simulation concerned; empty: none
 * @param owner client concerned; empty: none
 * @param text one sentence for people; its beginning if it is long
 */
public record JournalEntry(
    String kind,
    Severity level,
    String code,
    String hostName,
    String sessionId,
    String simId,
    String owner,
    String text) {
  /** A thousand events are one message from a host to its server. */
  private static final int LONGEST_TEXT = 2000;

  public JournalEntry {
    text = ShortText.of(text, LONGEST_TEXT);
  }

  /** Returns an entry of information. */
  public static JournalEntry info(String kind, String text) {
    return new JournalEntry(kind, Severity.SEV_INFO, "", "", "", "", "", text);
  }

  /** Returns a warning that an operator should look at. */
  public static JournalEntry warning(String kind, MessageCode code, String text) {
    return new JournalEntry(kind, Severity.SEV_WARNING, code.code(), "", "", "", "", text);
  }

  /** Returns the same entry concerning a host. */
  public JournalEntry onHost(String name) {
    return new JournalEntry(kind, level, code, name, sessionId, simId, owner, text);
  }

  /** Returns the same entry concerning a session. */
  public JournalEntry inSession(String id, String client) {
    return new JournalEntry(kind, level, code, hostName, id, simId, client, text);
  }

  /** Returns the same entry concerning a simulation. */
  public JournalEntry ofSimulation(String id) {
    return new JournalEntry(kind, level, code, hostName, sessionId, id, owner, text);
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
