package org.mechservice.solver.dynamics.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.StateValue;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/**
 * Steps along given paths of two states x and y: what lies between their ends is found, wherever
 * and however short it is.
 */
final class StepSearchTest {
  private static final Expression X = new StateValue(0);
  private static final Expression Y = new StateValue(1);

  private static Expression call(MathFunction function, Expression... arguments) {
    return Expression.call(function, List.of(arguments));
  }

  private static Expression minus(Expression a, double b) {
    return new Sum(a, Expression.of(-b));
  }

  private static FurtherState state(String name, Expression rate) {
    return new FurtherState(name, 0, rate, "1", 0, Origin.NONE);
  }

  /** The path of x(t), y(t). */
  private static final class Way implements ModelEvents.Path {
    private final DoubleUnaryOperator x;
    private final DoubleUnaryOperator y;
    private final double[] state = new double[2];

    Way(DoubleUnaryOperator x, DoubleUnaryOperator y) {
      this.x = x;
      this.y = y;
    }

    @Override
    public boolean moveTo(double t) {
      state[0] = x.applyAsDouble(t);
      state[1] = y.applyAsDouble(t);
      return true;
    }

    @Override
    public double[] state() {
      return state;
    }
  }

  private static StateEvents events(Expression rate) {
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    return new StateEvents(
        new Mechanism("m", root, Vector3.ZERO, List.of(), List.of())
            .withFurtherStates(List.of(state("x", rate), state("y", Expression.ZERO))));
  }

  private static double seen(
      Expression rate, double to, DoubleUnaryOperator x, DoubleUnaryOperator y) {
    return events(rate).seenUntil(0, to, new Way(x, y));
  }

  @Test
  void stepWithoutChangeStands() {
    Expression gap = call(MathFunction.MAX, Expression.ZERO, X);
    assertThat(seen(gap, 2, t -> -1 + 0.4 * t, t -> 0)).isNaN();
  }

  /** One search sees many steps: what it knows of one must not stand for another. */
  @Test
  void stepAfterCalmOnesIsSearchedByItself() {
    StateEvents events = events(call(MathFunction.MAX, Expression.ZERO, new Negation(X)));
    DoubleUnaryOperator x = t -> 1 - 2 * Math.max(0, 1 - 100 * (t - 4.5) * (t - 4.5));
    Way way = new Way(x, t -> 0);
    for (int step = 0; step < 4; step++) {
      assertThat(events.seenUntil(step, step + 1, way)).isNaN();
    }
    assertThat(events.seenUntil(4, 5, way)).isCloseTo(4.5 - Math.sqrt(0.005), within(1e-12));
  }

  /** x passes through a window of any width and any place, at any speed. */
  @Test
  void noWindowIsTooNarrow() {
    Random random = new Random(1);
    for (int i = 0; i < 1000; i++) {
      double speed = Math.pow(10, 4 * random.nextDouble() - 2);
      double at = 0.2 + random.nextDouble();
      double width = Math.pow(10, -1 - 8 * random.nextDouble());
      Expression way = minus(X, speed * at);
      Expression inside =
          call(
              MathFunction.STEP,
              new Sum(
                  Expression.of(speed * speed * width * width),
                  new Negation(new Product(way, way))));
      double first = at - width;
      double found = seen(inside, 1.5, t -> speed * t, t -> 0);
      assertThat(found).as("at %s, width %s", at, width).isCloseTo(first, within(1e-12));
    }
  }

  /** A ball on a parabola dips into the ground by a depth of 1e-2 to 1e-11 of its height. */
  @Test
  void noTouchIsTooShallow() {
    Random random = new Random(2);
    for (int i = 0; i < 500; i++) {
      double depth = Math.pow(10, -2 - 9 * random.nextDouble());
      double at = 0.2 + 0.6 * random.nextDouble();
      Expression gap = call(MathFunction.MAX, Expression.ZERO, new Negation(X));
      double found = seen(gap, 1, t -> (t - at) * (t - at) - depth, t -> 0);
      // the touch lies sqrt(depth) before the lowest point; its place is rounded by ulp / slope
      assertThat(found).as("depth %s", depth).isCloseTo(at - Math.sqrt(depth), within(1e-9));
    }
  }

  /** Where a step jumps because a floor does, the floor has to be off its boundary. */
  @Test
  void changeIsClearOfItsCause() {
    Expression fraction = new Sum(X, new Negation(call(MathFunction.FLOOR, X)));
    Expression low = call(MathFunction.STEP, minus(new Negation(fraction), -0.5));
    double found = seen(low, 0.9, t -> 11.6 + t, t -> 0);
    // x is rounded by 2e-15; 256 last places of time are 1.4e-14 s
    assertThat(11.6 + found - 12).isBetween(1e-14, 1e-13);
  }

  /** Strobe: many turns in one step. */
  @Test
  void noTurnIsSkipped() {
    Expression strobe = call(MathFunction.STEP, minus(call(MathFunction.COS, X), 0.9998));
    double half = Math.acos(0.9998);
    double found = seen(strobe, 50, t -> 1 + t, t -> 0);
    assertThat(found).isCloseTo(2 * Math.PI - half - 1, within(1e-11));
  }

  /** A bump of no choice: the step ends before it, and the next one begins small. */
  @Test
  void narrowBumpIsMet() {
    Random random = new Random(3);
    for (int i = 0; i < 500; i++) {
      double at = 0.1 + 0.8 * random.nextDouble();
      double width = Math.pow(10, -2 - 5 * random.nextDouble());
      Expression way = new Product(minus(X, at), Expression.of(1 / width));
      Expression bump = call(MathFunction.EXP, new Negation(new Product(way, way)));
      StateEvents events = events(bump);
      double found = events.seenUntil(0, 1, new Way(t -> t, t -> 0));
      assertThat(found).as("at %s, width %s", at, width).isLessThan(at).isGreaterThan(0);
      assertThat(found + events.longestFirstStep()).isLessThan(at + width);
      assertThat(at - found).isLessThan(50 * width);
    }
  }

  /** What happens to a factor of zero does not end a step. */
  @Test
  void changeThatHasNoEffectIsNone() {
    Expression touching = call(MathFunction.MAX, Expression.ZERO, Y);
    Expression rate = new Product(touching, call(MathFunction.ABS, X));
    assertThat(seen(rate, 1, t -> t - 0.5, t -> -1)).isNaN();
    assertThat(seen(rate, 1, t -> t - 0.5, t -> 1)).isCloseTo(0.5, within(1e-12));
  }

  /** A choice that hovers about its boundary is left to the error test after some steps. */
  @Test
  void hoveringChoiceDoesNotStopARun() {
    StateEvents events = events(call(MathFunction.ABS, X));
    int cut = 0;
    for (int step = 0; step < 100; step++) {
      double from = step;
      double sign = step % 2 == 0 ? 1e-9 : -1e-9;
      Way way = new Way(t -> sign * (1 - 2 * (t - from)), t -> 0);
      cut += Double.isNaN(events.seenUntil(from, from + 1, way)) ? 0 : 1;
    }
    assertThat(cut).isBetween(1, 20);
  }
}
