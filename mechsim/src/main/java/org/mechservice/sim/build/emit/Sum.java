package org.mechservice.sim.build.emit;

import java.util.Map;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Scalar;

/**
 * A sum or difference as it is written: a + (−3 b) as a − 3 b, which has the same bits.
 *
 * @param first what is written first
 * @param second what is added to it or subtracted
 * @param operation which of both
 * @param opposite whether the constant at the beginning of the second is written without its sign
 */
record Sum(Scalar first, Scalar second, Operation operation, boolean opposite) {

  /**
   * Returns how a sum or difference is written.
   *
   * @param places values that are not written out
   */
  static Sum of(Scalar node, Map<Scalar, Place> places) {
    boolean adds = node.operation() == Operation.ADD;
    Operation other = adds ? Operation.SUBTRACT : Operation.ADD;
    if (isNegative(node.second(), places)) {
      return new Sum(node.first(), node.second(), other, true);
    }
    return adds && isNegative(node.first(), places)
        ? new Sum(node.second(), node.first(), other, true)
        : new Sum(node.first(), node.second(), node.operation(), false);
  }

  /** Returns whether a value is written out and begins with a negative constant. */
  private static boolean isNegative(Scalar node, Map<Scalar, Place> places) {
    if (places.containsKey(node)) {
      return false;
    }
    return switch (node.operation()) {
      case CONSTANT -> node.value() < 0;
      case MULTIPLY, DIVIDE -> isNegative(node.first(), places);
      default -> false;
    };
  }
}
