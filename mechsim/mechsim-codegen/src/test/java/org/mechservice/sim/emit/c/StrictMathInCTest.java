package org.mechservice.sim.emit.c;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.spatial.CubicCurve;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.Powers;
import org.mechservice.solver.spatial.SinCos;
import org.mechservice.solver.spatial.TouchingPoint;

/** The functions of mech_math.c have the bits of those that models call in Java. */
class StrictMathInCTest {
  private static final long SEED = 20261123;
  private static final int FEW = 20_000;
  private static final int MANY = 2_000_000;

  /** A road of cubics with hollows and bumps of all widths. */
  private static final double[] CURVE =
      new Table(
              "road",
              List.of(-2.0, -1.0, -0.9, -0.2, 0.0, 0.01, 0.5, 0.7, 1.5, 3.0),
              List.of(0.0, 0.5, 0.4, -0.3, 0.2, 0.1, 0.0, 0.6, -0.5, 0.0),
              Table.Method.AKIMA,
              Table.Extrapolation.LINEAR)
          .curve()
          .row();

  private static final Map<String, DoubleUnaryOperator> UNARY = new LinkedHashMap<>();
  private static final Map<String, DoubleBinaryOperator> BINARY = new LinkedHashMap<>();

  static {
    UNARY.put("mech_abs", Math::abs);
    UNARY.put("mech_sin", StrictMath::sin);
    UNARY.put("mech_cos", StrictMath::cos);
    UNARY.put("mech_sine", SinCos::sine);
    UNARY.put("mech_cosine", SinCos::cosine);
    UNARY.put("mech_asin", StrictMath::asin);
    UNARY.put("mech_acos", StrictMath::acos);
    UNARY.put("mech_atan", StrictMath::atan);
    UNARY.put("mech_exp", StrictMath::exp);
    UNARY.put("mech_log", StrictMath::log);
    UNARY.put("mech_sinh", StrictMath::sinh);
    UNARY.put("mech_cosh", StrictMath::cosh);
    UNARY.put("mech_tanh", StrictMath::tanh);
    UNARY.put("mech_signum", Math::signum);
    UNARY.put("mech_floor", Math::floor);
    UNARY.put("sine", x -> sinCos(x, 0));
    UNARY.put("cosine", x -> sinCos(x, 1));
    BINARY.put("mech_atan2", StrictMath::atan2);
    BINARY.put("mech_hypot", StrictMath::hypot);
    BINARY.put("mech_min", Math::min);
    BINARY.put("mech_max", Math::max);
    BINARY.put("mech_power", Powers::power);
    BINARY.put("mech_product", Piecewise::product);
    BINARY.put("closest", (x, z) -> CubicCurve.closest(CURVE, 0, CURVE.length, x, z));
    BINARY.put("touch", (a, b) -> TouchingPoint.angle(1.25, a, b, 1, 0));
    BINARY.put("touchRoughly", (a, b) -> TouchingPoint.angle(1.25, a, b, 1, 1e-6));
    BINARY.put("pick", (a, b) -> Piecewise.pick(a, b, a, 2.5));
    BINARY.put("choose", (a, b) -> Piecewise.choose(a, b, a, 2.5));
  }

  /** Numbers at which algorithms change, and the ends of the range. */
  private static final double[] SPECIAL = {
    0.0,
    -0.0,
    1,
    -1,
    0.5,
    -0.5,
    2,
    -2,
    3,
    -3,
    64,
    64.5,
    -64.5,
    65,
    0.6875,
    1.1875,
    2.4375,
    Double.MIN_VALUE,
    -Double.MIN_VALUE,
    Double.MIN_NORMAL,
    Double.MAX_VALUE,
    -Double.MAX_VALUE,
    Double.POSITIVE_INFINITY,
    Double.NEGATIVE_INFINITY,
    Double.NaN,
    Math.PI,
    -Math.PI,
    Math.PI / 2,
    Math.PI / 4,
    -Math.PI / 4,
    3 * Math.PI / 4,
    1e4,
    -1e4,
    1e5,
    0x1.921fb54442d18p19,
    0x1.921fb54442d18p20,
    6381956970095103.0 * 0x1p797,
    709.782712893384,
    709.7827128933841,
    -745.1332191019411,
    -745.1332191019412,
    -708.4,
    710.4758600739439,
    710.475860073944,
    22,
    -22,
    56 * 0.6931471805599453,
    0.34657359027997264,
    1.0397207708399179,
    0x1p-28,
    0x1p-27,
    0x1p-54,
    0x1p-55,
    0x1p-1022,
    0x1p53,
    0x1p53 - 1,
    0x1p53 + 2,
    0x1p500,
    0x1p-500,
    0x1p-1060,
    0x1.fffffffffffffp-1
  };

  @TempDir private Path folder = Path.of("");

  private static double sinCos(double angle, int index) {
    double[] values = new double[2];
    SinCos.sinCos(angle, values, 0);
    return values[index];
  }

