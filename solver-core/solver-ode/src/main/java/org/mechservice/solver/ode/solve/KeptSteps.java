package org.mechservice.solver.ode.solve;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.StepPolynomial;

/** The polynomials of all steps of a run, in blocks of numbers. */
final class KeptSteps {
  private static final int FIRST_BLOCK = 1 << 9;
  private static final int LARGEST_BLOCK = 1 << 17;

  private final double start;
  private final double direction;

  /** Per step: its end, order, block, place in the block, and the integrator that evaluates it. */
  private double[] ends = new double[16];

  private byte[] orders = new byte[16];
  private int[] blocks = new int[16];
  private int[] places = new int[16];
  private StepPolynomial[] polynomials = new StepPolynomial[16];

  private final List<double[]> numbers = new ArrayList<>();
  private int filled;
  private int count;

  /**
   * @param direction 1 or −1
   */
  KeptSteps(double start, double direction) {
    this.start = start;
    this.direction = direction;
  }

  /** Keeps the last step of an integrator, up to where it counts. */
  void add(Integrator integrator, double end) {
    if (count == ends.length) {
      int more = 2 * count;
      ends = Arrays.copyOf(ends, more);
      orders = Arrays.copyOf(orders, more);
      blocks = Arrays.copyOf(blocks, more);
      places = Arrays.copyOf(places, more);
      polynomials = Arrays.copyOf(polynomials, more);
    }
    int length = integrator.keptLength();
    double[] block = blockFor(length);
    ends[count] = end;
    orders[count] = (byte) integrator.order();
    blocks[count] = numbers.size() - 1;
    places[count] = filled;
    polynomials[count] = integrator.keepStep(block, filled);
    filled += length;
    count++;
  }

  private double[] blockFor(int length) {
    int last = numbers.isEmpty() ? 0 : numbers.get(numbers.size() - 1).length;
    if (numbers.isEmpty() || filled + length > last) {
      int size = numbers.isEmpty() ? FIRST_BLOCK : Math.min(2 * last, LARGEST_BLOCK);
      numbers.add(new double[Math.max(size, length)]);
      filled = 0;
    }
    return numbers.get(numbers.size() - 1);
  }

  int count() {
    return count;
  }

  double start(int step) {
    return step == 0 ? start : ends[step - 1];
  }

  double end(int step) {
    return ends[step];
  }

  int order(int step) {
    return orders[step];
  }

  /** Returns the first step that ends at t or behind; the number of steps if none does. */
  int stepAt(double t) {
    int low = 0;
    int high = count;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (direction * (ends[middle] - t) >= 0) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }

  /** Evaluates a step; the derivative only if its array is not of length 0. */
  void evaluate(int step, double t, double[] y, double[] yDot) {
    polynomials[step].evaluate(numbers.get(blocks[step]), places[step], t, y, yDot);
  }
}
