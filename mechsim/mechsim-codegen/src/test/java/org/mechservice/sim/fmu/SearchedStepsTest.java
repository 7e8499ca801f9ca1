package org.mechservice.sim.fmu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.SortedMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.emit.c.CModel;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.event.StateEvents;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Units for Co-Simulation feel what happens between two points of a step, whatever the steps of
 * communication. The scenes and the right values are those of runs in Java; the units are compiled
 * with all warnings as errors, without a program that uses them.
 */
@Tag("slow")
class SearchedStepsTest {
  private static final String GROUND =
      "<body name='G'><point name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/>"
          + "<vector name='z' vx='0' vy='0' vz='1'/></body>";

  /** 0.155 s behind the touch at sqrt(2 h / g), h = 0.47 m: rising. */
  private static final double LEFT = 0.46432351897704827;

  private static final int FORMULAS = 5;
  private static final int STEPS = 400;

  private static final List<String> FUNCTIONS =
      Stream.concat(MathFunction.symbols().stream(), Stream.of("lin", "aki", "mp", "lin", "mp"))
          .toList();

  private static final String TABLES =
      "<Tables><table name='lin' x='-2;-0.5;0;0.3;2' y='0;1;-1;0.5;0' extrapolation='hold'/>"
          + "<table name='aki' x='-2;-0.5;0;0.3;2' y='0;1;-1;0.5;0' method='akima'"
          + " extrapolation='linear'/><map name='mp' x='-1;0;1.5' y='-1;0.5;1'"
          + " extrapolation='hold' z='0;1;0;1;0;2;-1;0;1'/></Tables>";

  private static final String EVENT =
      "<event name='e' expression='sin(3*x.q)-0.7*x.v' action='record'/>";

  @TempDir private Path folder;

  private static String body(String name, String more) {
    return GROUND
        .replace("'G'", "'" + name + "'")
        .replace("</body>", "<mass value='1'/>" + more + "</body>");
  }

  private static String joint(String name, String type, String axis, String body) {
    return ("<joint name='%s' type='%s'><body1 name='G' point='o' vector='%s'/><body2 name='%s'"
            + " point='o' vector='%s'/></joint>")
        .formatted(name, type, axis, body, axis);
  }

