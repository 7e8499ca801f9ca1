package org.mechservice.solver.expression;

import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import org.mechservice.solver.symbol.FunctionDerivatives;
import org.mechservice.solver.symbol.MathFunction;

/**
 * First and second partial derivatives of one operation f(a, b), and scratch for their computation.
 */
final class LocalDerivatives {
  double byA;
  double byB;
  double byAA;
  double byAB;
  double byBB;

  /** Of the functions of a tape. */
  private final Map<MathFunction, FunctionDerivatives> functions =
      new EnumMap<>(MathFunction.class);

  /** Makes room for the derivatives of all steps of a tape. */
  LocalDerivatives(Tape tape) {
    for (TapeStep step : tape.operation) {
      if (step instanceof FunctionStep call) {
        functions.computeIfAbsent(call.function(), FunctionDerivatives::new);
      }
    }
  }

  /** Sets the derivatives of a function of the tape. */
  void of(MathFunction function, double a, double b) {
    FunctionDerivatives derivatives = Objects.requireNonNull(functions.get(function));
    derivatives.evaluate(a, b);
    all(
        derivatives.value(FunctionDerivatives.BY_A),
        derivatives.value(FunctionDerivatives.BY_B),
        derivatives.value(FunctionDerivatives.BY_AA),
        derivatives.value(FunctionDerivatives.BY_AB),
        derivatives.value(FunctionDerivatives.BY_BB));
  }

  /** Sets the derivatives of an operation that is linear in both arguments. */
  void linear(double a, double b) {
    all(a, b, 0, 0, 0);
  }

  /** Sets the derivatives of a function of one argument. */
  void single(double first, double second) {
    all(first, 0, second, 0, 0);
  }

  /** Sets all five derivatives. */
  void all(double a, double b, double aa, double ab, double bb) {
    byA = a;
    byB = b;
    byAA = aa;
    byAB = ab;
    byBB = bb;
  }
}
