package org.mechservice.solver.symbol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the rows of the catalogue say of one function agrees. */
final class MathFunctionTest {
  static List<MathFunction> functions() {
    return MathFunction.inFormulas();
  }

  static List<MathFunction> smooth() {
    return functions().stream().filter(MathFunction::isSmooth).toList();
  }

  private static double[] arguments(Random random) {
    double scale = Math.pow(10, random.nextInt(8) - 4);
    double first = random.nextInt(10) == 0 ? random.nextInt(3) - 1 : scale * random.nextGaussian();
    return new double[] {first, random.nextInt(10) == 0 ? first : random.nextGaussian()};
  }

  /** Returns what a program with a call of inputs gives. */
  private static double run(MathFunction function, double[] x) {
    Program program = new Program();
    program.section("call", "f");
    List<Scalar> inputs =
        IntStream.range(0, function.arity()).mapToObj(program.expressions()::input).toList();
    program.output(0, function.call(inputs));
    double[] out = new double[1];
    program.evaluate(x, out);
    return out[0];
  }

  @ParameterizedTest
  @MethodSource("functions")
  void constantsHaveTheBitsOfARun(MathFunction function) {
    Random random = new Random(function.symbol().hashCode());
    for (int i = 0; i < 2000; i++) {
      double[] x = arguments(random);
      double value = function.value(x);
      double run = run(function, x);
      assertThat(value).as("%s %s", x[0], x[1]).isEqualTo(Double.valueOf(run));
      assertThat(function.value(x[0], x[1])).isEqualTo(Double.valueOf(run));
      Expressions e = new Expressions();
      List<Scalar> constants =
          IntStream.range(0, function.arity()).mapToObj(k -> e.constant(x[k])).toList();
      if (Double.isFinite(run)) {
        // a constant −0 is 0
        assertThat(function.call(constants).value()).isEqualTo(run == 0 ? 0 : run);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("functions")
  void pieceChangesOnlyAcrossACorner(MathFunction function) {
    Random random = new Random(1);
    Corners corners = function.corners();
    for (int i = 0; i < 2000; i++) {
      double[] x = arguments(random);
      double way = corners.distance(x[0], x[1]);
      double part = Math.min(0.999 * way, 1e3) * random.nextDouble();
      double before = corners.piece(x[0], x[1]);
      assertThat(corners.piece(x[0] + part, x[1])).isEqualTo(before);
      assertThat(corners.piece(x[0] - part, x[1])).isEqualTo(before);
      if (function.jumps()) {
        assertThat(function.value(x[0] + part, x[1])).isEqualTo(function.value(x[0], x[1]));
      }
    }
    for (double place : corners.places()) {
      assertThat(corners.distance(place, 0)).isZero();
    }
  }

  /** Where a function is smooth its slope is that of differences, so its row forgets no corner. */
  @ParameterizedTest
  @MethodSource("smooth")
  void smoothFunctionsHaveContinuousSlopes(MathFunction function) {
    Program program = new Program();
    program.section("slope", "f");
    Expressions e = program.expressions();
    Scalar x0 = e.input(0);
    program.output(0, new Differentiation(e, Map.of(x0, e.one())).of(function.call(List.of(x0))));
    double[] slope = new double[1];
    double h = 1e-6;
    for (double x = -3; x <= 3; x += 0.125) {
      program.evaluate(new double[] {x - h}, slope);
      double before = slope[0];
      program.evaluate(new double[] {x + h}, slope);
      double behind = slope[0];
      // second derivatives are below 30 here, that of exp(3)
      assertThat(behind - before).isBetween(-30 * 2 * h, 30 * 2 * h);
    }
  }

  @Test
  void everyFunctionOfFormulasIsFoundByItsName() {
    for (MathFunction function : MathFunction.inFormulas()) {
      assertThat(MathFunction.named(function.symbol())).contains(function);
    }
    assertThat(MathFunction.named("")).isEmpty();
    assertThat(MathFunction.symbols()).doesNotHaveDuplicates().hasSize(21 + 1);
  }
}
