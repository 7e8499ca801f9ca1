package org.mechservice.orb;

/** The objects of a server that are found by name instead of by reference. */
public enum ServiceKey {
  /** The interface for clients. */
  SERVER("MechServer"),
  /** The registry of hosts. */
  REGISTRY("HostRegistry"),
  /** The interface for administrators. */
  ADMIN("MechAdmin");

  private final String key;

  ServiceKey(String key) {
    this.key = key;
  }

  /** Returns the object key, the last part of a corbaloc URL. */
  public String key() {
    return key;
  }
}
