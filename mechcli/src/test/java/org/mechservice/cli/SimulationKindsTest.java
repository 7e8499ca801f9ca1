package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.cli.shell.ExitStatus;

/** Every kind of simulation of one file, remotely, locally, and as a JAR. */
@Tag("slow")
class SimulationKindsTest {
  private static final String OTHERS =
      """
        <MBSsimulation name="rest"><static/></MBSsimulation>
        <MBSsimulation name="modes"><linearize at="equilibrium"/></MBSsimulation>
        <MBSsimulation name="matrices"><linearize modes="false"/></MBSsimulation>
        <MBSsimulation name="geometry">
          <kinematic><timeSet tini="0" tend="1" tstep="0.1"/></kinematic>
        </MBSsimulation>
        <MBSsimulation name="drives">
          <inverseDynamic><timeSet tini="0" tend="1" tstep="0.1"/></inverseDynamic>
        </MBSsimulation>
        <MBSmodel\
      """;

  private final Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  SimulationKindsTest(@TempDir Path folder) {
    this.folder = folder;
  }

  private int mech(String... words) {
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  /** The slider-crank with all simulations, its crank free or turning at 4 rad/s. */
  private String sliderCrank(boolean driven) throws IOException {
    String text = Files.readString(Path.of("../examples/benchmarks/slider_crank_planar.xml"));
    String motion = driven ? "driven=\"4*t\"" : "posVals=\"0.3\"";
    Path model = folder.resolve(driven + ".xml");
    Files.writeString(
        model,
        text.replace("<MBSmodel", OTHERS)
            .replace("name=\"j_crank\" velVals=\"10\"", "name=\"j_crank\" " + motion));
    return model.toString();
  }

  /** Returns the lines of a run's results, the first being the names. */
  private List<String> run(String model, String simulation) throws IOException {
    int status =
        mech("simulate", model, "--simulation", simulation, "--quiet", "--out", file("r.csv"));
    assertThat(err.toString()).isEmpty();
    assertThat(status).isZero();
    return Files.readAllLines(folder.resolve("r.csv"));
  }

  private static double value(List<String> lines, int row, String column) {
    int index = Arrays.asList(lines.get(0).split(",", -1)).indexOf(column);
    assertThat(index).as(column + " in " + lines.get(0)).isNotNegative();
    return Double.parseDouble(lines.get(row).split(",", -1)[index]);
  }

  @Test
  void staticSimulationGivesTheEquilibriumInOneRow() throws IOException {
    List<String> lines = run(sliderCrank(false), "rest");
    assertThat(lines).hasSize(2);
    // the crank hangs, the slider stands where the rod leaves it
    assertThat(value(lines, 1, "j_crank.q")).isCloseTo(-Math.PI / 2, within(1e-8));
    assertThat(value(lines, 1, "j_slider.q")).isCloseTo(Math.sqrt(0.21), within(1e-8));
  }

  @Test
  void linearisationGivesOneRowPerMode() throws IOException {
    List<String> lines = run(sliderCrank(false), "modes");
    assertThat(lines).hasSize(2);
    assertThat(lines.get(0))
        .startsWith("t,mode,eigenvalue.re,eigenvalue.im,frequency,damping,j_crank.re");
    double omega = value(lines, 1, "eigenvalue.im");
    assertThat(omega).isPositive();
    assertThat(value(lines, 1, "frequency")).isCloseTo(omega / (2 * Math.PI), within(1e-14));
    assertThat(value(lines, 1, "damping")).isCloseTo(0, within(1e-9));
  }

  @Test
  void linearisationWithoutModesGivesTheMatrices() throws IOException {
    List<String> lines = run(sliderCrank(false), "matrices");
    assertThat(lines).hasSize(2);
    assertThat(lines.get(0)).startsWith("t,equation,M.j_crank").contains("C.j_rod", "K.j_slider");
  }

  @Test
  void forceThatSetsInLaterLeavesTheMatricesOfTheStartAsTheyAre() throws IOException {
    String model = sliderCrank(false);
    List<String> without = run(model, "matrices");
    Path switched = folder.resolve("switched.xml");
    Files.writeString(
        switched,
        Files.readString(Path.of(model))
            .replace(
                "</Forces>",
                "<jointForce name=\"late\" joint=\"j_crank\""
                    + " expression=\"5*step(t-1)\"/></Forces>"));
    assertThat(run(switched.toString(), "matrices")).isEqualTo(without);
  }

  @Test
  void kinematicSimulationFollowsTheDrives() throws IOException {
    List<String> lines = run(sliderCrank(true), "geometry");
    assertThat(lines).hasSize(12);
    double sin = Math.sin(4);
    assertThat(value(lines, 11, "j_slider.q"))
        .isCloseTo(0.2 * Math.cos(4) + Math.sqrt(0.25 - 0.04 * sin * sin), within(1e-13));
  }

  @Test
  void inverseDynamicsGivesTheDrivingForces() throws IOException {
    List<String> lines = run(sliderCrank(true), "drives");
    assertThat(lines.get(0)).contains("j_crank.drive", "j_slider.a");
    // at the start the crank lies flat: weights of crank and half the rod on their levers, and the
    // accelerations of the moving parts
    assertThat(value(lines, 1, "j_crank.drive")).isNotZero();
  }

  @ValueSource(strings = {"rest", "modes", "geometry", "drives"})
  @ParameterizedTest
  void localRunGivesTheSameBytes(String simulation) throws IOException {
    String model = sliderCrank(simulation.equals("geometry") || simulation.equals("drives"));
    run(model, simulation);
    int status =
        mech(
            "simulate",
            model,
            "--simulation",
            simulation,
            "--mode",
            "local",
            "--quiet",
            "--out",
            file("local.csv"));
    assertThat(err.toString()).isEmpty();
    assertThat(status).isZero();
    assertThat(folder.resolve("local.csv")).hasSameBinaryContentAs(folder.resolve("r.csv"));
  }

  @Test
  void standaloneJarRunsItsSimulation() throws Exception {
    String model = sliderCrank(true);
    run(model, "drives");
    assertThat(mech("build", model, "--simulation", "drives", "--standalone", "-o", file("d.jar")))
        .isZero();
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    Process process =
        new ProcessBuilder(java, "-jar", file("d.jar"), "--quiet", "--out", file("alone.csv"))
            .inheritIO()
            .start();
    assertThat(process.waitFor()).isZero();
    assertThat(folder.resolve("alone.csv")).hasSameBinaryContentAs(folder.resolve("r.csv"));
  }

  @Test
  void unknownSimulationIsRefusedWithThoseThereAre() throws IOException {
    assertThat(mech("simulate", sliderCrank(true), "--simulation", "nodes"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString())
        .contains("no simulation \"nodes\"", "1, 2 (\"rest\"), 3 (\"modes\")");
  }

  @Test
  void methodsAreRefusedWhereNothingIsIntegrated() throws IOException {
    String[] words = {"simulate", sliderCrank(true), "--simulation", "rest", "--integrator", "DE"};
    assertThat(mech(words)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("<static>", "no integrator");
  }

  @Test
  void closedLoopPutsOutEveryGroupOfColumns() throws IOException {
    String model = "../examples/benchmarks/slider_crank_planar.xml";
    int status =
        mech(
            "simulate",
            model,
            "--t-end",
            "0.1",
            "--quiet",
            "--columns",
            "all",
            "--out",
            file("all.csv"));
    assertThat(err.toString()).isEmpty();
    assertThat(status).isZero();
    assertThat(Files.readAllLines(folder.resolve("all.csv")).get(0))
        .contains(
            "constraint.position", "constraint.velocity", "pin.lambda[0]", "j_rod.fx", "j_rod.tz");
    status =
        mech(
            "simulate",
            model,
            "--t-end",
            "0.1",
            "--quiet",
            "--columns",
            "all",
            "--out",
            file("local.csv"),
            "--mode",
            "local");
    assertThat(status).isZero();
    assertThat(folder.resolve("all.csv")).hasSameBinaryContentAs(folder.resolve("local.csv"));
  }

  /** Bodies that hang side by side on joints with Euler parameters. */
  private String hanging(String type, int count) throws IOException {
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    for (int i = 0; i < count; i++) {
      bodies.append(
          "<body name='b%d'><point name='p' x='0' y='0' z='0'/><cog x='0' y='0' z='-1'/><mass value='1'/><inertiaTensor Ixx='0.1' Iyy='0.2' Izz='0.1'/></body>"
              .formatted(i));
      joints.append(
          "<joint name='j%d' type='%s'><body1 name='G' point='p'/><body2 name='b%d' point='p'/></joint>"
              .formatted(i, type, i));
    }
    Path model = folder.resolve(type + count + ".xml");
    Files.writeString(
        model,
        "<MechML><MBSsimulation><linearize at='start'/></MBSsimulation><MBSmodel name='hanging'"
            + " massUnits='kg' lengthUnits='m'><Bodies><body name='G'><point name='p' x='0' y='0'"
            + " z='0'/></body>"
            + bodies
            + "</Bodies><Joints>"
            + joints
            + "</Joints><Forces><gravity gx='0' gy='0' gz='-9.81'/></Forces><topology><root"
            + " name='G'/></topology></MBSmodel></MechML>");
    return model.toString();
  }

  /**
   * Rows of modes are not states: with Euler parameters they are shorter from six joints on. Each S
   * joint has two modes of swinging, with the squares m g / (I + m) = 9.81 / 1.2 and 9.81 / 1.1; a
   * free body has none.
   */
  @ParameterizedTest
  @CsvSource({"S, 1", "S, 5", "S, 6", "S, 20", "F, 1", "F, 5", "F, 6", "F, 20"})
  void modesOfJointsWithEulerParametersAreTheSameAtAServer(String type, int count)
      throws IOException {
    String model = hanging(type, count);
    for (String mode : new String[] {"remote", "local"}) {
      String rows = file(mode + ".csv");
      mech("simulate", model, "--quiet", "--out", rows, "--mode", mode);
    }
    List<String> lines = Files.readAllLines(folder.resolve("remote.csv"));
    assertThat(lines).isEqualTo(Files.readAllLines(folder.resolve("local.csv")));
    double[] frequencies =
        IntStream.range(1, lines.size())
            .mapToDouble(row -> value(lines, row, "frequency"))
            .filter(frequency -> frequency > 0.1)
            .toArray();
    assertThat(frequencies).hasSize(type.equals("S") ? 2 * count : 0);
    for (int i = 0; i < frequencies.length; i++) {
      double about = i < count ? 1.2 : 1.1;
      assertThat(2 * Math.PI * frequencies[i]).isCloseTo(Math.sqrt(9.81 / about), within(1e-9));
    }
  }
}