  /** A program that reads pairs of numbers and writes the function that its argument names. */
  private static String program() {
    List<String> lines = new ArrayList<>();
    lines.add("#include \"mech_math.h\"");
    lines.add("#include <stdio.h>");
    lines.add("#include <string.h>");
    lines.add("static double two[2];");
    lines.add("static double sine(double x) { mech_sin_cos(x, two); return two[0]; }");
    lines.add("static double cosine(double x) { mech_sin_cos(x, two); return two[1]; }");
    lines.add("static double choose(double a, double b) { return mech_choose(a, b, a, 2.5); }");
    String numbers =
        Arrays.stream(CURVE).mapToObj(Double::toHexString).collect(Collectors.joining(", "));
    lines.add("static const double ROAD[] = {" + numbers + "};");
    lines.add("enum { N = sizeof ROAD / sizeof ROAD[0] };");
    lines.add("static double closest(double x, double z) {");
    lines.add("  return mech_closest(ROAD, N, x, z);");
    lines.add("}");
    lines.add("static double touch(double a, double b) {");
    lines.add("  return mech_touch(1.25, a, b, 1.0, 0.0);");
    lines.add("}");
    lines.add("static double touchRoughly(double a, double b) {");
    lines.add("  return mech_touch(1.25, a, b, 1.0, 1e-6);");
    lines.add("}");
    lines.add("static double pick(double a, double b) { return mech_pick(a, b, a, 2.5); }");
    lines.add("int main(int count, char **names) {");
    lines.add("  double x[2], y = 0.0;");
    lines.add("  while (count > 1 && fread(x, sizeof x, 1, stdin) == 1) {");
    for (String name : UNARY.keySet()) {
      lines.add("    if (strcmp(names[1], \"" + name + "\") == 0) y = " + name + "(x[0]);");
    }
    for (String name : BINARY.keySet()) {
      lines.add("    if (strcmp(names[1], \"" + name + "\") == 0) y = " + name + "(x[0], x[1]);");
    }
    lines.add("    fwrite(&y, sizeof y, 1, stdout);");
    lines.add("  }");
    lines.add("  return 0;");
    lines.add("}");
    return String.join("\n", lines) + "\n";
  }

  private Path compiled(List<String> options) throws IOException {
    Path driver = folder.resolve("driver.c");
    Files.writeString(driver, program());
    CCode.resource(folder, "mech_math.h");
    return CCode.compiled(folder, options, List.of(driver, CCode.resource(folder, "mech_math.c")));
  }

  /** Pairs: all pairs of special numbers, all bit patterns, all sizes that occur in mechanics. */
  private static double[] pairs(int count) {
    Random random = new Random(SEED);
    double[] pairs = new double[2 * count];
    int at = 0;
    for (double first : SPECIAL) {
      for (double second : SPECIAL) {
        pairs[at++] = first;
        pairs[at++] = second;
      }
    }
    for (; at < pairs.length; at += 2) {
      pairs[at] = number(random);
      boolean near = random.nextInt(3) == 0;
      pairs[at + 1] = near ? pairs[at] * (0.5 + random.nextDouble()) : number(random);
    }
    return pairs;
  }

  private static double number(Random random) {
    double sign = random.nextBoolean() ? 1 : -1;
    double unit = random.nextDouble();
    return switch (random.nextInt(10)) {
      case 0 -> Double.longBitsToDouble(random.nextLong());
      case 1 -> sign * unit;
      case 2 -> sign * 10 * unit;
      case 3 -> sign * 1e4 * unit;
      case 4 -> sign * 800 * unit;
      case 5 -> sign * unit * Math.scalb(1.0, random.nextInt(80) - 40);
      case 6 -> Math.PI / 2 * (random.nextInt(4000) - 2000) * (1 + 4e-16 * (unit - 0.5));
      case 7 -> sign * random.nextInt(140) / 2;
      case 8 -> sign * (1 + unit * Math.scalb(1.0, -random.nextInt(52)));
      default -> Double.longBitsToDouble(random.nextLong() & 0x800fffffffffffffL);
    };
  }

  private static void requireEqualBits(Path program, int count) throws IOException {
    double[] pairs = pairs(count);
    for (Map.Entry<String, DoubleUnaryOperator> function : UNARY.entrySet()) {
      DoubleUnaryOperator of = function.getValue();
      requireEqualBits(program, function.getKey(), (x, y) -> of.applyAsDouble(x), pairs);
    }
    for (Map.Entry<String, DoubleBinaryOperator> function : BINARY.entrySet()) {
      requireEqualBits(program, function.getKey(), function.getValue(), pairs);
    }
  }

  private static void requireEqualBits(
      Path program, String name, DoubleBinaryOperator function, double[] pairs) throws IOException {
    double[] actual = CCode.run(program, List.of(name), pairs);
    assertThat(actual).as(name).hasSize(pairs.length / 2);
    List<String> different = new ArrayList<>();
    for (int i = 0; i < actual.length; i++) {
      double x = pairs[2 * i];
      double y = pairs[2 * i + 1];
      double expected = function.applyAsDouble(x, y);
      if (Double.doubleToLongBits(actual[i]) != Double.doubleToLongBits(expected)) {
        different.add(name + "(" + x + ", " + y + ") = " + actual[i] + ", Java " + expected);
      }
    }
    assertThat(different.stream().limit(5)).as("%d differ", different.size()).isEmpty();
  }

  @Test
  void everyFunctionHasTheBitsOfJava() throws IOException {
    requireEqualBits(compiled(CCode.FAST), FEW);
  }

  @Test
  void noFunctionHasUndefinedBehaviour() throws IOException {
    assumeTrue(CCode.hasSanitizers(folder), "this C compiler has no sanitizers");
    requireEqualBits(compiled(CCode.CHECKED), FEW / 4);
  }

  @Tag("soak")
  @Test
  void everyFunctionHasTheBitsOfJavaForTwoMillionArguments() throws IOException {
    requireEqualBits(compiled(CCode.FAST), MANY);
  }
}
