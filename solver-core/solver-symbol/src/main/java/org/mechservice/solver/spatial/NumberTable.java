package org.mechservice.solver.spatial;

/**
 * Tables of numbers for generated code with too many constants for single literals, and the search
 * in rows of them.
 */
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

  /**
   * Returns how many numbers of an ascending row are not above x, as a whole number; 0 if x is NaN.
   *
   * @param table holds the row; not modified
   * @param first where the row begins
   * @param count its numbers
   */
  public static double interval(double[] table, int first, int count, double x) {
    int low = first;
    int high = first + count;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (table[middle] <= x) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low - first;
  }

  /**
   * Returns a number of a row.
   *
   * @param table holds the row; not modified
   * @param first where the row begins
   * @param count its numbers
   * @param index a whole number from 0 to count − 1
   */
  public static double element(double[] table, int first, int count, double index) {
    return table[first + (int) index];
  }
}
