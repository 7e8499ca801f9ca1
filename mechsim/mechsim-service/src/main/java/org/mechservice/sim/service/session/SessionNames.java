package org.mechservice.sim.service.session;

/** Names of the owners of sessions that are of the service itself. */
public final class SessionNames {
  /** Of the session that tries whether sessions can be opened. It is in no log. */
  public static final String HEALTH_CHECK = "(health)";

  private SessionNames() {}

  /** Returns the name of a client, who must not look like the service itself. */
  public static String ofClient(String name) {
    return name.startsWith("(") ? "_" + name : name;
  }
}
