package org.mechservice.cli.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

/** {@code mech optimise} and {@code mech identify} find what theory says, and refuse clearly. */
@Tag("slow")
class OptimiseCommandTest {
  /** x'' = -(k1 + k2) x - c x', x(0) = 1 m at rest. */
  private static final String OSCILLATOR =
      """
      <?xml version="1.0"?>
      <!DOCTYPE MechML SYSTEM "MechML.dtd">
      <MechML>
        <MBSsimulation>
          <dynamic>
            <timeSet tini="0" tend="30" tstep="0.02"/>
            <integrator name="ode113" relTol="1e-9" absTol="1e-11"/>
          </dynamic>
        </MBSsimulation>
        <MBSmodel name="Oscillator" massUnits="kg" lengthUnits="m">
          <Parameters>
            <parameter name="c" value="0.3" tunable="true"/>
            <parameter name="k1" value="0.5" tunable="true"/>
            <parameter name="k2" value="0.5" tunable="true"/>
            <parameter name="m" value="1"/>
          </Parameters>
          <Bodies>
            <body name="Ground">
              <point name="o" x="0" y="0" z="0"/>
              <vector name="x" vx="1" vy="0" vz="0"/>
            </body>
            <body name="block">
              <point name="o" x="0" y="0" z="0"/>
              <vector name="x" vx="1" vy="0" vz="0"/>
              <mass value="m"/>
            </body>
          </Bodies>
          <Joints>
            <joint name="slide" type="P">
              <body1 name="Ground" point="o" vector="x"/>
              <body2 name="block" point="o" vector="x"/>
            </joint>
          </Joints>
          <Forces>
            <jointForce name="spring" joint="slide"
                expression="-(k1 + k2)*slide.q - c*slide.v"/>
          </Forces>
          <topology>
            <root name="Ground"/>
            <relCoorVals>
              <jointVal name="slide" posVals="1"/>
            </relCoorVals>
          </topology>
        </MBSmodel>
      </MechML>
      """;

  @TempDir private Path folder;
  private String model = "";
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @BeforeEach
  void writeModel() throws IOException {
    model = Files.writeString(folder.resolve("m.xml"), OSCILLATOR).toString();
  }

