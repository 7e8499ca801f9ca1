package org.mechservice.admin;

/**
 * Makes text from other parties safe for a terminal: names of models, clients and hosts, and their
 * messages.
 */
public final class PlainText {
  private PlainText() {}

  /**
   * Returns the text in one line without anything that could steer a terminal or turn the reading
   * direction: such characters are shown as question marks.
   */
  public static String of(String text) {
    StringBuilder plain = new StringBuilder(text.length());
    text.codePoints().forEach(character -> plain.appendCodePoint(shown(character)));
    return plain.toString();
  }

  /** Returns the same, with its line feeds kept. */
  public static String lines(String text) {
    StringBuilder plain = new StringBuilder(text.length());
    text.codePoints()
        .filter(character -> character != '\r')
        .forEach(
            character ->
                plain.appendCodePoint(
                    character == '\n' || character == '\t' ? character : shown(character)));
    return plain.toString();
  }

  private static int shown(int character) {
    return switch (Character.getType(character)) {
      case Character.CONTROL,
          Character.FORMAT,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR,
          Character.SURROGATE,
          Character.UNASSIGNED ->
          '?';
      default -> character;
    };
  }
}
