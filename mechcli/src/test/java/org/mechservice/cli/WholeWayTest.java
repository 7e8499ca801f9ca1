package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.cli.shell.ExitStatus;

/** The commands on the paper's pendulum, with an embedded server and real CORBA between. */
@Tag("slow")
class WholeWayTest {
  private static final String MODEL = "../examples/pendulum/pendulum.xml";

  private final Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  WholeWayTest(@TempDir Path folder) {
    this.folder = folder;
  }

  private int mech(String... words) {
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  /** The suspension has forces that are classes, with values that only these classes name. */
  @ParameterizedTest
  @ValueSource(strings = {MODEL, "../examples/five-point-suspension/five-point-suspension.xml"})
  void remoteAndLocalRunsWriteTheSameBytes(String model) {
    for (String mode : new String[] {"remote", "local"}) {
      String rows = file(mode + ".csv");
      mech(
          "simulate",
          model,
          "--user-code",
          Path.of(model).resolveSibling(".").toString(),
          "--unconfined",
          "--quiet",
          "--columns",
          "all",
          "--out",
          rows,
          "--mode",
          mode);
    }
    assertThat(err.toString()).isEmpty();
    assertThat(out.toString()).isEmpty();
    assertThat(folder.resolve("local.csv"))
        .isNotEmptyFile()
        .hasSameBinaryContentAs(folder.resolve("remote.csv"));
  }

  @Test
  void strictAccuracyReachesRemoteAndLocalRunsAlike() throws IOException {
    mech("simulate", MODEL, "--quiet", "--out", file("standard.csv"));
    String[] asked = {"simulate", MODEL, "--accuracy", "strict", "--json", "--out"};
    for (String mode : new String[] {"remote", "local"}) {
      out.getBuffer().setLength(0);
      String[] words = Arrays.copyOf(asked, asked.length + 3);
      words[asked.length] = file(mode + ".csv");
      words[asked.length + 1] = "--mode";
      words[asked.length + 2] = mode;
      assertThat(mech(words)).as(err.toString()).isZero();
      assertThat(JsonParser.parseString(out.toString()).getAsJsonObject().get("accuracy"))
          .as(mode)
          .hasToString("\"strict\"");
    }
    assertThat(folder.resolve("local.csv")).hasSameBinaryContentAs(folder.resolve("remote.csv"));
    assertThat(Files.readString(folder.resolve("standard.csv")))
        .isNotEqualTo(Files.readString(folder.resolve("remote.csv")));
  }

  @Test
  void unknownAccuracyIsRefusedByName() {
    assertThat(mech("simulate", MODEL, "--accuracy", "sharp")).isEqualTo(2);
    assertThat(err.toString()).contains("accuracy is \"sharp\"; it must be standard or strict");
  }

  @Test
  void reportsOfRemoteAndLocalRunsDifferOnlyInWhatTheirModesBring() {
    assertThat(mech("simulate", MODEL, "--json")).isZero();
    Set<String> remote = JsonParser.parseString(out.toString()).getAsJsonObject().keySet();
    out.getBuffer().setLength(0);
    assertThat(mech("simulate", MODEL, "--json", "--mode", "local")).isZero();
    Set<String> local = JsonParser.parseString(out.toString()).getAsJsonObject().keySet();
    assertThat(difference(remote, local)).containsExactlyInAnyOrder("tR");
    assertThat(difference(local, remote))
        .containsExactlyInAnyOrder(
            "t2c", "t2s", "tL", "modelJarBytes", "modelClassBytes", "runtimeJarBytes");
  }

  private static Set<String> difference(Set<String> some, Set<String> others) {
    return some.stream().filter(key -> !others.contains(key)).collect(Collectors.toSet());
  }

  @Test
  void robotIsImportedWithItsLossesToldAndSimulated() throws Exception {
    String robot = Path.of("..", "examples", "robot", "arm.urdf").toString();
    assertThat(mech("import", robot, "-o", file("arm.xml"))).isZero();
    assertThat(err.toString()).contains("left out: ", "--losses all lists them");
    err.getBuffer().setLength(0);
    assertThat(mech("simulate", file("arm.xml"), "--quiet", "--out", file("arm.csv"))).isZero();
    assertThat(err.toString()).isEmpty();
    assertThat(folder.resolve("arm.csv")).content().startsWith("t,shoulder.q,elbow.q,grip.q,");
  }

  /** A link without mass at the end of a chain, and inertia that no body has. */
  @Test
  void whatIsOddInAnImportedModelIsToldAtOnce() throws Exception {
    Path robot = folder.resolve("odd.urdf");
    Files.writeString(
        robot,
        """
        <robot name="odd">
          <link name="base"/>
          <link name="arm">
            <inertial><mass value="1"/>
              <inertia ixx="1" iyy="1" izz="3" ixy="0" ixz="0" iyz="0"/></inertial>
          </link>
          <link name="tip"/>
          <joint name="j1" type="continuous"><parent link="base"/><child link="arm"/></joint>
          <joint name="j2" type="continuous"><parent link="arm"/><child link="tip"/></joint>
        </robot>
        """);
    assertThat(mech("import", robot.toString(), "-o", file("odd.xml"), "--strict")).isZero();
    assertThat(err.toString())
        .contains("odd.urdf:4:5: M-032 body \"arm\"")
        .contains("odd.urdf:9: S-086 joint \"j2\" moves body \"tip\" and nothing beyond it");
  }

  /** What changes the motion is printed and has a status of its own; the rest is counted. */
  @Test
  void lossesComeInGrades() throws Exception {
    Path robot = folder.resolve("arm.mjcf");
    Files.writeString(
        robot,
        """
        <mujoco><worldbody><body name="a"><joint name="j" type="ball" frictionloss="0.5"/>
          <geom size="0.1" pos="0.3 0 0"/></body></worldbody><sensor><ballquat joint="j"/></sensor>
        </mujoco>
        """);
    String file = robot.toString();
    assertThat(mech("import", file, "-o", file("arm.xml"))).isEqualTo(4);
    assertThat(err.toString())
        .contains(
            file
                + ": left out: 1 changes the motion, 1 changes contacts or motors only, 1 is picture"
                + " or metadata (--losses all lists them)",
            "arm.mjcf:1:35: M-085 body \"a\": joint \"j\": frictionloss acts against the whole"
                + " rotation here, and along each of three axes in MuJoCo")
        .doesNotContain("M-088", "M-089");
    err.getBuffer().setLength(0);
    assertThat(mech("import", file, "--losses", "all", "-o", file("arm.xml"))).isEqualTo(4);
    assertThat(err.toString()).contains("M-085", "M-088", "M-089");
    assertThat(mech("import", "--strict=motion", file, "-o", file("none.xml"))).isEqualTo(2);
    assertThat(folder.resolve("none.xml")).doesNotExist();
    out.getBuffer().setLength(0);
    assertThat(mech("import", file, "--losses", "json", "-o", file("arm.xml"))).isEqualTo(4);
    assertThat(JsonParser.parseString(out.toString()).getAsJsonArray())
        .extracting(one -> one.getAsJsonObject().get("grade").getAsString())
        .containsExactly("motion", "contact", "picture");
    Files.writeString(robot, Files.readString(robot).replace("frictionloss=\"0.5\"", ""));
    assertThat(mech("import", "--strict=motion", file, "-o", file("arm.xml"))).isZero();
    assertThat(mech("import", "--strict", file, "-o", file("arm.xml"))).isEqualTo(2);
  }

  @Test
  void strictImportThatWouldLoseSomethingWritesNothing() {
    String robot = Path.of("..", "examples", "robot", "arm.urdf").toString();
    assertThat(mech("import", robot, "-o", file("arm.xml"), "--strict")).isEqualTo(2);
    assertThat(err.toString()).contains("S-127 " + robot + " has 9 things");
    assertThat(folder.resolve("arm.xml")).doesNotExist();
  }

  @Test
  void strictExportThatWouldLoseSomethingWritesNothing() {
    String model = Path.of("..", "examples", "elements", "joint-C.xml").toString();
    assertThat(mech("export", model, "-o", file("bead.urdf"), "--strict")).isEqualTo(2);
    assertThat(err.toString()).contains("S-127 " + model + " has 2 things");
    assertThat(folder.resolve("bead.urdf")).doesNotExist();
  }

  private static final String TOO_LONG =
      Path.of("..", "examples", "extremes", "fps_inconsistent_rod.xml").toString();

  @Test
  void strictRunRefusesAStartThatDoesNotCloseTheLoops() {
    assertThat(mech("simulate", TOO_LONG, "--strict", "--quiet", "--out", file("r.csv")))
        .isEqualTo(1);
    assertThat(err.toString()).contains("N-040").contains("\"C3\"").contains("1.0e-03 m");
    assertThat(folder.resolve("r.csv")).doesNotExist();
  }

  /** At a relative tolerance of 1e-2 no run keeps its energy to eight digits. */
  @ValueSource(strings = {"remote", "local"})
  @ParameterizedTest
  void runEndsWhereItsEnergyBalanceDriftsTooFarAndKeepsItsRows(String mode) throws Exception {
    String rows = file("r.csv");
    int status =
        mech(
            "simulate",
            MODEL,
            "--mode",
            mode,
            "--rtol",
            "1e-2",
            "--atol",
            "1e-2",
            "--max-drift",
            "1e-8",
            "--quiet",
            "--out",
            rows);
    assertThat(status).isEqualTo(1);
    assertThat(err.toString())
        .contains("N-016 t=")
        .contains("at most 1.0E-8 is allowed")
        .contains("the relative one is 0.01")
        .contains(rows);
    assertThat(Files.readAllLines(Path.of(rows))).hasSizeGreaterThan(1);
    assertThat(mech("simulate", MODEL, "--mode", mode, "--max-drift", "0.5")).isZero();
  }

  @Test
  void energyBalanceOfPrescribedMotionsIsNotWatched() {
    String model = Path.of("..", "examples", "elements", "kinematic.xml").toString();
    assertThat(mech("simulate", model, "--max-drift", "1e-3")).isEqualTo(2);
    assertThat(err.toString()).contains("which takes no max-drift");
    assertThat(mech("simulate", MODEL, "--max-drift", "0")).isEqualTo(2);
    assertThat(err.toString()).contains("max-drift is 0.0; it must be positive");
  }

  @Test
  void strictCheckTakesWarningsForErrors() {
    String redundant = Path.of("..", "examples", "extremes", "fourbar_redundant.xml").toString();
    assertThat(mech("check", redundant)).isZero();
    assertThat(mech("check", redundant, "--strict")).isEqualTo(2);
    assertThat(err.toString()).contains("S-164 the model has 1 warning");
    assertThat(mech("check", MODEL, "--strict")).isZero();
  }

  @Test
  void penaltyMayHaveNumbersOfItsOwn() {
    String model = Path.of("..", "examples", "extremes", "fourbar_redundant.xml").toString();
    assertThat(mech("simulate", model, "--t-end", "0.1", "--closure", "penalty:alpha=2e8,mu=2"))
        .isZero();
    assertThat(out.toString()).contains("alpha is 2.000e+08").contains("mu 2.000");
    assertThat(mech("simulate", model, "--closure", "penalty:alpha=2")).isEqualTo(2);
    assertThat(err.toString()).contains("S-081").contains("must lie between");
  }

  @Test
  void reportHasTheHashOfTheFileWritten() throws Exception {
    mech("simulate", MODEL, "--json", "--out", file("r.csv"));
    JsonObject report = JsonParser.parseString(out.toString()).getAsJsonObject();
    byte[] hash =
        MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(folder.resolve("r.csv")));
    assertThat(report.get("resultsSha256").getAsString()).isEqualTo(HexFormat.of().formatHex(hash));
  }