  private static String model(
      double end, String before, String bodies, String joints, String forces, String starts) {
    return "<MechML><MBSsimulation name='run'><dynamic><timeSet tini='0' tend='"
        + end
        + "' tstep='"
        + end / 20
        + "'/></dynamic></MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m'"
        + " silence='no-gravity'>"
        + before
        + "<Bodies>"
        + GROUND
        + bodies
        + "</Bodies><Joints>"
        + joints
        + "</Joints>"
        + forces
        + "<topology><root name='G'/><relCoorVals>"
        + starts
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  /** A mass of 1 kg at 10 m/s along x, under a force. */
  private static String slider(String before, String formula) {
    return model(
        10,
        before,
        body("a", ""),
        joint("x", "P", "x", "a"),
        "<Forces><jointForce name='f' joint='x' expression='" + formula + "'/></Forces>",
        "<jointVal name='x' velVals='10'/>");
  }

  /** A ball whose surface is above a plate by its height less 0.03 m. */
  private static String drop(double end, double height, String law) {
    return model(
        end,
        "",
        body("a", ""),
        joint("x", "P", "z", "a"),
        "<Forces><gravity gx='0' gy='0' gz='-9.81'/><sphereContact name='c' box1='1;1;0.02'"
            + " radius2='0.02' "
            + law
            + "><body1 name='G' point='o' vector='z'/><body2 name='a' point='o'/>"
            + "</sphereContact></Forces>",
        "<jointVal name='x' posVals='" + height + "'/>");
  }

  /** Leaves the plate as fast as it came, after pi sqrt(m/k) = 1 ms. */
  private static String undamped() {
    return drop(LEFT, 0.5, "stiffness='1e7'");
  }

  private static FmuModel unit(String text, String integrator) throws Exception {
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    RunSettings run = model.settings().run().withIntegrator(integrator);
    BuildOptions options = new BuildOptions("auto", EnumSet.of(ColumnGroup.JOINTS), run);
    return FmuModel.of(ModelFactory.inC(model, options), run);
  }

  private Path compiled(String text, String integrator) throws Exception {
    return compiled(unit(text, integrator), "searched.c");
  }

  private Path compiled(FmuModel unit, String driver) throws Exception {
    assumeTrue(
        FmuPlatform.ofThisMachine().flatMap(CCompiler::forPlatform).isPresent(),
        "this machine has no C compiler");
    SortedMap<String, String> files = FmuSources.of(unit, FmiVersion.FMI_2, "{token}");
    List<String> command =
        new ArrayList<>(
            List.of("cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-O1", "-ffp-contract=off"));
    command.addAll(List.of("-o", "program", "driver.c"));
    for (Map.Entry<String, String> file : files.entrySet()) {
      Files.writeString(folder.resolve(file.getKey()), file.getValue());
      if (file.getKey().endsWith(".c") && !file.getKey().equals("mech_fmi2.c")) {
        command.add(file.getKey());
      }
    }
    Files.writeString(folder.resolve("driver.c"), CModels.resource(driver));
    command.add("-lm");
    assertThat(said(command)).isEmpty();
    return folder.resolve("program");
  }

  private String said(List<String> command) throws IOException, InterruptedException {
    Path said = folder.resolve("said.txt");
    Process process =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(said.toFile())
            .start();
    assertThat(process.waitFor(5, TimeUnit.MINUTES)).isTrue();
    return Files.readString(said);
  }

  /** Returns the state at the end, then the number of steps tried. */
  private double[] run(Path program, double end, double step, String... how) throws Exception {
    List<String> command = new ArrayList<>();
    command.addAll(List.of(program.toString(), Double.toString(end), Double.toString(step)));
    command.addAll(Arrays.asList(how));
    List<String> lines = said(command).lines().toList();
    assertThat(lines).noneMatch(line -> line.startsWith("said") || line.startsWith("ended"));
    return lines.stream().mapToDouble(Double::parseDouble).toArray();
  }

  /** 2 v − g (t − T) with v = sqrt(2 g h) and the duration of contact T is 1.528 m/s. */
  @ParameterizedTest
  @ValueSource(strings = {"ode113", "ode15s"})
  void ballDroppedOnAPlateBouncesAtEveryStepOfCommunication(String integrator) throws Exception {
    Path program = compiled(undamped(), integrator);
    for (double step : new double[] {1e-4, 1e-3, 1e-2, 0.1, LEFT}) {
      assertThat(run(program, LEFT, step)[1])
          .as("steps of %s s", step)
          .isCloseTo(1.528, within(1e-3));
    }
  }

  /** The height at 1.334 s, after a bounce, is that of a run of Java with steps of 0.2 ms. */
  @Test
  void dampedBallBounces() throws Exception {
    double end = 1.3340976402653095;
    String law = "stiffness='1e6' damping='50' exponent='1.5'";
    Path program = compiled(drop(end, 1, law), "ode113");
    for (double step : new double[] {1e-4, 1e-2, end}) {
      assertThat(run(program, end, step)[0]).isCloseTo(0.33862, within(1e-4));
    }
  }

  /** Steps of communication do not limit those of the method. */
  @Test
  void stepsOfCommunicationCostNothing() throws Exception {
    Path program = compiled(undamped(), "ode113");
    double[] fine = run(program, LEFT, 1e-4);
    double[] whole = run(program, LEFT, LEFT);
    assertThat(fine).isEqualTo(whole);
  }

  @ParameterizedTest
  @ValueSource(strings = {"restored", "serialised"})
  void runGoesOnToTheBitFromASavedState(String how) throws Exception {
    Path program = compiled(undamped(), "ode113");
    double[] plain = run(program, LEFT, 1e-3);
    // the number of tries is that of the instance
    assertThat(run(program, LEFT, 1e-3, how)).startsWith(plain[0], plain[1]);
    Path strobe = compiled(strobe(), "ode113");
    assertThat(run(strobe, 10, 0.1, how)).containsExactly(run(strobe, 10, 0.1));
  }

  private static String strobe() {
    return model(
        10,
        "",
        body("r", "<inertiaTensor Ixx='1' Iyy='1' Izz='1'/>") + body("a", ""),
        joint("h", "R", "z", "r") + joint("x", "P", "x", "a"),
        "<Forces><jointForce name='f' joint='x' expression='100*step(cos(h.q)-0.9998)'/></Forces>",
        "<jointVal name='h' velVals='6.283185307' posVals='1'/>");
  }

  @Test
  void pushOnceATurnIsFeltEachTime() throws Exception {
    Path program = compiled(strobe(), "ode113");
    double impulse = 10 * 100 * 2 * Math.acos(0.9998) / 6.283185307;
    for (double step : new double[] {1e-2, 1, 10}) {
      assertThat(run(program, 10, step)[3]).isCloseTo(impulse, within(1e-4 * impulse));
    }
  }

  /** v²/2 = 10²/2 + ∫ F dx: 5 J of a table, of soft corners, 100 w √π of a bump of width w. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "tb(x.q) | 5",
        "100*(smoothStep((x.q-50)/0.01)-smoothStep((x.q-50.05)/0.01)) | 5",
        "100*exp(-((x.q-50)/0.05)^2) | 8.862269",
        "100*exp(-((x.q-50)/0.001)^2) | 0.1772454"
      })
  void forceOverAShortWayActs(String formula, double work) throws Exception {
    String tables =
        "<Tables><table name='tb' x='0;50;50.01;50.05;50.06;200' y='0;0;100;100;0;0'"
            + " extrapolation='hold'/></Tables>";
    Path program = compiled(slider(formula.startsWith("tb") ? tables : "", formula), "ode113");
    for (double step : new double[] {0.01, 1, 10}) {
      double v = run(program, 10, step)[1];
      assertThat(0.5 * (v * v - 100)).as("%s s", step).isCloseTo(work, within(1e-3 * work));
    }
  }

  /** Pulses of time of arguments that are not linear in it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "100*step(sin(t)-0.9999) | 5.656901",
        "100*step(0.0001-(t-7.123456)^2) | 2",
        "100*exp(-((t-7.1031)/0.003)^2) | 0.531736155"
      })
  void pulseInTimeActs(String formula, double impulse) throws Exception {
    Path program = compiled(slider("", formula), "ode113");
    for (double step : new double[] {0.01, 10}) {
      assertThat(run(program, 10, step)[1] - 10).isCloseTo(impulse, within(2e-4 * impulse));
    }
  }

  /** Random formulas of all functions and of tables, along random cubics. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void stepsEndWhereTheyEndInJava(long seed) throws Exception {
    Random random = new Random(seed);
    StringBuilder states = new StringBuilder("<States>");
    for (int i = 0; i < FORMULAS; i++) {
      states.append("<state name='s").append(i).append("' derivative='");
      states.append(formula(random, 4)).append("'/>");
    }
    String text =
        slider(TABLES, "x.q").replace("<Forces>", states.append("</States>") + "<Forces>");
    text = text.replace("</dynamic>", EVENT + "</dynamic>");
    Path program = compiled(unit(text, "ode113"), "decisions.c");
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    StateEvents java = new StateEvents(model.watchedMechanism());
    assertThat(java.watches()).isTrue();
    int size = model.mechanism().stateCount();
    double[] given = new double[STEPS * (2 + 4 * size)];
    double[] expected = new double[2 * STEPS];
    double from = 0;
    int cut = 0;
    for (int k = 0; k < STEPS; k++) {
      double to = from + Math.pow(10, -3 * random.nextDouble());
      Way way = new Way(from, given, 2 + k * (2 + 4 * size), new double[size]);
      given[k * (2 + 4 * size)] = from;
      given[k * (2 + 4 * size) + 1] = to;
      for (int i = 0; i < 8; i++) {
        given[way.first + i] = random.nextGaussian() * Math.pow(10, 1 - 3 * random.nextDouble());
      }
      expected[2 * k] = java.seenUntil(from, to, way);
      expected[2 * k + 1] = java.longestFirstStep();
      cut += Double.isNaN(expected[2 * k]) ? 0 : 1;
      from = to;
    }
    double[] found = numbers(program, given);
    assertThat(cut).as("steps of %s that are cut", STEPS).isBetween(STEPS / 10, STEPS - 10);
    assertThat(found).containsExactly(expected);
  }

  /** The state along a step: cubics of the time from its start. */
  private static final class Way implements ModelEvents.Path {
    private final double from;
    private final double[] given;
    private final int first;
    private final double[] state;

    /**
     * @param given holds four coefficients for each component of the state
     * @param first place of the first one
     */
    Way(double from, double[] given, int first, double[] state) {
      this.from = from;
      this.given = given;
      this.first = first;
      this.state = state;
    }

    @Override
    public double[] state() {
      return state;
    }

    @Override
    public boolean moveTo(double t) {
      double s = t - from;
      for (int i = 0; i < state.length; i++) {
        int c = first + 4 * i;
        state[i] = given[c] + s * (given[c + 1] + s * (given[c + 2] + s * given[c + 3]));
      }
      return true;
    }
  }

  private static String formula(Random random, int depth) {
    if (depth == 0) {
      String leaf = random.nextBoolean() ? "x.q" : "x.v";
      return String.format(
          Locale.ROOT, "(%.3f*%s%+.3f)", random.nextGaussian(), leaf, random.nextGaussian());
    }
    String one = formula(random, depth - 1);
    int kind = random.nextInt(FUNCTIONS.size() + 5);
    if (kind < FUNCTIONS.size()) {
      String name = FUNCTIONS.get(kind);
      Optional<MathFunction> function = MathFunction.named(name);
      boolean two = name.equals("mp") || function.map(f -> f.arity() == 2).orElse(false);
      return name + "(" + one + (two ? "," + formula(random, depth - 1) : "") + ")";
    }
    String other = formula(random, random.nextInt(depth));
    return "(" + one + List.of("+", "-", "*", "/", "*").get(kind - FUNCTIONS.size()) + other + ")";
  }

  private double[] numbers(Path program, double[] given) throws Exception {
    ByteBuffer bytes =
        ByteBuffer.allocate(Double.BYTES * given.length).order(ByteOrder.nativeOrder());
    bytes.asDoubleBuffer().put(given);
    Path input = folder.resolve("input.bin");
    Path output = folder.resolve("output.bin");
    Files.write(input, bytes.array());
    Process process =
        new ProcessBuilder(program.toString())
            .redirectInput(input.toFile())
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor()).isZero();
    ByteBuffer read = ByteBuffer.wrap(Files.readAllBytes(output)).order(ByteOrder.nativeOrder());
    double[] numbers = new double[read.remaining() / Double.BYTES];
    read.asDoubleBuffer().get(numbers);
    return numbers;
  }

