package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The scenes with independent reference solutions move as those do. */
class SceneIT {
  private static final Path EXAMPLES = WorkingTree.TOP.resolve("examples");

  /** Model, integrator, relative tolerance, end and distance of rows in s, bound of the error. */
  private static final String SCENES =
      """
      pendulum/pendulum.xml, DE, 1e-8, 3, 0.01, 1e-5
      pendulum/pendulum.xml, ode113, 1e-8, 3, 0.01, 1e-5
      five-point-suspension/five-point-suspension.xml, DE, 1e-8, 2, 0.01, 1e-5
      five-point-suspension/five-point-suspension.xml, ode113, 1e-8, 2, 0.01, 1e-5
      driver/driver-c0.xml, ode113, 1e-8, 0.25, 0.005, 1e-5
      driver/driver-ck100.xml, ode15sR, 1e-8, 0.25, 0.005, 1e-5
      driver/driver-free-c0.xml, ode113, 1e-8, 0.25, 0.005, 1e-5
      driver/driver-free-ck100.xml, ode15sR, 1e-8, 0.25, 0.005, 1e-5
      benchmarks/A01_simple_pendulum.xml, ode113, 1e-8, 10, 0.01, 1e-5
      benchmarks/A03_andrews.xml, ode113, 1e-8, 0.05, 0.001, 1e-5
      benchmarks/A05_flyball.xml, ode15sR, 1e-8, 10, 0.01, 1e-5
      benchmarks/double_pendulum.xml, ode113, 1e-8, 10, 0.01, 1e-5
      benchmarks/slider_crank_planar.xml, ode113, 1e-8, 5, 0.01, 1e-5
      benchmarks/dzhanibekov.xml, ode113, 1e-10, 5, 0.01, 1e-7
      extremes/fourbar_redundant.xml, ode113, 1e-8, 5, 0.01, 1e-5
      extremes/massratio_1e8_root.xml, ode113, 1e-10, 2, 0.01, 1e-6
      extremes/near_massless_0.xml, ode113, 1e-8, 2, 0.01, 1e-5
      extremes/gimbal_q2_0.4.xml, ode113, 1e-8, 1, 0.01, 1e-5
      extremes/stiff_1e9_c0.xml, ode113, 1e-8, 0.1, 1e-4, 1e-6
      extremes/stiff_1e9_c0.xml, ode15s, 1e-8, 0.1, 1e-4, 1e-6
      extremes/stiff_1e9_c1e5.xml, ode15sR, 1e-8, 0.1, 1e-4, 1e-6
      extremes/high_spin_1e5_sym.xml, ode113, 1e-10, 0.01, 1e-4, 1e-6
      """;

  /** Models whose motion other tests check, by laws of mechanics or in a second way. */
  private static final List<String> JUDGED_BY_LAWS =
      List.of(
          "benchmarks/bouncing_ball.xml",
          "bicycle/bicycle.xml",
          "counterbalance/counterbalance.xml",
          "driver/variants/driver-c0-elements.xml",
          "driver/variants/driver-ck100-elements.xml",
          "five-point-suspension/variants/elements.xml",
          "four-bar/four-bar.xml",
          "four-bar/long-form.xml",
          "pendulum/variants/branching.xml",
          "pendulum/variants/cart.xml",
          "pendulum/variants/millimetre.xml",
          "pendulum/variants/ode113.xml",
          "sampled-arm/arm.xml",
          "gearbox/gearbox.xml",
          "crane/crane.xml",
          "half-car/half-car.xml",
          "half-car/seat.xml",
          "walker/walker.xml",
          "sweep/seat.xml");

  /** Moments of inertia of the body of benchmarks/dzhanibekov.xml, kg m^2. */
  private static final double[] MIDDLE_AXIS_BODY = {1, 2, 3};

  @TempDir private Path directory;

  static Stream<Arguments> scenes() {
    return SCENES.lines().map(line -> Arguments.of((Object[]) line.split(", ")));
  }

