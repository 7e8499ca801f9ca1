package org.mechservice.admin.web;

/** The rights of a user of the page; each includes those before it. */
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
