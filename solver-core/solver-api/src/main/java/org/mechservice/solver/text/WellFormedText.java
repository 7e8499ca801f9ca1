package org.mechservice.solver.text;

/**
 * Text that every encoding of Unicode can write. A text of Java may hold halves of characters
 * (surrogates without their partner), which strict encoders refuse.
 */
public final class WellFormedText {
  private static final char REPLACEMENT = '\uFFFD';

  private WellFormedText() {}

  /** Returns a text with the replacement character, U+FFFD, in place of each half of one. */
  public static String of(String text) {
    StringBuilder whole = new StringBuilder(text.length());
    for (int i = 0; i < text.length(); i++) {
      char one = text.charAt(i);
      boolean pair =
          Character.isHighSurrogate(one)
              && i + 1 < text.length()
              && Character.isLowSurrogate(text.charAt(i + 1));
      if (pair) {
        whole.append(one).append(text.charAt(++i));
      } else {
        whole.append(Character.isSurrogate(one) ? REPLACEMENT : one);
      }
    }
    return whole.toString();
  }
}
