package org.mechservice.view.mesh;

/** Reads numbers in the text of geometry files. */
final class MeshNumbers {
  private MeshNumbers() {}

  static double number(String word) throws MeshException {
    try {
      return Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw new MeshException(
          word.isEmpty() ? "it ends where a number is due" : quoted(word) + " is no number");
    }
  }

  static long index(String word) throws MeshException {
    try {
      return Long.parseLong(word);
    } catch (NumberFormatException e) {
      throw new MeshException(quoted(word) + " is no index");
    }
  }

  /** Returns the beginning of a word in quotation marks, without control characters. */
  static String quoted(String word) {
    String shown = word.length() > 40 ? word.substring(0, 40) + "..." : word;
    return '"' + shown.replaceAll("\\p{Cntrl}", "?") + '"';
  }
}