  private ResultRows simulate(String model, String... options) {
    Path rows = directory.resolve("r.csv");
    Mechanic.simulate(EXAMPLES.resolve(model), rows, options).orFail();
    return ResultRows.read(rows);
  }

  /**
   * Bounds are a thousand times the relative tolerance, what integrators may be off by default,
   * where the scene's own conditions ask for nothing else: ten times that for masses of 1 and 1e8,
   * a tenth or less for stiff springs and spins. The pendulum is chaotic: compared up to 3 s.
   */
  @ParameterizedTest
  @MethodSource("scenes")
  void movesAsItsReference(
      String model, String integrator, String rtol, double tLast, String tStep, double bound)
      throws IOException {
    String atol = Double.toString(Double.parseDouble(rtol) / 100);
    String tEnd = Double.toString(tLast);
    ResultRows results =
        simulate(
            model,
            "--integrator",
            integrator,
            "--rtol",
            rtol,
            "--atol",
            atol,
            "--t-step",
            tStep,
            "--t-end",
            tEnd,
            "--quiet");
    double error =
        ReferenceSolution.of(EXAMPLES.resolve(model)).orElseThrow().errorOf(results, tLast);
    assertThat(error).isLessThan(bound);
  }

  /**
   * Elements push only, the dampers of the classes can pull: the two motions part at the first such
   * instant. Two formulations with two integrators have the same motion of elements, as near as the
   * classes have to their reference.
   */
  @ParameterizedTest
  @CsvSource({"c0", "ck100"})
  void driverOfElementsIsOnlyPushedAndMovesOneWay(String damping) throws IOException {
    String model = "driver/variants/driver-" + damping + "-elements.xml";
    String[] common = {"--rtol", "1e-8", "--atol", "1e-10", "--t-step", "0.005", "--quiet"};
    ResultRows explicit =
        simulate(model, with(common, "--formulation", "DTR", "--integrator", "ode15s"));
    ResultRows implicit =
        simulate(model, with(common, "--formulation", "RR-JF", "--integrator", "ode15sR"));
    assertThat(explicit.distanceTo(implicit, Double.MAX_VALUE)).isLessThan(1e-5);
    ResultRows forces = simulate(model, with(common, "--columns", "forces"));
    for (String belt : List.of("lap belt L", "lap belt R", "shoulder belt upper")) {
      assertThat(Arrays.stream(forces.column("\"" + belt + ".tension\"")).min().orElseThrow())
          .isGreaterThanOrEqualTo(0);
    }
    for (String seat : List.of("seat cushion L", "seat cushion R", "seat back")) {
      assertThat(Arrays.stream(forces.column("\"" + seat + ".normal\"")).min().orElseThrow())
          .isGreaterThanOrEqualTo(0);
    }
  }

  private static String[] with(String[] common, String... more) {
    return Stream.concat(Arrays.stream(common), Arrays.stream(more)).toArray(String[]::new);
  }

  /**
   * Its contact touches the sloping step with its surface, along the normal there; that of the
   * class is a point with an offset, and pushes upwards: the speeds differ by some mm/s for some
   * milliseconds.
   */
  @Test
  void suspensionOfElementsMovesAsThatOfClassesToTheLeanOfItsContact() throws IOException {
    ResultRows results =
        simulate(
            "five-point-suspension/variants/elements.xml",
            "--integrator",
            "ode113",
            "--rtol",
            "1e-8",
            "--atol",
            "1e-10",
            "--quiet");
    Path classes = EXAMPLES.resolve("five-point-suspension/five-point-suspension.xml");
    double difference = ReferenceSolution.of(classes).orElseThrow().errorOf(results, 2);
    assertThat(difference).isLessThan(1e-5);
  }

  static List<String> judgedByLaws() {
    return JUDGED_BY_LAWS;
  }

