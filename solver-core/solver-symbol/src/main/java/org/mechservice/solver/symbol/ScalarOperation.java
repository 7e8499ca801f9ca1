package org.mechservice.solver.symbol;

/** The operation of a node of an expression graph. */
public enum ScalarOperation {
  /** A number. */
  CONSTANT(0),
  /** A number given when the program runs. */
  INPUT(0),
  ADD(1),
  SUBTRACT(1),
  MULTIPLY(1),
  DIVIDE(1),
  /** Change of sign; free on any processor, so not counted. */
  NEGATE(0),
  SQUARE_ROOT(1),
  /** Sine; always computed together with the cosine of the same angle. */
  SINE(0),
  COSINE(0),
  /** A function that is called; as many operations as a polynomial of some length. */
  FUNCTION(10);

  private final int flops;
  private final int hash;

  ScalarOperation(int flops) {
    this.flops = flops;
    this.hash = name().hashCode();
  }

  /** Returns a number that is the same in every run. */
  int hash() {
    return hash;
  }

  /** Returns the number of floating-point operations for which it counts. */
  int flops() {
    return flops;
  }
}
