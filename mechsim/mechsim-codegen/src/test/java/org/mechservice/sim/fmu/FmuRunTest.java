package org.mechservice.sim.fmu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;

/**
 * Units run in other programs. The Python of the environment variable MECH_PYTHON, or else {@code
 * python3}, needs fmpy; both need a C compiler.
 */
@Tag("slow")
class FmuRunTest {
  private static final String PYTHON =
      Optional.ofNullable(System.getenv("MECH_PYTHON")).orElse("python3");

  private static final double GRAVITY = 9.81;

  /** Asked once: fmpy takes a second to load. */
  private static Optional<Boolean> hasFmpy = Optional.empty();

  @TempDir private Path folder;

  @ParameterizedTest
  @EnumSource
  void ballBouncesAsTheFormulaSaysAndGoesOnToTheBitWhereItWasSaved(FmiVersion version)
      throws Exception {
    Map<String, String> said = fmpy(CModels.ball(), version, "ball,resumed,accumulating");
    assertThat(said)
        .containsEntry("findings", "[]")
        .containsEntry("serialised", "True")
        .containsEntry("restored", "True")
        .containsEntry("reset", "True");
    assertThat(number(said, "ModelExchange", 0)).isLessThan(1e-7);
    assertThat(number(said, "CoSimulation", 0)).isLessThan(1e-12);
    // the bounces meet at sqrt(2/g) (1 + 2 e / (1 - e)) = 2.55854 s
    assertThat(number(said, "ended", 0)).isBetween(2.54, 2.5586);
    assertThat(said.toString()).contains("The intervals between events become ever shorter");
  }

  @ParameterizedTest
  @EnumSource
  void loopStaysClosedAndTakesStartValuesAndParameters(FmiVersion version) throws Exception {
    Map<String, String> said = fmpy(CModels.circle(), version, "circle,tuned");
    assertThat(said).containsEntry("findings", "[]");
    // Relative tolerance 1e-8: projected when it is left, by what one step of CVode drifts.
    assertThat(number(said, "ModelExchange", 1)).isLessThan(1e-6);
    assertThat(number(said, "ModelExchange", 2)).isLessThan(1e-5);
    assertThat(number(said, "CoSimulation", 0)).isLessThan(10 * 1e-8 * GRAVITY);
    assertThat(number(said, "CoSimulation", 1)).isLessThan(1e-8);
    assertThat(number(said, "CoSimulation", 2)).isLessThan(10 * 1e-8);
    assertThat(number(said, "angle", 0)).isCloseTo(2, Offset.offset(1e-8));
  }

  /** The event "top" waits for the falling zero of a speed that is zero at the start. */
  @Test
  void functionThatBeginsAtZeroHasNotCrossedIt() throws Exception {
    Path file = Path.of("..", "..", "examples", "elements", "event.xml");
    MechmlModel model = MechmlReader.read("event.xml", Files.readAllBytes(file));
    RunSettings settings = model.settings().run();
    BuildOptions options = new BuildOptions("DTR", EnumSet.of(ColumnGroup.JOINTS), settings);
    FmuModel unit = FmuModel.of(ModelFactory.inC(model, options), settings);
    Map<String, String> said = fmpy(unit, FmiVersion.FMI_2, "top");
    assertThat(number(said, "ModelExchange", 0)).isCloseTo(1.5, Offset.offset(1e-6));
    assertThat(number(said, "ModelExchange", 1)).isCloseTo(1.22625, Offset.offset(1e-6));
    assertThat(number(said, "CoSimulation", 1)).isCloseTo(1.22625, Offset.offset(1e-8));
  }

  private static FmuModel fourBar(String... wanted) throws Exception {
    Path file = Path.of("..", "..", "examples", "extremes", "fourbar_redundant.xml");
    MechmlModel model = MechmlReader.read("fourbar.xml", Files.readAllBytes(file));
    RunSettings settings = model.settings().run();
    BuildOptions options = new BuildOptions("DTR", EnumSet.of(ColumnGroup.ENERGY), settings);
    return FmuModel.inIndependentCoordinates(
        ModelFactory.inC(model, options), settings, List.of(wanted));
  }

