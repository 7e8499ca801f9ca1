package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.List;

/** The pieces of a text that class files hold in one constant each. */
public final class TextPieces {
  /**
   * Characters of a piece: a constant has at most 65535 bytes (JVMS §4.4.7), and a character takes
   * up to three.
   */
  private static final int LONGEST = 65535 / 3;

  private TextPieces() {}

  /** Returns the pieces of a text in order, at least one. */
  public static List<String> of(String text) {
    List<String> pieces = new ArrayList<>();
    int start = 0;
    for (; text.length() - start > LONGEST; start += LONGEST) {
      pieces.add(text.substring(start, start + LONGEST));
    }
    pieces.add(text.substring(start));
    return pieces;
  }
}
