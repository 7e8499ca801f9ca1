package org.mechservice.admin.web;

/** What somebody may do, each more than the one before. */
enum Right {
  NONE("nobody"),
  MONITOR("monitor"),
  ADMIN("admin");

  private final String label;

  Right(String label) {
    this.label = label;
  }

  boolean includes(Right other) {
    return compareTo(other) >= 0;
  }

  String label() {
    return label;
  }
}