  /** A four-bar of which a state counts the time for which it is in a narrow range. */
  @Test
  void unitInIndependentCoordinatesSeesTheSame() throws Exception {
    Path file = Path.of("..", "..", "examples", "extremes", "fourbar_redundant.xml");
    String state =
        "<States><state name='n' derivative='100*step(sin(j_crank.q+j_rocker.q)-0.99)'/></States>";
    String text =
        Files.readString(file).replaceFirst("<Forces>", state + "<Forces>").replace("1e-8", "1e-6");
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    RunSettings run = model.settings().run();
    BuildOptions options = new BuildOptions("DTR", EnumSet.of(ColumnGroup.JOINTS), run);
    CModel inC = ModelFactory.inC(model, options);
    double[] whole = run(compiled(FmuModel.of(inC, run), "searched.c"), 5, 5);
    FmuModel independent = FmuModel.inIndependentCoordinates(inC, run, List.of());
    Path program = compiled(independent, "searched.c");
    double[] few = run(program, 5, 5);
    // crank, its velocity, the state, tries
    assertThat(few).hasSize(4);
    assertThat(few[2]).isGreaterThan(1).isCloseTo(whole[whole.length - 2], within(1e-4));
    assertThat(run(program, 5, 1e-3)).isEqualTo(few);
  }