  /** The four-bar keeps its energy, about 10 J; errors of the tolerance 1e-9 add up over 2 s. */
  @ParameterizedTest
  @EnumSource
  void redundantLoopIsOneCoordinateThatKeepsItsEnergy(FmiVersion version) throws Exception {
    Map<String, String> said = fmpy(fourBar(), version, "independent");
    assertThat(said).containsEntry("findings", "[]").containsEntry("states", "j_crank.q j_crank.v");
    assertThat(number(said, "ModelExchange", 0)).isLessThan(1e-5);
    assertThat(number(said, "CoSimulation", 0)).isLessThan(1e-7);
  }

  @Test
  void coordinateAtItsTurningPointEndsTheRunAndNamesAnother() throws Exception {
    Map<String, String> said = fmpy(fourBar("j_rocker"), FmiVersion.FMI_2, "singular");
    assertThat(said).containsEntry("ended", "FMICallException");
    assertThat(said.toString())
        .contains("j_rocker.q hardly determine the others")
        .contains("--coordinates independent:j_crank.q");
  }

  @Test
  void hundredInstancesOnThreadsGiveTheBitsOfOne() throws Exception {
    assertThat(fmpy(CModels.ball(), FmiVersion.FMI_2, "many")).containsEntry("same", "True");
  }

  @Test
  void stiffnessThatTheMethodCannotBearEndsByName() throws Exception {
    Map<String, String> said = fmpy(CModels.circle(), FmiVersion.FMI_2, "stiff");
    assertThat(said).containsEntry("ended", "FMICallException");
    assertThat(said.toString()).contains("The equations are stiff");
  }

  /** Robertson's reaction: the error follows the tolerance over six decades, in few evaluations. */
  @Test
  void methodForStiffModelsSolvesRobertsonsReaction() throws Exception {
    requireCompiler();
    SortedMap<String, String> files = FmuSources.of(CModels.ball(), FmiVersion.FMI_2, "{token}");
    for (String name :
        List.of(
            "mech_backward.c", "mech_backward.h", "mech_steps.h", "mech_math.c", "mech_math.h")) {
      Files.writeString(folder.resolve(name), files.getOrDefault(name, ""));
    }
    Files.writeString(folder.resolve("mech_fmu_model.h"), CModels.resource("robertson.h"));
    Files.writeString(folder.resolve("robertson.c"), CModels.resource("robertson.c"));
    List<String> strict = List.of("-std=c99", "-Wall", "-Wextra", "-Werror", "-O1", "-o", "run");
    List<String> sources = List.of("robertson.c", "mech_backward.c", "mech_math.c", "-lm");
    assertThat(execute(compiler(strict, sources), false)).isEqualTo("0\n");
    List<String> lines = execute(List.of(folder.resolve("run").toString()), false).lines().toList();
    assertThat(lines).hasSize(5);
    for (String line : lines.subList(0, 4)) {
      String[] numbers = line.split(" ", -1);
      assertThat(Double.parseDouble(numbers[0])).isLessThan(10);
      // An explicit method needs some 1e5: the stiffest eigenvalue is -2.2e3 1/s, for 40 s.
      assertThat(Integer.parseInt(numbers[1])).isLessThan(2000);
    }
  }

  @ParameterizedTest
  @EnumSource
  void methodForStiffModelsKeepsLoopsAndEventsToo(FmiVersion version) throws Exception {
    Map<String, String> ball = fmpy(CModels.stiff(CModels.ball()), version, "ball,resumed");
    assertThat(ball).containsEntry("findings", "[]").containsEntry("serialised", "True");
    // Relative tolerance 1e-9: ten of them.
    assertThat(number(ball, "CoSimulation", 0)).isLessThan(10 * 1e-9);
    Map<String, String> circle = fmpy(CModels.stiff(CModels.circle()), version, "circle");
    assertThat(number(circle, "CoSimulation", 0)).isLessThan(10 * 1e-8 * GRAVITY);
    assertThat(number(circle, "CoSimulation", 1)).isLessThan(1e-8);
    assertThat(number(circle, "CoSimulation", 2)).isLessThan(10 * 1e-8);
  }

  @Tag("soak")
  @ParameterizedTest
  @EnumSource
  void unitOfSourcesIsCompiledByTheImporter(FmiVersion version) throws Exception {
    requireCompiler();
    Map<String, String> said = run(FmuArchive.build(CModels.ball(), version, Set.of()), "compiled");
    assertThat(number(said, "CoSimulation", 0)).isLessThan(1e-12);
  }

