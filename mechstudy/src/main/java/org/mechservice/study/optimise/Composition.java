package org.mechservice.study.optimise;

import java.util.List;
import java.util.function.UnaryOperator;

/**
 * What the aims of a problem are made of: quantities, of which some are the largest or the least of
 * others and therefore have corners. May be asked by several threads.
 */
public interface Composition {
  /**
   * A quantity that is the largest or the least of others.
   *
   * @param quantity its place among the quantities
   * @param largest whether it is the largest; else the least
   * @param from place of the first of the others, which follow each other
   * @param to place behind the last one
   */
  record Extreme(int quantity, boolean largest, int from, int to) {}

  /** Returns the quantities with corners. */
  List<Extreme> extremes();

  /** Returns how many of the quantities the aims are formulas of; they come first. */
  int count();

  /**
   * Computes all quantities.
   *
   * @param point one value for each variable, in their units; not modified
   * @return the quantities of the aims, then the others; NaN for one that there is not
   * @throws PointFailedException if there are none there
   */
  double[] quantities(double[] point) throws PointFailedException;

  /**
   * Returns the aims, in the units of the outputs; NaN for one without a value.
   *
   * @param quantities of which the first {@link #count} are used; not modified
   * @param point as of {@link #quantities}
   */
  double[] aims(double[] quantities, double[] point);

  /** Returns the same quantities with other aims, which are made of these. */
  default Composition withAims(UnaryOperator<double[]> others) {
    Composition own = this;
    return new Composition() {
      @Override
      public List<Extreme> extremes() {
        return own.extremes();
      }

      @Override
      public int count() {
        return own.count();
      }

      @Override
      public double[] quantities(double[] point) throws PointFailedException {
        return own.quantities(point);
      }

      @Override
      public double[] aims(double[] quantities, double[] point) {
        return others.apply(own.aims(quantities, point));
      }
    };
  }
}
