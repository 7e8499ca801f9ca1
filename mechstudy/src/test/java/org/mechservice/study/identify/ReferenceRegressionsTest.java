package org.mechservice.study.identify;

import static java.lang.Math.PI;
import static java.lang.Math.atan;
import static java.lang.Math.cos;
import static java.lang.Math.exp;
import static java.lang.Math.log;
import static java.lang.Math.pow;
import static java.lang.Math.sin;
import static java.util.Objects.requireNonNull;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.Response;

/**
 * The nonlinear regressions of NIST's statistical reference datasets (StRD; the numbers, with their
 * certified values): parameters to a thousandth of their standard deviations, these deviations, and
 * that of the residuals, from both starts.
 *
 * <p>Variables have bounds here and the problems have none. The bounds hold both starts and the
 * certified value, with as much again to either side, and {@link #ROOM} deviations at least. Within
 * them 49 of the 54 fits end at the certified values; {@link #ELSEWHERE} names the others.
 */
class ReferenceRegressionsTest {
  private static final Pattern PARAMETER =
      Pattern.compile("\\s*b\\d+ =\\s+(\\S+)\\s+(\\S+)\\s+(\\S+)\\s+(\\S+)\\s*");
  private static final Pattern DEVIATION =
      Pattern.compile("Residual Standard Deviation:\\s+(\\S+)\\s*");
  private static final Pattern DATA =
      Pattern.compile("\\s*Data\\s+\\(lines\\s+(\\d+) to (\\d+)\\)");

  /** Step of central differences: the cube root of the rounding of formulas. */
  private static final double STEP = 1e-5;

  /** Room of the bounds in deviations, so that each deviation is less than the range. */
  private static final double ROOM = 3;

  /**
   * Relative error of a deviation: a range has up to some 2000 deviations, so a step s of the
   * differences has up to 0.02 of them, and its error s²f‴/6 is some 1e-4 of the derivative where
   * the model bends within a deviation, as that of MGH09 does (9e-5).
   */
  private static final double JACOBIAN = 2e-4;

  /** The data of Lanczos1 are exact to 14 digits: what is left of the residuals is rounding. */
  private static final double ROUNDING = 1e-15;

  /**
   * Fits that end elsewhere, with their starts: Eckerle4 begins where the peak is too wide to be
   * seen, with a peak upside down in reach; the valleys of the others are so narrow and bent that
   * 200 steps do not lead through them, and from its first start MGH10 leaves the domain.
   */
  private static final Set<String> ELSEWHERE =
      Set.of("Eckerle4 1", "Bennett5 2", "MGH10 1", "MGH10 2", "MGH17 1");

  /** A model: parameters from place 1 on, predictors. */
  private interface Model {
    double at(double[] b, double[] x);
  }

  private static final Map<String, Model> MODELS = new TreeMap<>();

