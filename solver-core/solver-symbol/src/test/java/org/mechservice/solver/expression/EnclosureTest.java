package org.mechservice.solver.expression;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.symbol.Enclosure;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.WatchedStep;

/** Bounds hold what they bound. */
final class EnclosureTest {
  private final Enclosure enclosure = new Enclosure();

  private double between(Random random, double low, double high) {
    return switch (random.nextInt(8)) {
      case 0 -> low;
      case 1 -> high;
      default -> low + random.nextDouble() * (high - low);
    };
  }

  static Stream<WatchedStep> steps() {
    return Stream.concat(
        Stream.of(Operation.values()),
        MathFunction.inFormulas().stream().filter(function -> !function.isComposed()));
  }

  private static double value(WatchedStep step, double a, double b) {
    return step instanceof MathFunction function
        ? function.value(a, b)
        : switch ((Operation) step) {
          case ADD -> a + b;
          case SUBTRACT -> a - b;
          case MULTIPLY -> a * b;
          case DIVIDE -> a / b;
          case NEGATE -> -a;
          case SQUARE -> a * a;
        };
  }

  @ParameterizedTest
  @MethodSource("steps")
  void boundsHoldEveryValue(WatchedStep operation) {
    boolean power = operation.name().equals("POWER");
    Random random = new Random(operation.name().hashCode());
    int finite = 0;
    for (int i = 0; i < 4000; i++) {
      double scale = Math.pow(10, random.nextInt(5) - 2);
      double aLow = scale * random.nextGaussian();
      double aHigh = aLow + scale * random.nextDouble();
      double bLow = power ? random.nextInt(7) - 3 : scale * random.nextGaussian();
      double bHigh = power ? bLow : bLow + scale * random.nextDouble();
      operation.bound(aLow, aHigh, bLow, bHigh, enclosure);
      finite += Double.isFinite(enclosure.high() - enclosure.low()) ? 1 : 0;
      for (int k = 0; k < 20; k++) {
        double a = between(random, aLow, aHigh);
        double value = value(operation, a, between(random, bLow, bHigh));
        if (Double.isFinite(value)) {
          assertThat(value)
              .as("%s of [%s, %s], [%s, %s] at %s", operation, aLow, aHigh, bLow, bHigh, a)
              .isBetween(enclosure.low(), enclosure.high());
        }
      }
    }
    // bounds that always are infinite would hold everything, too
    assertThat(finite).isGreaterThan(1000);
  }

  @ParameterizedTest
  @EnumSource(Table.Method.class)
  void boundsOfTablesAreTheirExtrema(Table.Method method) {
    Random random = new Random(7);
    List<Double> x = List.of(0.0, 1.0, 1.2, 3.0, 3.1, 5.0);
    List<Double> y = List.of(0.0, 2.0, -1.0, 0.5, 4.0, 4.0);
    for (Table.Extrapolation outside : Table.Extrapolation.values()) {
      TableCurve curve = new Table("t", x, y, method, outside).curve();
      for (int i = 0; i < 500; i++) {
        double from = 5 * random.nextDouble();
        double to = from + (5 - from) * random.nextDouble();
        curve.bound(from, to, 0, 0, enclosure);
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k <= 2000; k++) {
          double value = curve.at(from + (to - from) * k / 2000);
          least = Math.min(least, value);
          most = Math.max(most, value);
        }
        // samples 0.0025 apart miss a corner by half of that times the slope, which is 35 at most
        double missed = 0.05;
        assertThat(enclosure.low()).isBetween(least - missed, least);
        assertThat(enclosure.high()).isBetween(most, most + missed);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Table.Method.class)
  void boundsOfMapsHoldEveryValue(Table.Method method) {
    Random random = new Random(8);
    List<Double> z = random.doubles(20, -1, 1).boxed().toList();
    List<Double> x = List.of(0.0, 1.0, 1.2, 3.0, 3.1);
    List<Double> y = List.of(-1.0, 0.0, 0.5, 2.0);
    MapSurface surface = new TableMap("m", x, y, z, method, Table.Extrapolation.LINEAR).surface();
    for (int i = 0; i < 500; i++) {
      double aLow = 4 * random.nextDouble() - 0.5;
      double aHigh = aLow + random.nextDouble();
      double bLow = 4 * random.nextDouble() - 1.5;
      double bHigh = bLow + random.nextDouble();
      surface.bound(aLow, aHigh, bLow, bHigh, enclosure);
      for (int k = 0; k < 50; k++) {
        double value = surface.at(between(random, aLow, aHigh), between(random, bLow, bHigh));
        assertThat(value).isBetween(enclosure.low() - 1e-12, enclosure.high() + 1e-12);
      }
    }
  }
}
