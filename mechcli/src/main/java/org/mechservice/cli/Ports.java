package org.mechservice.cli;

/** Bounds of the numbers a serving process is given. */
final class Ports {
  private static final int HIGHEST = 65535;

  private Ports() {}

  static void requireUsable(int port) {
    require(port >= 0 && port <= HIGHEST, "--port", port, "from 0 to " + HIGHEST);
  }

  static void requireNotNegative(int capacity) {
    require(capacity >= 0, "--capacity", capacity, "0 or more");
  }

  static void requirePositive(int capacity) {
    require(capacity > 0, "--capacity", capacity, "1 or more");
  }

  private static void require(boolean met, String option, int value, String expected) {
    if (!met) {
      throw new UsageException("S-041 " + option + " is " + value + "; it must be " + expected);
    }
  }
}