  @ValueSource(strings = {"remote", "local"})
  @ParameterizedTest
  void runThatFailsKeepsItsRowsAndSaysWhere(String mode) throws IOException {
    // Velocities whose squares are beyond the range of numbers come within the first step.
    Path model = folder.resolve("heavy.xml");
    Files.writeString(model, Files.readString(Path.of(MODEL)).replace("-9.81", "-1e300"));
    int status =
        mech("simulate", model.toString(), "--mode", mode, "--json", "--out", file("r.csv"));
    assertThat(status).isEqualTo(ExitStatus.SIMULATION_FAILED);
    assertThat(err.toString())
        .startsWith("N-0")
        .endsWith(" Rows up to there are in " + file("r.csv") + ".\n")
        .hasLineCount(1);
    assertThat(
            JsonParser.parseString(out.toString()).getAsJsonObject().get("outcome").getAsString())
        .isEqualTo("failed");
    assertThat(folder.resolve("r.csv")).isNotEmptyFile();
  }

  @ValueSource(strings = {"simulate", "check", "build"})
  @ParameterizedTest
  void brokenModelIsToldWithItsPlaceAndNothingIsWritten(String command) throws IOException {
    Path model = folder.resolve("bad.xml");
    Files.writeString(
        model,
        Files.readString(Path.of(MODEL)).replace("body1 name=\"bar4\"", "body1 name=\"no\""));
    String target = command.equals("build") ? "-o" : command.equals("check") ? "" : "--out";
    String[] words =
        target.isEmpty()
            ? new String[] {command, model.toString()}
            : new String[] {
              command, model.toString(), target, file(command.equals("build") ? "r.jar" : "r.csv")
            };
    assertThat(mech(words)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).containsPattern("^" + model + ":\\d+:\\d+: M-\\d{3} ");
    assertThat(out.toString()).isEmpty();
    try (Stream<Path> files = Files.list(folder)) {
      assertThat(files).containsExactly(model);
    }
  }