  @ParameterizedTest
  @EnumSource
  void wrongCallsEndInErrorsAndNothingElse(FmiVersion version) throws Exception {
    requireCompiler();
    Map<String, String> files = new TreeMap<>(FmuSources.of(CModels.ball(), version, "{token}"));
    String calls = version == FmiVersion.FMI_2 ? "hostile2.c" : "hostile3.c";
    files.put("hostile.c", CModels.resource(calls));
    for (Map.Entry<String, String> file : files.entrySet()) {
      Files.writeString(folder.resolve(file.getKey()), file.getValue());
    }
    List<String> sanitizers = List.of("-fsanitize=address,undefined", "-fno-sanitize-recover=all");
    List<String> strict = new ArrayList<>(sanitizers);
    strict.addAll(List.of("-std=c99", "-Wall", "-Wextra", "-Werror", "-O1", "-g", "-o", "hostile"));
    List<String> sources =
        List.of(
            "hostile.c",
            "mech_fmu.c",
            "mech_adams.c",
            "mech_backward.c",
            "mech_math.c",
            "ball.c",
            "-lm");
    assumeTrue(
        execute(compiler(sanitizers, List.of("-xc", "-", "-o", "probe")), true).equals("0\n"),
        "this compiler has no sanitizers");
    String compiled = execute(compiler(strict, sources), false);
    assertThat(compiled).isEqualTo("0\n");
    String ran = execute(List.of(folder.resolve("hostile").toString()), false);
    assertThat(ran).isEqualTo("0 failures\n0\n");
  }

  private static List<String> compiler(List<String> first, List<String> rest) {
    List<String> command = new ArrayList<>(List.of("cc"));
    command.addAll(first);
    command.addAll(rest);
    return command;
  }

  private static void requireCompiler() {
    assumeTrue(
        FmuPlatform.ofThisMachine().flatMap(CCompiler::forPlatform).isPresent(),
        "this machine has no C compiler");
  }

  private Map<String, String> fmpy(FmuModel model, FmiVersion version, String what)
      throws Exception {
    requireCompiler();
    return run(FmuArchive.build(model, version), what);
  }

  private Map<String, String> run(FmuArchive archive, String what) throws Exception {
    if (hasFmpy.isEmpty()) {
      List<String> probe = List.of(PYTHON, "-c", "import fmpy");
      hasFmpy = Optional.of(execute(probe, false).equals("0\n"));
    }
    assumeTrue(hasFmpy.get(), "no fmpy in " + PYTHON);
    Path unit = folder.resolve("model.fmu");
    Files.write(unit, archive.bytes());
    Path script = folder.resolve("fmpy_checks.py");
    Files.writeString(script, CModels.resource("fmpy_checks.py"));
    String text = execute(List.of(PYTHON, script.toString(), unit.toString(), what), false);
    Map<String, String> lines = new HashMap<>();
    for (String line : text.split("\n", -1)) {
      int space = line.indexOf(' ');
      if (space > 0) {
        lines.put(line.substring(0, space), line.substring(space + 1));
      }
    }
    return lines;
  }

  private static double number(Map<String, String> said, String name, int index) {
    String line = said.getOrDefault(name, "");
    assertThat(line).as("%s in %s", name, said).isNotEmpty();
    return Double.parseDouble(line.split(" ", -1)[index]);
  }

  /** Runs a program; returns what it wrote and its exit status. */
  private String execute(List<String> command, boolean withEmptyProgram)
      throws IOException, InterruptedException {
    Path said = folder.resolve("said.txt");
    Process process;
    try {
      process =
          new ProcessBuilder(command)
              .directory(folder.toFile())
              .redirectErrorStream(true)
              .redirectOutput(said.toFile())
              .start();
    } catch (IOException e) {
      return e.getMessage() + "\n";
    }
    try (var in = process.getOutputStream()) {
      if (withEmptyProgram) {
        in.write("int main(void) { return 0; }\n".getBytes(StandardCharsets.UTF_8));
      }
    }
    assertThat(process.waitFor(5, TimeUnit.MINUTES)).isTrue();
    return Files.readString(said) + process.exitValue() + "\n";
  }
}
