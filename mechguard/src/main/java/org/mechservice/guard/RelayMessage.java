package org.mechservice.guard;

/**
 * The kinds of messages between a program and a process with classes of its users. The program
 * asks, and the process answers each question but those that release something.
 */
final class RelayMessage {
  // From the program
  static final byte CLASSES = 'C';
  static final byte CREATE = 'N';
  static final byte DECLARE = 'D';
  static final byte APPLY = 'A';
  static final byte DIFFERENTIATE = 'J';
  static final byte RELEASE = 'R';
  static final byte RELEASE_CLASSES = 'U';
  // From the process
  static final byte DONE = 'O';
  static final byte THROWN = 'T';
  // From the process while a force declares, and the answers
  static final byte POINT = 'p';
  static final byte POINT_AT = 'a';
  static final byte COORDINATE = 'c';
  static final byte PARAMETER = 'm';
  static final byte VALUE = 'v';
  static final byte ACCEPTED = 'y';
  static final byte DENIED = 'n';
  // From the process with derivatives
  static final byte BY_POINT = 'b';
  static final byte BY_COORDINATE = 'k';

  /** Longest text, in characters; 3 bytes each fit into a message. */
  private static final int MOST_TEXT = 10_000;

  private RelayMessage() {}

  /** Returns a text that fits into a message. */
  static String clipped(String text) {
    return text.length() > MOST_TEXT ? text.substring(0, MOST_TEXT) + "..." : text;
  }
}
