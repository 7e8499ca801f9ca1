package org.mechservice.sim.service.results;

import java.util.List;

/**
 * What a run is called and whose it is.
 *
 * @param simId its identity, unguessable
 * @param sessionId of the session that asked for it
 * @param hostName host it runs on
 * @param owner client that asked for it
 * @param modelName name of its model
 * @param fileName name of the model's file
 * @param modelText the model's file; empty if it is not kept
 * @param createdAt UTC, ms since 1970-01-01
 * @param earlierIds of the runs on other hosts that it goes on from
 */
public record RunIdentity(
    String simId,
    String sessionId,
    String hostName,
    String owner,
    String modelName,
    String fileName,
    String modelText,
    long createdAt,
    List<String> earlierIds) {

  public RunIdentity {
    earlierIds = List.copyOf(earlierIds);
  }

  /** Returns whether who asks for an id means this run. */
  public boolean answersTo(String id) {
    return simId.equals(id) || earlierIds.contains(id);
  }

  /** Returns the same without the model's text. */
  RunIdentity withoutText() {
    return new RunIdentity(
        simId, sessionId, hostName, owner, modelName, fileName, "", createdAt, earlierIds);
  }
}
