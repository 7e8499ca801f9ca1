package org.mechservice.study.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.library.MechModel;

/** Aims with corners: best approximations, whose errors are known, and a linkage. */
class MinimaxTest {
  private static final int ROWS = 201;

  /**
   * The error of a polynomial without constant for the exponential function from 0 to 1, in rows.
   */
  private static double[] errors(double[] coefficients) {
    return IntStream.range(0, ROWS)
        .mapToDouble(
            row -> {
              double t = row / (ROWS - 1.0);
              double value = 0;
              for (int k = coefficients.length - 1; k >= 0; k--) {
                value = (value + coefficients[k]) * t;
              }
              return Math.exp(t) - value;
            })
        .toArray();
  }

  /** Quantities: the largest error, the least one, then the rows twice. */
  private static class Errors implements Composition {
    @Override
    public List<Extreme> extremes() {
      return List.of(
          new Extreme(0, true, 2, 2 + ROWS), new Extreme(1, false, 2 + ROWS, 2 + 2 * ROWS));
    }

    @Override
    public int count() {
      return 2;
    }

    @Override
    public double[] quantities(double[] point) {
      double[] errors = errors(point);
      double[] all = new double[2 + 2 * ROWS];
      all[0] = IntStream.range(0, ROWS).mapToDouble(i -> errors[i]).max().orElseThrow();
      all[1] = IntStream.range(0, ROWS).mapToDouble(i -> errors[i]).min().orElseThrow();
      System.arraycopy(errors, 0, all, 2, ROWS);
      System.arraycopy(errors, 0, all, 2 + ROWS, ROWS);
      return all;
    }

    @Override
    public double[] aims(double[] quantities, double[] point) {
      // the constant of the polynomial puts the errors about zero
      return new double[] {(quantities[0] - quantities[1]) / 2};
    }
  }

  private static DesignProblem approximation(int degree) {
    Errors made = new Errors();
    return new DesignProblem(
        IntStream.rangeClosed(1, degree)
            .mapToObj(k -> new DesignVariable("c" + k, -3, 3, 0.2))
            .toList(),
        List.of(new Aim(Aim.Kind.MINIMISE, "error")),
        point -> made.aims(made.quantities(point), point),
        Optional.empty(),
        Optional.of(made));
  }

  private static OptimiserSettings settings(Method method) {
    return new OptimiserSettings(method, 1, 1, 4000, 1e-5, OptionalDouble.empty(), 1);
  }

  /**
   * The errors of the best polynomials in these rows, from a linear program of their coefficients
   * (SciPy's HiGHS); that of the best line is (1 - m + m ln m)/2 with m = e - 1 between them.
   */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void bestApproximationsAreFound(int degree) throws Exception {
    double[] known = {0, 0.10593266259151296, 0.008755975606715927, 0.000544723606263342};
    assertThat(known[1])
        .isCloseTo((2 - Math.E + (Math.E - 1) * Math.log(Math.E - 1)) / 2, within(1e-6));
    Optimum optimum = Optimiser.minimise(approximation(degree), settings(Method.SQP));
    assertThat(optimum.isLocal()).contains(true);
    assertThat(optimum.best().objective()).isCloseTo(known[degree], within(1e-8));
  }

  @Test
  void cornerThatIsNoOptimumIsTold() throws Exception {
    Optimum optimum =
        Optimiser.minimise(
            approximation(2),
            new OptimiserSettings(Method.BOBYQA, 1, 1, 40, 1e-5, OptionalDouble.empty(), 1));
    assertThat(optimum.isLocal()).contains(false);
  }

  /** The slope of the best line again, with more to it than the error. */
  private static DesignProblem line(List<Aim> aims, UnaryOperator<double[]> others) {
    Composition made =
        new Errors() {
          @Override
          public double[] aims(double[] quantities, double[] point) {
            double error = super.aims(quantities, point)[0];
            return others.apply(new double[] {error, point[0]});
          }
        };
    return new DesignProblem(
        List.of(new DesignVariable("c1", -3, 3, Math.E - 1)),
        aims,
        point -> made.aims(made.quantities(point), point),
        Optional.empty(),
        Optional.of(made));
  }

  /**
   * At the corner of the error, where its slopes are −0.23 and 0.27, a cost of 0.4 for each unit of
   * the variable promises something to the left: 0.17 of 0.006 in the variable.
   */
  @Test
  void costsOfVariablesThemselvesCount() throws Exception {
    DesignProblem problem =
        line(
            List.of(new Aim(Aim.Kind.MINIMISE, "error + 0.4*c1")),
            values -> new double[] {values[0] + 0.4 * values[1]});
    Trials trials = new Trials(problem, 1, 100, OptionalDouble.empty());
    Minimax minimax = new Minimax(problem, problem.composition().orElseThrow(), trials, 1e-5);
    double size = 0.10593 + 0.4 * (Math.E - 1);
    assertThat(minimax.promise(problem.start()).orElseThrow())
        .isCloseTo(0.17 * 0.006 / size, within(0.01 * 0.006 / size));
  }

