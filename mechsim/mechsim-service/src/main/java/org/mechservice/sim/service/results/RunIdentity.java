package org.mechservice.sim.service.results;

import java.util.List;

/**
 * The names of a run and its owner.
 *
 * @param simId its id, unguessable
 * @param sessionId of the session that created it
 * @param hostName host it runs on
 * @param owner client that created it
 * @param modelName name of its model
 * @param fileName name of the model's file
 * @param modelText the model's file; empty if it is not kept
 * @param createdAt UTC, ms since 1970-01-01
 * @param earlierIds ids of the runs on other hosts that it continues
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

  /** Returns whether an id is that of this run or of an earlier one that it continues. */
  public boolean answersTo(String id) {
    return simId.equals(id) || earlierIds.contains(id);
  }

  /** Returns the same without the model's text. */
  RunIdentity withoutText() {
    return new RunIdentity(
        simId, sessionId, hostName, owner, modelName, fileName, "", createdAt, earlierIds);
  }
}
