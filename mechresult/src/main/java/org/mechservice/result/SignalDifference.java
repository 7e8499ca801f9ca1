package org.mechservice.result;

/**
 * The difference of one signal between two results.
 *
 * @param name the column
 * @param unit of its values, as the first result tells it
 * @param time where the difference is largest, s
 * @param first value of the first result there, the interpolated one if it has no row there
 * @param second value of the second result there, likewise
 * @param difference distance of the one value from the values that the other result has within the
 *     time tolerance; zero if it lies between them
 * @param size size of the signal, to which the tolerance is relative
 */
public record SignalDifference(
    String name,
    String unit,
    double time,
    double first,
    double second,
    double difference,
    double size) {

  /** Returns the difference relative to the size of the signal; zero if there is none. */
  public double relative() {
    return difference == 0 ? 0 : difference / size;
  }
}
