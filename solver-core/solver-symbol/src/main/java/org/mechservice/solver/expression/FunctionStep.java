package org.mechservice.solver.expression;

import org.mechservice.solver.symbol.Corners;
import org.mechservice.solver.symbol.Enclosure;
import org.mechservice.solver.symbol.MathFunction;

/**
 * A call of a function, as the catalogue knows it.
 *
 * @param function one that formulas can call and that is no formula of others
 */
record FunctionStep(MathFunction function) implements TapeStep {
  @Override
  public String name() {
    return function.name();
  }

  @Override
  public double value(double a, double b) {
    return function.value(a, b);
  }

  @Override
  public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
    function.bound(out, aLow, aHigh, bLow, bHigh);
    out.settle(function.isExact() ? 0 : Enclosure.ROUNDING);
  }

  @Override
  public boolean hasPieces() {
    return function.corners() != Corners.NONE;
  }

  @Override
  public double piece(double a, double b) {
    return function.corners().piece(a, b);
  }

  @Override
  public double distance(double a, double b) {
    return function.corners().distance(a, b);
  }

  @Override
  public boolean isNarrow() {
    return function.isNarrow();
  }

  @Override
  public boolean isEven(double aLow, double aHigh, double bLow, double bHigh, double highest) {
    return function.isEven(aLow, aHigh, bLow, bHigh, highest);
  }
}