  @Test
  void moduleInWebAssemblySeesTheSame() throws Exception {
    assumeTrue(CCompiler.forWebAssembly().isPresent(), "no compiler for WebAssembly here");
    Files.write(folder.resolve("drop.wasm"), WebAssemblyModule.of(unit(undamped(), "ode113")));
    Files.writeString(folder.resolve("run.js"), CModels.resource("searched.js"));
    String end = Double.toString(LEFT);
    String said;
    try {
      said = said(List.of("node", "run.js", "drop.wasm", end, "0.001"));
    } catch (IOException e) {
      assumeTrue(false, "no node here");
      throw e;
    }
    double[] unit = run(compiled(undamped(), "ode113"), LEFT, LEFT);
    assertThat(Double.parseDouble(said.strip())).isEqualTo(unit[1]);
  }

  /** A ball that begins beyond the middle of a thick box is pushed out on the other side. */
  @Test
  void shapesInsideEachOtherAreNamed() throws Exception {
    Path program = compiled(drop(0.5, -0.005, "stiffness='1e4'"), "ode113");
    String said = said(List.of(program.toString(), "0.5", "0.1"));
    assertThat(said.lines().filter(line -> line.startsWith("said")))
        .singleElement()
        .asString()
        .contains("At t = 0 the shapes of contact \"c\" are inside each other by more than");
  }

