package org.mechservice.mechml.diagnosis;

/** Formats text from a model file for messages: in quotes, on one line, shortened. */
public final class Quoted {
  private static final int LONGEST = 60;

  private Quoted() {}

  /** Returns the text in quotes, shortened and without control characters. */
  public static String of(String text) {
    return '"' + plain(text) + '"';
  }

  /** Returns the text shortened and without control characters. */
  public static String plain(String text) {
    String shown = text.length() > LONGEST ? text.substring(0, LONGEST) + "..." : text;
    StringBuilder line = new StringBuilder();
    shown
        .codePoints()
        .map(c -> Character.isISOControl(c) || isLoneSurrogate(c) ? ' ' : c)
        .forEach(line::appendCodePoint);
    return line.toString();
  }

  /** Shortening may cut a surrogate pair in two. */
  private static boolean isLoneSurrogate(int c) {
    return c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE;
  }
}