  /** Constraints hold at the end, however heavy they have to be. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-2, 1, 1e4})
  void constraintsHold(double scale) throws Exception {
    DesignProblem problem =
        line(
            List.of(
                new Aim(Aim.Kind.MINIMISE, "error"),
                new Aim(Aim.Kind.AT_MOST_ZERO, "c1 <= 1.5", scale)),
            values -> new double[] {values[0], values[1] - 1.5});
    Trials trials = new Trials(problem, 1, 400, OptionalDouble.empty());
    Minimax minimax = new Minimax(problem, problem.composition().orElseThrow(), trials, 1e-5);
    minimax.minimise(problem.start());
    Trial best = trials.best().orElseThrow();
    assertThat(best.isFeasible()).isTrue();
    // as far beyond as a constraint may be by its scale
    assertThat(best.point()[0]).isCloseTo(1.5, within(1e-7 + 2e-6 * scale));
    double[] there = {problem.variables().get(0).part(1.5)};
    assertThat(minimax.promise(there).orElseThrow()).isLessThan(1e-6 * (1 + scale));
  }

  /**
   * A four-bar of Hoecken: the coupler point draws a line of 3.8 m for half a turn of the crank.
   * All that a smooth method finds has three to six times the height of the best (differential
   * evolution with SLSQP over an epigraph, in SciPy, on the closed form: 0.0037388).
   */
  @Test
  void straightLineIsAsStraightAsItCanBe() throws Exception {
    List<DesignVariable> variables =
        List.of(
            new DesignVariable("b", 2, 3, 2.3),
            new DesignVariable("c", 2, 3, 2.6),
            new DesignVariable("d", 1.5, 2.5, 2.1),
            new DesignVariable("u", 4, 6, 4.6),
            new DesignVariable("w", -0.5, 0.5, 0.2));
    ModelDesign design =
        new ModelDesign(MechModel.of("line.xml", straightLine()), variables)
            .minimise("max(y) - min(y)")
            .subjectTo("max(x) - min(x) >= 3.8");
    Optimum optimum = Optimiser.minimise(design.problem(), settings(Method.AUTO));
    assertThat(optimum.best().isFeasible()).isTrue();
    assertThat(optimum.best().objective()).isCloseTo(0.0037388, within(1e-6));
    assertThat(optimum.isLocal()).contains(true);
  }

  private static String straightLine() {
    return "<MechML><MBSsimulation><kinematic>"
        + "<timeSet tini='0' tend='3.141592653589793' tstep='0.05235987755982988'/>"
        + "</kinematic></MBSsimulation><MBSmodel name='Line' massUnits='kg' lengthUnits='m'"
        + " silence='no-gravity'><Parameters>"
        + IntStream.range(0, 5)
            .mapToObj(
                k ->
                    "<parameter name='%s' value='%s' unit='m'/>"
                        .formatted("bcduw".charAt(k), new double[] {2.3, 2.6, 2.1, 4.6, 0.2}[k]))
            .collect(Collectors.joining())
        + "</Parameters><Bodies>"
        + body("frame", "<point name='d' x='d' y='0' z='0'/>")
        + body("crank", "<point name='p' x='1' y='0' z='0'/>")
        + body("coupler", "<point name='q' x='b' y='0' z='0'/><point name='e' x='u' y='w' z='0'/>")
        + body("rocker", "<point name='q' x='c' y='0' z='0'/>")
        + "</Bodies><Joints>"
        + joint("shaft", "frame", "o", "crank", "o")
        + joint("pin", "crank", "p", "coupler", "o")
        + joint("pivot", "frame", "d", "rocker", "o")
        + joint("knee", "coupler", "q", "rocker", "q")
        + "</Joints><Outputs><output name='x' expression='coupler.e.x' unit='m'/>"
        + "<output name='y' expression='coupler.e.y' unit='m'/></Outputs><topology>"
        + "<root name='frame'/><relCoorVals><jointVal name='pin' posVals='-2.2'/>"
        + "<jointVal name='pivot' posVals='1.6'/><jointVal name='shaft' driven='PI/2+t'/>"
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static String body(String name, String points) {
    return "<body name='"
        + name
        + "'><point name='o' x='0' y='0' z='0'/>"
        + points
        + "<vector name='z' vx='0' vy='0' vz='1'/>"
        + (name.equals("frame") ? "" : "<mass value='1'/>")
        + "</body>";
  }

  private static String joint(
      String name, String body1, String point1, String body2, String point2) {
    return ("<joint name='%s' type='R'><body1 name='%s' point='%s' vector='z'/>"
            + "<body2 name='%s' point='%s' vector='z'/></joint>")
        .formatted(name, body1, point1, body2, point2);
  }
}
