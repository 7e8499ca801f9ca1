package org.mechservice.solver.symbol;

/**
 * A function of one or two arguments that a model gives by points, or a derivative of one, as one
 * node of a graph that is evaluated and not printed; code has its polynomials instead. Two are
 * equal if they are the same function.
 */
public non-sealed interface GivenFunction extends FixedPart {
  /** Returns the number of the polynomial at arguments; of one the second is ignored. */
  double place(double a, double b);

  /**
   * Returns its value, or NaN if there is none.
   *
   * @param place the number of the polynomial there
   */
  double value(double a, double b, double place);

  /** Returns its value, or NaN if there is none; of one argument the second is ignored. */
  default double at(double a, double b) {
    return value(a, b, place(a, b));
  }

  /**
   * Returns its derivative by an argument.
   *
   * @param argument 0 or 1
   */
  GivenFunction slope(int argument);

  /** Returns the function of which it is a derivative, or itself. */
  GivenFunction origin();
}