  static {
    Model quotient =
        (b, x) ->
            (b[1] + x[0] * (b[2] + x[0] * (b[3] + x[0] * b[4])))
                / (1 + x[0] * (b[5] + x[0] * (b[6] + x[0] * b[7])));
    Model decays =
        (b, x) -> b[1] * exp(-b[2] * x[0]) + b[3] * exp(-b[4] * x[0]) + b[5] * exp(-b[6] * x[0]);
    Model peaks =
        (b, x) ->
            b[1] * exp(-b[2] * x[0])
                + b[3] * exp(-square((x[0] - b[4]) / b[5]))
                + b[6] * exp(-square((x[0] - b[7]) / b[8]));
    Model ultrasonic = (b, x) -> exp(-b[1] * x[0]) / (b[2] + b[3] * x[0]);
    MODELS.put("Bennett5", (b, x) -> b[1] * pow(b[2] + x[0], -1 / b[3]));
    MODELS.put("BoxBOD", (b, x) -> b[1] * (1 - exp(-b[2] * x[0])));
    MODELS.put("Chwirut1", ultrasonic);
    MODELS.put("Chwirut2", ultrasonic);
    MODELS.put("DanWood", (b, x) -> b[1] * pow(x[0], b[2]));
    MODELS.put(
        "ENSO",
        (b, x) ->
            b[1]
                + b[2] * cos(2 * PI * x[0] / 12)
                + b[3] * sin(2 * PI * x[0] / 12)
                + b[5] * cos(2 * PI * x[0] / b[4])
                + b[6] * sin(2 * PI * x[0] / b[4])
                + b[8] * cos(2 * PI * x[0] / b[7])
                + b[9] * sin(2 * PI * x[0] / b[7]));
    MODELS.put("Eckerle4", (b, x) -> b[1] / b[2] * exp(-0.5 * square((x[0] - b[3]) / b[2])));
    MODELS.put("Gauss1", peaks);
    MODELS.put("Gauss2", peaks);
    MODELS.put("Gauss3", peaks);
    MODELS.put("Hahn1", quotient);
    MODELS.put(
        "Kirby2",
        (b, x) -> (b[1] + x[0] * (b[2] + x[0] * b[3])) / (1 + x[0] * (b[4] + x[0] * b[5])));
    MODELS.put("Lanczos1", decays);
    MODELS.put("Lanczos2", decays);
    MODELS.put("Lanczos3", decays);
    MODELS.put("MGH09", (b, x) -> b[1] * x[0] * (x[0] + b[2]) / (x[0] * x[0] + x[0] * b[3] + b[4]));
    MODELS.put("MGH10", (b, x) -> b[1] * exp(b[2] / (x[0] + b[3])));
    MODELS.put("MGH17", (b, x) -> b[1] + b[2] * exp(-x[0] * b[4]) + b[3] * exp(-x[0] * b[5]));
    MODELS.put("Misra1a", (b, x) -> b[1] * (1 - exp(-b[2] * x[0])));
    MODELS.put("Misra1b", (b, x) -> b[1] * (1 - pow(1 + b[2] * x[0] / 2, -2)));
    MODELS.put("Misra1c", (b, x) -> b[1] * (1 - pow(1 + 2 * b[2] * x[0], -0.5)));
    MODELS.put("Misra1d", (b, x) -> b[1] * b[2] * x[0] / (1 + b[2] * x[0]));
    MODELS.put("Nelson", (b, x) -> b[1] - b[2] * x[0] * exp(-b[3] * x[1]));
    MODELS.put("Rat42", (b, x) -> b[1] / (1 + exp(b[2] - b[3] * x[0])));
    MODELS.put("Rat43", (b, x) -> b[1] / pow(1 + exp(b[2] - b[3] * x[0]), 1 / b[4]));
    MODELS.put("Roszman1", (b, x) -> b[1] - b[2] * x[0] - atan(b[3] / (x[0] - b[4])) / PI);
    MODELS.put("Thurber", quotient);
  }

  private static double square(double x) {
    return x * x;
  }

  /** A dataset: for each parameter both starts, the certified value and its deviation. */
  private record Problem(List<double[]> parameters, double deviation, List<double[]> rows) {
    static Problem read(String name) throws Exception {
      List<String> lines;
      try (InputStream in =
          ReferenceRegressionsTest.class.getResourceAsStream("/nist-strd/" + name + ".dat")) {
        lines = new String(in.readAllBytes(), StandardCharsets.US_ASCII).lines().toList();
      }
      List<double[]> parameters = new ArrayList<>();
      double deviation = Double.NaN;
      int first = 0;
      int last = 0;
      for (String line : lines) {
        Matcher parameter = PARAMETER.matcher(line);
        Matcher residual = DEVIATION.matcher(line);
        Matcher data = DATA.matcher(line);
        if (parameter.matches()) {
          double[] values = new double[4];
          for (int i = 0; i < 4; i++) {
            values[i] = Double.parseDouble(parameter.group(i + 1));
          }
          parameters.add(values);
        } else if (residual.matches()) {
          deviation = Double.parseDouble(residual.group(1));
        } else if (data.matches()) {
          first = Integer.parseInt(data.group(1));
          last = Integer.parseInt(data.group(2));
        }
      }
      List<double[]> rows = new ArrayList<>();
      for (String line : lines.subList(first - 1, last)) {
        String[] cells = line.strip().split("\\s+", -1);
        double[] row = new double[cells.length];
        for (int i = 0; i < row.length; i++) {
          row[i] = Double.parseDouble(cells[i]);
        }
        if (name.equals("Nelson")) {
          row[0] = log(row[0]);
        }
        rows.add(row);
      }
      return new Problem(parameters, deviation, rows);
    }

