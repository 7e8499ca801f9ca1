package org.mechservice.server.hosts;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/** The rule that chooses the host of a session if the client names none. */
public enum PlacementPolicy {
  /** The hosts are filled one after the other, in the order in which they joined. */
  ORDER("order"),
  /** The host with most free places; among equals a registered one before the server's own. */
  LEAST_LOADED("least-loaded"),
  /** The host the client had last, as long as it is there; else the one with most free places. */
  PINNED("pinned");

  private final String label;

  PlacementPolicy(String label) {
    this.label = label;
  }

  /** Returns the policy's name on the command line and in the contract. */
  public String label() {
    return label;
  }

  /** Returns the policy of a name, if there is one. */
  public static Optional<PlacementPolicy> named(String label) {
    return Arrays.stream(values()).filter(policy -> policy.label.equals(label)).findFirst();
  }

  /** Returns all names. */
  public static String labels() {
    return Arrays.stream(values()).map(PlacementPolicy::label).collect(Collectors.joining(", "));
  }
}