  @ValueSource(strings = {"remote", "local"})
  @ParameterizedTest
  void toleranceBelowTheArithmeticIsBadInput(String mode) {
    String[] words = {"simulate", MODEL, "--mode", mode, "--rtol", "1e-15", "--out", file("r.csv")};
    assertThat(mech(words)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-0").contains("1.0E-15").hasLineCount(1);
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void missingModelIsNamed() {
    assertThat(mech("simulate", file("none.xml"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString().strip()).isEqualTo("S-042 there is no file " + file("none.xml"));
  }

  @Test
  void optionTheServerRefusesIsBadInput() {
    assertThat(mech("simulate", MODEL, "--integrator", "euler")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-").contains("euler").hasLineCount(1);
  }

  @Test
  void checkTellsTheTreeAndAnswersInJsonToo() {
    assertThat(mech("check", MODEL)).isZero();
    assertThat(out.toString()).contains("Degrees of freedom: 5");
    out.getBuffer().setLength(0);
    assertThat(mech("check", MODEL, "--json")).isZero();
    assertThat(JsonParser.parseString(out.toString()).isJsonObject()).isTrue();
  }

  /** The crank's bearing is 3 m from the other one, and no three bars reach it. */
  @Test
  void loopThatCannotBeClosedIsNoModelToUse() throws IOException {
    Path model = folder.resolve("wide.xml");
    Files.writeString(
        model,
        Files.readString(Path.of("../examples/four-bar/four-bar.xml"))
            .replace(
                "<body name=\"ground\"/>",
                "<body name=\"ground\"><point name=\"d\" x=\"3\" y=\"0\" z=\"0\"/>"
                    + "<vector name=\"y\" vx=\"0\" vy=\"1\" vz=\"0\"/></body>")
            .replace(
                "<body name=\"rocker\">",
                "<body name=\"rocker\"><point name=\"d\" x=\"0.25\" y=\"0\" z=\"0\"/>"
                    + "<vector name=\"y\" vx=\"0\" vy=\"1\" vz=\"0\"/>")
            .replaceAll(
                "<joint name=\"D\"[^>]*/>",
                "<joint name=\"D\" type=\"R\"><body1 name=\"ground\" point=\"d\" vector=\"y\"/>"
                    + "<body2 name=\"rocker\" point=\"d\" vector=\"y\"/></joint>"));

    assertThat(mech("check", model.toString())).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(out.toString()).contains("Cannot be used:\n  ", "S-092 The loops cannot be closed");
    out.getBuffer().setLength(0);
    assertThat(mech("check", model.toString(), "--json")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(
            JsonParser.parseString(out.toString()).getAsJsonObject().get("unusable").getAsString())
        .contains("S-092");
    assertThat(mech("simulate", model.toString())).isEqualTo(ExitStatus.BAD_INPUT);
  }

  @Test
  void jarOfAnotherEndingIsRefused() {
    assertThat(mech("build", MODEL, "-o", file("p.fmi"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-041", "neither .jar nor .fmu");
    assertThat(folder.resolve("p.fmi")).doesNotExist();
  }

  @Test
  void buildPrintsSizesAndWritesTheSource() throws IOException {
    assertThat(mech("build", MODEL, "-o", file("p.jar"), "--source", file("source"))).isZero();
    assertThat(out.toString())
        .contains(Long.toString(Files.size(folder.resolve("p.jar"))))
        .contains("model classes, compressed", "runtime JAR (needed)", "left out");
    try (Stream<Path> sources = Files.walk(folder.resolve("source"))) {
      assertThat(sources.filter(file -> file.toString().endsWith(".java"))).hasSize(1);
    }
  }

  @Test
  void buildWritesTheModelInCAndRefusesALoopBeforeItWritesAnything() throws IOException {
    assertThat(mech("build", MODEL, "--c", file("c"))).isZero();
    assertThat(folder.resolve("c"))
        .isDirectoryContaining("glob:**/*.h")
        .isDirectoryContaining("glob:**/example.c");
    String suspension = "../examples/five-point-suspension/five-point-suspension.xml";
    assertThat(mech("build", suspension, "--c", file("loop"))).isNotZero();
    assertThat(folder.resolve("loop")).doesNotExist();
  }

  /** Equations, data beside them, and what events watch and assign: the JAR's classes. */
  @Test
  void theSourceOfAModelWithEventsIsThatOfAllItsClasses() throws IOException {
    Path scene = Path.of("../examples/elements/event.xml");
    assertThat(mech("build", scene.toString(), "-o", file("e.jar"), "--source", file("source")))
        .isZero();
    Path root = folder.resolve("source");
    try (Stream<Path> sources = Files.walk(root).filter(Files::isRegularFile);
        JarFile jar = new JarFile(file("e.jar"))) {
      assertThat(sources.map(path -> root.relativize(path).toString().replace(".java", ".class")))
          .hasSizeGreaterThan(2)
          .containsExactlyInAnyOrderElementsOf(
              jar.stream().map(JarEntry::getName).filter(n -> n.endsWith(".class")).toList());
    }
  }

  @Test
  void modelClassesNeedJavaBaseAndTheSolverAlone() throws IOException {
    mech("build", MODEL, "-o", file("p.jar"));
    JavaClasses model = new ClassFileImporter().importJar(new JarFile(file("p.jar")));
    assertThat(model).isNotEmpty();
    Set<String> packages =
        model.stream()
            .flatMap(type -> type.getDirectDependenciesFromSelf().stream())
            .map(dependency -> dependency.getTargetClass().getBaseComponentType())
            .filter(type -> !type.isPrimitive() && !model.contain(type.getName()))
            .map(JavaClass::getPackageName)
            .collect(Collectors.toSet());
    packages.removeAll(ModuleLayer.boot().findModule("java.base").orElseThrow().getPackages());
    assertThat(packages)
        .isSubsetOf(
            "org.mechservice.solver.api",
            "org.mechservice.solver.api.capability",
            "org.mechservice.solver.api.result",
            "org.mechservice.solver.api.run",
            "org.mechservice.solver.spatial");
  }

  @Test
  void standaloneJarNeedsNoRuntime() {
    assertThat(mech("build", MODEL, "-o", file("p.jar"), "--standalone")).isZero();
    assertThat(out.toString()).contains("runtime JAR (not needed)");
  }

  /** The parts by purpose are all of the JAR, and each class has its purpose. */
  @ParameterizedTest
  @CsvSource({
    "pendulum/pendulum.xml, ",
    "pendulum/pendulum.xml, --compact",
    "elements/event.xml, ",
    "crane/crane.xml, --compact"
  })
  void standaloneJarIsShownByPurpose(String example, @Nullable String compact) throws IOException {
    List<String> command =
        Stream.of("build", "../examples/" + example, "-o", file("p.jar"), "--standalone", compact)
            .filter(Objects::nonNull)
            .toList();
    assertThat(mech(command.toArray(String[]::new))).isZero();
    long shown =
        out.toString()
            .lines()
            .filter(line -> line.startsWith("  "))
            .mapToLong(line -> Long.parseLong(line.replaceAll(".* (\\d+) B", "$1")))
            .sum();
    assertThat(shown).isEqualTo(Files.size(folder.resolve("p.jar")));
    assertThat(out.toString())
        .contains("  the model's own", "  messages", "  method of integration")
        .doesNotContain("  other");
  }
}