  @ParameterizedTest
  @MethodSource("judgedByLaws")
  void othersAreCheckedAndRunToTheirEnd(String model) {
    // The four hinges of a plane four-bar say three things twice.
    assertThat(Mechanic.check(EXAMPLES.resolve(model)).orFail().out())
        .contains(
            model.matches("(four-bar|counterbalance)/.*") ? "S-090 3 equations" : "Warnings: none");
    // Modes are a row each; other results have one for each time.
    assertThat(simulate(model, "--quiet").rows())
        .hasSizeGreaterThan(model.startsWith("bicycle/") ? 8 : 10);
  }

  /** One scene is checked with a warning: its equations repeat each other. */
  @ParameterizedTest
  @MethodSource("scenes")
  void isChecked(String model) {
    String out = Mechanic.check(EXAMPLES.resolve(model)).orFail().out();
    if (model.contains("redundant")) {
      assertThat(out).contains("S-090");
    } else {
      assertThat(out).contains("Warnings: none");
    }
  }

  /**
   * The scenes of the elements and the extreme scenes have tests of their own; those of studies,
   * optimisation and the how-tos are run by the commands of their pages.
   */
  @Test
  void noExampleIsLeftOut() throws IOException {
    Set<String> known = new TreeSet<>(JUDGED_BY_LAWS);
    SCENES.lines().forEach(line -> known.add(line.split(",", -1)[0]));
    try (Stream<Path> files = Files.walk(EXAMPLES)) {
      assertThat(
              files
                  .map(file -> EXAMPLES.relativize(file).toString())
                  .filter(file -> file.matches("[a-z].*/.*\\.xml"))
                  .filter(
                      file ->
                          !file.matches("(elements|extremes|how-to|optimise|study|target|src)/.*")))
          .isSubsetOf(known);
    }
  }

  private Report report(String model, String... options) {
    String[] words = Arrays.copyOf(options, options.length + 3);
    words[options.length] = "simulate";
    words[options.length + 1] = EXAMPLES.resolve(model).toString();
    words[options.length + 2] = "--json";
    Collections.rotate(Arrays.asList(words), 3);
    return Report.printedBy(Mechanic.mech(words));
  }

  /** The flips amplify rounding, energy and angular momentum stay. */
  @Test
  void bodyTurningAboutItsMiddleAxisKeepsEnergyAndAngularMomentum() {
    String model = "benchmarks/dzhanibekov.xml";
    ResultRows results =
        simulate(
            model,
            "--rtol",
            "1e-10",
            "--atol",
            "1e-10",
            "--columns",
            "joints,bodies,energy",
            "--quiet");
    double[] energy = results.column("energy.kinetic");
    double[] moment = angularMomentum(results);
    assertThat(energy.length).isGreaterThan(100);
    for (int i = 1; i < energy.length; i++) {
      assertThat(energy[i] / energy[0]).isCloseTo(1, within(1e-9));
      assertThat(moment[i] / moment[0]).isCloseTo(1, within(1e-9));
    }
  }

  /** Returns |L| at each time: inertia 1, 2, 3 kg m^2 about the body's axes. */
  private static double[] angularMomentum(ResultRows results) {
    String body =
        results.columns().stream().filter(c -> c.endsWith(".wx")).findFirst().orElseThrow();
    String name = body.substring(0, body.length() - 3);
    double[][] e = new double[4][];
    for (int i = 0; i < 4; i++) {
      e[i] = results.column(name + ".e" + i);
    }
    double[][] w = {
      results.column(name + ".wx"), results.column(name + ".wy"), results.column(name + ".wz")
    };
    double[] moments = new double[w[0].length];
    for (int k = 0; k < moments.length; k++) {
      double sum = 0;
      double[][] turn = rotation(e[0][k], e[1][k], e[2][k], e[3][k]);
      for (int i = 0; i < 3; i++) {
        double rate = turn[0][i] * w[0][k] + turn[1][i] * w[1][k] + turn[2][i] * w[2][k];
        sum += Math.pow(MIDDLE_AXIS_BODY[i] * rate, 2);
      }
      moments[k] = Math.sqrt(sum);
    }
    return moments;
  }

