package org.mechservice.sim.service.contract;

/** Texts of bounded length: of clients and their classes, where logs and lists show them. */
public final class ShortText {
  /** Longest name of a client or a file, in characters. */
  public static final int LONGEST_NAME = 200;

  private ShortText() {}

  /**
   * Returns a text, or its beginning.
   *
   * @param most characters of it that are kept
   */
  public static String of(String text, int most) {
    return text.length() <= most ? text : text.substring(0, most) + "...";
  }

  /** Returns a name without control characters, or its beginning: it stays in its line. */
  public static String name(String text) {
    return of(text, LONGEST_NAME).replaceAll("\\p{Cntrl}", "?");
  }
}