  /** A block under a force below that of its friction stays at a velocity of zero. */
  @Test
  void motionThatSlidesAlongAJumpEndsByName() throws Exception {
    Path program = compiled(slider("", "1-2*signum(x.v)"), "ode113");
    String said = said(List.of(program.toString(), "1e5", "100"));
    assertThat(said).contains("the solution slides along a jump of its formulas", "ended at");
  }

  @Test
  void modelExchangeIsSaidNotToBeSearched() throws Exception {
    String said = "In Model Exchange the importer takes the steps, and nothing searches them";
    for (FmiVersion version : FmiVersion.values()) {
      FmuModel watched = unit(undamped(), "ode113");
      assertThat(FmuDescription.of(watched, version, "", List.of())).contains(said);
      assertThat(FmuDescription.of(CModels.ball(), version, "", List.of())).doesNotContain(said);
    }
  }

  @Test
  void modelWithoutChoicesHasNothingOfTheSearch() throws Exception {
    Path file = Path.of("..", "..", "examples", "pendulum", "pendulum.xml");
    FmuModel unit = unit(Files.readString(file), "ode113");
    SortedMap<String, String> files = FmuSources.of(unit, FmiVersion.FMI_3, "{token}");
    assertThat(files.keySet()).noneMatch(name -> name.contains("watch"));
    assertThat(files.get("mech_fmu_model.h")).doesNotContain("WATCH", "watched");
    assertThat(files.get(unit.identifier() + ".c")).doesNotContain("watched");
    assertThat(FmuSources.of(unit(undamped(), "ode113"), FmiVersion.FMI_3, "{token}").keySet())
        .contains("mech_watch.c", "mech_watch.h", "mech_watch_tape.c", "mech_watch_tape.h");
  }
}