  /** Returns the matrix of Euler parameters, from body to world. */
  private static double[][] rotation(double a, double b, double c, double d) {
    return new double[][] {
      {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
      {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
      {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}
    };
  }

  @Test
  void fastRotorKeepsItsEulerParametersNormal() {
    ResultRows results =
        simulate(
            "extremes/high_spin_1e5_sym.xml",
            "--rtol",
            "1e-10",
            "--atol",
            "1e-12",
            "--t-end",
            "0.01",
            "--quiet");
    assertThat(results.rows()).hasSizeGreaterThan(1);
    for (List<Double> row : results.rows()) {
      double norm = row.subList(1, 5).stream().mapToDouble(x -> x * x).sum();
      assertThat(Math.sqrt(norm)).isCloseTo(1, within(1e-12));
    }
  }

  @Test
  void overdampedSpringOf1e9TakesFewImplicitSteps() {
    for (String integrator : List.of("ode15s", "ode15sR")) {
      assertThat(
              report("extremes/stiff_1e9_c1e5.xml", "--integrator", integrator, "--rtol", "1e-8")
                  .number("steps"))
          .isLessThan(500);
    }
  }

  /** The isosceles branch passes two singular positions a turn; a jump would be seen at 1 s. */
  @Test
  void sliderCrankStaysOnItsBranchOrSaysWhyNot() throws IOException {
    Path model = EXAMPLES.resolve("extremes/slider_crank_singular.xml");
    Path rows = directory.resolve("r.csv");
    Mechanic.Done run = Mechanic.simulate(model, rows, "--rtol", "1e-8", "--atol", "1e-10");
    ResultRows results = ResultRows.read(rows);
    double reached = results.rows().get(results.rows().size() - 1).get(0);
    assertThat(ReferenceSolution.of(model).orElseThrow().errorOf(results, reached))
        .isLessThan(1e-5);
    if (run.status() != 0) {
      assertThat(run.err()).containsPattern("N-\\d{3}").contains("singular");
    } else {
      assertThat(reached).isEqualTo(5);
    }
  }

  @Test
  void rodThatDoesNotFitIsNamedWithItsResidualAndTheStartCorrected() {
    Path model = EXAMPLES.resolve("extremes/fps_inconsistent_rod.xml");
    assertThat(Mechanic.check(model).orFail().out()).contains("C3").contains("1.0e-03 m");
    Mechanic.Done run = Mechanic.simulate(model, directory.resolve("r.csv")).orFail();
    assertThat(run.out()).contains("\"C3\"").contains("1.0e-03 m");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "extremes/coaxial_massless.xml | ja jb",
        "extremes/gimbal_q2_1.5707963267948966.xml | ja jb jc"
      })
  void jointsThatNoInertiaResistsAreNamedBeforeTheFirstStep(String model, String joints) {
    Path rows = directory.resolve("r.csv");
    Mechanic.Done run = Mechanic.simulate(EXAMPLES.resolve(model), rows);
    assertThat(run.status()).isEqualTo(1);
    assertThat(run.err()).contains("N-002").doesNotContain("NaN");
    assertThat(joints.split(" ")).allSatisfy(j -> assertThat(run.err()).contains("\"" + j + "\""));
    assertThat(rows).doesNotExist();
    assertThat(Mechanic.check(EXAMPLES.resolve(model)).orFail().out()).contains("N-002");
  }

  /** The pattern of Table II of Rodríguez et al. 2003: damping makes the driver stiff. */
  @Test
  void dampingHelpsImplicitIntegratorsAndHindersExplicitOnes() {
    assertThat(evaluations("driver-free-ck100.xml", "ode15sR"))
        .isLessThan(evaluations("driver-free-c0.xml", "ode15sR"));
    assertThat(evaluations("driver-free-ck100.xml", "ode113"))
        .isGreaterThan(2 * evaluations("driver-free-c0.xml", "ode113"));
  }

  private double evaluations(String model, String integrator) {
    return report("driver/" + model, "--integrator", integrator, "--rtol", "1e-4", "--atol", "1e-6")
        .number("evaluations");
  }
}
