package org.mechservice.solver.pack;

/** How references to fields and methods are told: those of a class's own by their distance. */
final class Members {
  /** None. */
  static final int NONE = 0;

  /** Any: its index follows. */
  static final int FAR = 1;

  /** A method of an interface where one of a class is usual: its index follows. */
  static final int OF_INTERFACE = 2;

  /** From here on: one of the class's own, so many behind its first. */
  static final int OWN = 3;

  /** Most of a class's own that a byte can tell. */
  static final int MOST_OWN = 0xff - OWN;

  private Members() {}
}
