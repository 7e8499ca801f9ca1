package org.mechservice.solver.spatial;

/** Tables of numbers for generated code with too many constants for single literals. */
public final class NumberTable {
  private NumberTable() {}

  /**
   * Reads numbers.
   *
   * @param count how many there are
   * @param texts their decimals in order, each followed by a blank
   */
  public static double[] of(int count, String... texts) {
    double[] numbers = new double[count];
    int next = 0;
    for (String text : texts) {
      int start = 0;
      for (int end = text.indexOf(' '); end >= 0; end = text.indexOf(' ', start)) {
        numbers[next] = Double.parseDouble(text.substring(start, end));
        next++;
        start = end + 1;
      }
    }
    return numbers;
  }
}