  private int mech(String... words) {
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  private double found(String parameter) {
    JsonObject json = JsonParser.parseString(out.toString()).getAsJsonObject();
    return json.getAsJsonObject("parameters").get(parameter).getAsDouble();
  }

  /** The integral of x² is (1 + 4 ζ²)/(4 ζ): least for ζ = 1/2, which is c = 1. */
  @ParameterizedTest
  @ValueSource(strings = {"sqp", "bobyqa", "cmaes"})
  void dampingForTheLeastSquareIsHalfTheCriticalOneByEveryMethod(String method) {
    assertThat(
            mech(
                "optimise",
                model,
                "--minimise",
                "rms(slide.q)^2 * 30",
                "--by",
                "c=0.1:3",
                "--method",
                method,
                "--runs",
                "300",
                "--json"))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    assertThat(found("c")).isCloseTo(1, within(2e-3));
    JsonObject json = JsonParser.parseString(out.toString()).getAsJsonObject();
    assertThat(json.get("objective").getAsDouble()).isCloseTo(1, within(1e-4));
  }

  /** The first swing reaches -exp(-π ζ/sqrt(1 - ζ²)); 0.1 of overshoot is ζ = 0.59116. */
  @Test
  void overshootHoldsWhereTheObjectiveWantsMore() throws IOException {
    Path history = folder.resolve("h.csv");
    Path page = folder.resolve("o.html");
    assertThat(
            mech(
                "optimise",
                model,
                "--minimise",
                "c",
                "--subject-to",
                "min(slide.q) >= -0.1",
                "--by",
                "c=0.1:3",
                "--history",
                history.toString(),
                "--report",
                page.toString()))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    assertThat(out.toString()).contains("min(slide.q) >= -0.1: holds with equality (active)");
    double c = Double.parseDouble(out.toString().lines().findFirst().orElse("").substring(4));
    assertThat(c).isCloseTo(2 * 0.59116, within(1e-3));
    assertThat(Files.readAllLines(history).get(0))
        .isEqualTo("start,run,c,c,min(slide.q) >= -0.1,objective,violation,failure");
    assertThat(page).content().contains("<svg", "holds with equality");
  }

  @Test
  void twoObjectivesHaveAFront() throws IOException {
    Path history = folder.resolve("front.csv");
    Path page = folder.resolve("front.html");
    assertThat(
            mech(
                "optimise",
                model,
                "--minimise",
                "c",
                "--maximise",
                "min(slide.q)",
                "--by",
                "c=0.1:3",
                "--front",
                "4",
                "--history",
                history.toString(),
                "--report",
                page.toString()))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    assertThat(out.toString()).contains("front of ", "by method sqp");
    List<String> rows = Files.readAllLines(history);
    assertThat(rows.get(0)).isEqualTo("c,c,-(min(slide.q))");
    assertThat(rows).hasSizeGreaterThanOrEqualTo(5);
    assertThat(page).content().contains("<svg", "Parameters along the front");
  }

  @Test
  void frontOfOneObjectiveIsRefused() {
    assertThat(mech("optimise", model, "--minimise", "c", "--by", "c=0.1:3", "--front", "4"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("--front belongs to two objectives");
  }

  @Test
  void residualsAreSolvedAsEquations() {
    assertThat(
            mech(
                "optimise",
                model,
                "--residual",
                "at(slide.q, 1) = 0.6",
                "--residual",
                "at(slide.q, 2) = 0.1",
                "--by",
                "c=0:3",
                "k1=0.1:2",
                "--json"))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    JsonObject json = JsonParser.parseString(out.toString()).getAsJsonObject();
    assertThat(json.get("method").getAsString()).isEqualTo("lm");
    assertThat(json.get("objective").getAsDouble()).isLessThan(1e-12);
  }

  /** A negative mass cannot run; such points are rows that say why. */
  @Test
  void pointsThatFailAreRowsWithTheirReason() throws IOException {
    Path history = folder.resolve("h.csv");
    List<String> words =
        List.of(
            "optimise",
            model,
            "--minimise",
            "(max(slide.v) - 0.4)^2",
            "--by",
            "m=-1:4:1",
            "--method",
            "cmaes",
            "--runs",
            "150",
            "--history",
            history.toString());
    assertThat(mech(words.toArray(String[]::new))).isEqualTo(ExitStatus.DONE);
    assertThat(err.toString()).startsWith("S-215 start 1 ended: the run at m=-").contains("M-0");

    List<String> goingOn = new ArrayList<>(words);
    goingOn.addAll(List.of("--failed-as", "10"));
    assertThat(mech(goingOn.toArray(String[]::new))).isEqualTo(ExitStatus.DONE);
    assertThat(Files.readAllLines(history)).anyMatch(line -> line.matches(".*,10,inf,\"?M-0.*"));
  }

  private Path measured(double deviation) throws IOException {
    assertThat(
            mech("simulate", model, "--set", "c=0.4", "--out", folder.resolve("r.csv").toString()))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    Random noise = new Random(11);
    StringBuilder csv = new StringBuilder("t,slide.q\n");
    List<String> lines = Files.readAllLines(folder.resolve("r.csv"));
    for (int i = 1; i < lines.size() && i < 500; i += 5) {
      String[] cells = lines.get(i).split(",", -1);
      double value = Double.parseDouble(cells[1]) + deviation * noise.nextGaussian();
      csv.append(cells[0]).append(',').append(value).append('\n');
    }
    return Files.writeString(folder.resolve("measured.csv"), csv);
  }

  @Test
  void identifiedDampingAndStiffnessHoldTheTruthInTheirIntervals() throws IOException {
    Path data = measured(0.01);
    Path page = folder.resolve("i.html");
    assertThat(
            mech(
                "identify",
                model,
                "--data",
                data.toString(),
                "--by",
                "c=0.1:2",
                "k1=0.1:2:1.2",
                "--sigma",
                "slide.q=0.01",
                "--level",
                "0.99",
                "--profile",
                "c",
                "--report",
                page.toString(),
                "--json"))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    JsonObject json = JsonParser.parseString(out.toString()).getAsJsonObject();
    JsonObject profile = json.getAsJsonArray("profiles").get(0).getAsJsonObject();
    assertThat(profile.get("lower").getAsDouble()).isLessThan(0.4);
    assertThat(profile.get("upper").getAsDouble()).isGreaterThan(0.4);
    assertThat(page).content().contains("Profile of c");
    double[] truth = {0.4, 0.5};
    for (int i = 0; i < truth.length; i++) {
      JsonObject one = json.getAsJsonArray("parameters").get(i).getAsJsonObject();
      double half = one.get("halfWidth").getAsDouble();
      assertThat(one.get("value").getAsDouble()).isCloseTo(truth[i], within(half));
      assertThat(half).isLessThan(0.05);
    }
    // One standard deviation of s is sqrt(1 / (2 · 98)).
    assertThat(json.get("noise").getAsDouble()).isCloseTo(1, within(4 * Math.sqrt(1.0 / 196)));
    assertThat(page).content().contains("<svg", "Correlation", "Residuals");
  }

  @Test
  void parallelSpringsAreNamed() throws IOException {
    Path data = measured(0.01);
    assertThat(mech("identify", model, "--data", data.toString(), "--by", "k1=0.1:2", "k2=0.1:2"))
        .isEqualTo(ExitStatus.DONE);
    assertThat(err.toString()).startsWith("S-214 k1 and k2 cannot be told apart");
    assertThat(out.toString()).contains("not determined by the data");
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "--minimise max(x) --by c=1:2 | S-210 the model has no column \"x\"",
        "--minimise max(slide.q) --by d=1:2 | S-210 the model has no parameter \"d\"",
        "--minimise max(slide.q) --by c=2:1 | S-210 the bounds of c are 2.0 and 1.0",
        "--minimise max(slide.q) --by c=1 | S-210 --by takes P=LOW:HIGH or P=LOW:HIGH:START",
        "--minimise max(slide.q) --by c=1:two | S-210 --by c: \"two\" is no number",
        "--minimise slide.q --by c=1:2 | S-210 \"slide.q\": \"slide.q\" is no parameter; of an",
        "--minimise top(slide.q) --by c=1:2 | S-210 \"top(slide.q)\": there is no reduction",
        "--minimise max(slide.q --by c=1:2 | S-210 \"max(slide.q\": a closing bracket is missing",
        "--minimise series(slide.q) --by c=1:2 | S-210 \"series(slide.q)\": a series is not one",
        "--minimise c --by c=1:2 | S-210 no formula names an output of the model",
        "--by c=1:2 | S-210 write one of --minimise, --maximise and --residual",
        "--minimise max(slide.q) --by c=1:2 --method newton | S-210 there is no method \"newton\"",
        "--minimise max(slide.q) --by c=1:2 --method lm | S-210 the method lm needs residuals",
        "--minimise max(slide.q) --by c=1:2 --starts 0 | S-210 the number of starts is 0",
        "--minimise max(slide.q) --by c=1:2 --subject-to c | S-210 \"c\" is no constraint",
        "--minimise at(slide.q,99) --by c=1:2 | S-210 at(slide.q,99) is outside the run",
      })
  @ParameterizedTest
  void whatCannotBeAskedIsRefusedInOneMessage(String line, String message) {
    List<String> words = new ArrayList<>(List.of("optimise", model));
    words.addAll(List.of(line.strip().split(" ")));
    assertThat(mech(words.toArray(String[]::new))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith(message);
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void measurementsThatCannotBeUsedAreRefused() throws IOException {
    Path data = Files.writeString(folder.resolve("d.csv"), "t,slide.q\n0,1\n1,0.5\n2,0\n");
    assertThat(
            mech("identify", model, "--data", data.toString(), "--by", "c=1:2", "--profile", "d"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-210 --profile d: no parameter of that name");
    assertThat(mech("identify", model, "--data", data.toString(), "--by", "c=1:2", "--column", "x"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-213 the measurements have no column \"x\"");
    assertThat(
            mech(
                "identify",
                model,
                "--data",
                data.toString(),
                "--by",
                "c=1:2",
                "--column",
                "slide.q=y"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-210 the model has no column \"y\"");
    assertThat(
            mech(
                "identify",
                model,
                "--data",
                data.toString(),
                "--by",
                "c=1:2",
                "--sigma",
                "slide.q=0"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-213 the standard deviation of slide.q");
    assertThat(
            mech("identify", model, "--data", folder.resolve("no.csv").toString(), "--by", "c=1:2"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-042 there is no file");
  }

  /** Without a mass there is no run: the identification ends there, and says why. */
  @Test
  void identificationThatMeetsAFailingPointSaysWhy() throws IOException {
    Path data = Files.writeString(folder.resolve("d.csv"), "t,slide.q\n0,1\n1,0.5\n2,0\n");
    assertThat(mech("identify", model, "--data", data.toString(), "--by", "m=-2:-1"))
        .isEqualTo(ExitStatus.SIMULATION_FAILED);
    assertThat(err.toString())
        .startsWith("S-211 the run at m=-1.5 failed: M-030 body \"block\": mass is negative");
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void gradientHasAPageWithBarsAndCurves() throws IOException {
    Path page = folder.resolve("gradient.html");
    assertThat(
            mech(
                "gradient",
                model,
                "--of",
                "integral(slide.q)",
                "series(slide.q,5)",
                "--by",
                "c=0.2:0.5",
                "k1",
                "slide.v",
                "--report",
                page.toString()))
        .as(err.toString())
        .isEqualTo(ExitStatus.DONE);
    assertThat(Files.readString(page))
        .contains("Gradient of m.xml", "<h2>integral(slide.q)</h2>", "<h2>series(slide.q,5)</h2>")
        .contains("0.2 to 0.5", "by 10 %, 0.05", "by 1 m/s", "Effects of the parameters on")
        .contains("slide.q, and its change by each parameter along its range");
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "--of max(x) --by c | S-216 gradients know no column \"x\"; they know",
        "--of max(slide.q) --by d | S-216 ",
        "--of top(slide.q) --by c | S-216 --of top(slide.q): there is no reduction \"top\"",
        "--of max(slide.q) --by c=2:1 | S-216 --by c=2:1: write a name, or a name with a range",
        "--of max(slide.q) --by c=2 | S-216 --by c=2: write a name, or a name with a range",
        "--of max(slide.q) --by c --method up | S-216 there is no method \"up\"",
      })
  @ParameterizedTest
  void whatHasNoGradientIsRefusedInOneMessage(String line, String message) {
    List<String> words = new ArrayList<>(List.of("gradient", model));
    words.addAll(List.of(line.strip().split(" ")));
    assertThat(mech(words.toArray(String[]::new))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith(message).hasLineCount(1);
    assertThat(out.toString()).isEmpty();
  }
}
