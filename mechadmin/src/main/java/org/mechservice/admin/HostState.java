package org.mechservice.admin;

import org.mechservice.idl.HostStatus;

/** What an operator must know of a host first. */
public enum HostState {
  UP("up"),
  DRAINING("draining"),
  /** It has not answered lately. */
  SILENT("no answer"),
  /** Given up by its server, with its simulations. */
  LOST("lost");

  private static final String DROPPED = "dropped";

  private final String label;

  HostState(String label) {
    this.label = label;
  }

  /** Returns the state of a host. */
  public static HostState of(HostStatus host) {
    if (host.reachable) {
      return host.load.draining ? DRAINING : UP;
    }
    return host.text.startsWith(DROPPED) ? LOST : SILENT;
  }

  /** Returns the word for it. */
  public String label() {
    return label;
  }
}