    /**
     * @param room at least to either side, in standard deviations
     */
    List<DesignVariable> from(int start, double room) {
      List<DesignVariable> variables = new ArrayList<>();
      for (double[] values : parameters) {
        double low = Math.min(values[2], Math.min(values[0], values[1]));
        double high = Math.max(values[2], Math.max(values[0], values[1]));
        double wide = Math.max(high - low, room * values[3]);
        variables.add(
            new DesignVariable(
                "b" + (variables.size() + 1), low - wide, high + wide, values[start]));
      }
      return variables;
    }

    Response residuals(Model model) {
      return p -> {
        double[] b = new double[p.length + 1];
        System.arraycopy(p, 0, b, 1, p.length);
        double[] r = new double[rows.size()];
        for (int i = 0; i < r.length; i++) {
          double[] row = rows.get(i);
          double[] x = Arrays.copyOfRange(row, 1, row.length);
          r[i] = model.at(b, x) - row[0];
        }
        return r;
      };
    }
  }

  @TestFactory
  List<DynamicTest> certifiedValuesAreFoundFromBothStarts() {
    List<DynamicTest> tests = new ArrayList<>();
    for (Map.Entry<String, Model> each : MODELS.entrySet()) {
      String name = each.getKey();
      for (int start = 0; start < 2; start++) {
        if (ELSEWHERE.contains(name + " " + (start + 1))) {
          continue;
        }
        int from = start;
        tests.add(
            DynamicTest.dynamicTest(
                name + " from start " + (start + 1), () -> compare(name, each.getValue(), from)));
      }
    }
    return tests;
  }

  private static void compare(String name, Model model, int start) throws Exception {
    Problem problem = Problem.read(name);
    Identification found =
        Identification.of(problem.from(start, ROOM), problem.residuals(model), STEP);
    double[] deviations = found.deviations();
    for (int k = 0; k < deviations.length; k++) {
      double[] certified = problem.parameters().get(k);
      assertThat(found.values()[k])
          .as("b%d", k + 1)
          .isCloseTo(certified[2], within(1e-3 * certified[3] + 1e-6 * Math.abs(certified[2])));
      assertDeviation(deviations[k], certified[3], problem, "b" + (k + 1));
    }
    assertThat(found.noise())
        .isCloseTo(problem.deviation(), within(1e-6 * problem.deviation() + ROUNDING));
  }

  private static void assertDeviation(
      double found, double certified, Problem problem, String parameter) {
    double part = JACOBIAN + ROUNDING / problem.deviation();
    assertThat(found)
        .as("deviation of %s", parameter)
        .isCloseTo(certified, within(part * certified));
  }

  /**
   * The range of b6 of Gauss3 about its starts and its certified value is 0.7 of its deviation: the
   * data do not determine it there. The directions in which it lies have small parts of the other
   * parameters, whose deviations stay the certified ones.
   */
  @Test
  void otherDeviationsHoldWhereTheRangeOfOneIsLessThanItsDeviation() throws Exception {
    Problem problem = Problem.read("Gauss3");
    Identification found =
        Identification.of(
            problem.from(0, 0), problem.residuals(requireNonNull(MODELS.get("Gauss3"))), STEP);
    for (int k = 0; k < found.values().length; k++) {
      if (k == 5) {
        assertThat(found.deviations()[k]).isInfinite();
      } else {
        double certified = problem.parameters().get(k)[3];
        assertDeviation(found.deviations()[k], certified, problem, "b" + (k + 1));
      }
    }
  }
}
