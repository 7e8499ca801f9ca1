package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.client.MechConnection;
import org.mechservice.client.RemoteModel;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.guard.UserCode;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.SteppedModel;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.system.LinearSystem;

/** A model at a server has the verbs of a model in process, and its results are the same bits. */
@Tag("slow")
class RemoteModelTest {
  private static final Path EXAMPLES = Path.of("../examples");
  private static final Path PENDULUM = EXAMPLES.resolve("pendulum/pendulum.xml");
  private static final MechServerProcess SERVER =
      MechServerProcess.start(new ServerSettings("remote", "127.0.0.1", 0, 2));
  private static MechConnection service = MechConnection.open(SERVER.url());

  /** Verbs that only a model in process has, because they give or read what only it has. */
  private static final Set<String> HERE =
      Set.of(
          "content",
          "file",
          "folder",
          "userClasses",
          "request",
          "columns",
          "urdf",
          "mjcf",
          "userCode",
          "userCodeWarning");

  /** With and without arguments: what writes files beside the model, and code in this process. */
  private static final Set<String> ONLY_HERE =
      Set.of("writeUrdf", "writeMjcf", "instances", "mechml");

  @TempDir private Path folder = Path.of("");

  @BeforeAll
  static void connect() {
    service = MechConnection.open(SERVER.url());
  }

  @AfterAll
  static void end() {
    service.close();
    SERVER.close();
  }

  private static Path element(String name) {
    return EXAMPLES.resolve("elements").resolve(name + ".xml");
  }

  private static void assertSame(Trajectory there, Trajectory here) {
    assertThat(there.columns()).isEqualTo(here.columns());
    assertThat(there.rows()).isEqualTo(here.rows()).isPositive();
    assertThat(there.values()).isEqualTo(here.values());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "pendulum/pendulum.xml",
        "elements/contact.xml",
        "four-bar/four-bar.xml",
        "elements/static.xml"
      })
  void rowsAndReportAreTheSame(String example) throws Exception {
    Path file = EXAMPLES.resolve(example);
    Trajectory here = MechModel.read(file).simulate();
    Trajectory there = service.read(file).simulate();

    assertSame(there, here);
    Map<String, Object> report = there.report().asMap();
    Map<String, Object> expected = here.report().asMap();
    for (String time : Set.of("wallTime", "realTimeFactor")) {
      report.remove(time);
      expected.remove(time);
    }
    assertThat(report).isEqualTo(expected);
    assertThat(there.report().settings()).isEqualTo(here.report().settings());
  }

  @Test
  void settingsParametersAndColumnsAreTheSame() throws Exception {
    Path file = element("Parameters");
    MechModel here =
        MechModel.read(file)
            .set("push", 4)
            .until(0.3)
            .every(0.1)
            .integrator("ode15s")
            .tolerances(1e-9, 1e-10)
            .formulation("DSR")
            .columns(ColumnGroup.BODIES, ColumnGroup.ENERGY);
    RemoteModel there =
        service
            .read(file)
            .set("push", 4)
            .until(0.3)
            .every(0.1)
            .integrator("ode15s")
            .tolerances(1e-9, 1e-10)
            .formulation("DSR")
            .columns(ColumnGroup.BODIES, ColumnGroup.ENERGY);

    assertSame(there.simulate(), here.simulate());
    assertThat(there.parameters()).isEqualTo(here.parameters());
    assertThat(there.simulations()).isEqualTo(here.simulations());
    assertThat(there.name()).isEqualTo(here.name());
    assertThat(there.check().text()).isEqualTo(here.check().text());
    assertThat(there.check().json()).isEqualTo(here.check().json());
  }

  /** The methods are built in different places and run in this process alike: their first runs. */
  @Test
  void reportIsOfTheSameMethods() throws Exception {
    Effort least = new Effort("least", new double[] {1e-3}, 1, 1, 0, 1, 0, 0, 60);
    Path file = element("Parameters");
    List<String> told = new ArrayList<>();
    ReportProgress enough =
        (what, done, left) -> {
          told.add(what);
          if (told.size() == 4) {
            throw new CancellationException("enough");
          }
        };
    UserCode consent = UserCode.NONE.unconfined();
    assertThatThrownBy(
            () -> service.read(file, consent).set("push", 3).report(folder, least, enough))
        .isInstanceOf(CancellationException.class);
    List<String> there = List.copyOf(told);
    told.clear();
    assertThatThrownBy(() -> MechModel.read(file).set("push", 3).report(folder, least, enough))
        .isInstanceOf(CancellationException.class);
    assertThat(there).isEqualTo(told);
    assertThat(folder.resolve("Parameters.csv")).isNotEmptyFile();
  }

  /** Steps and runs are confined; whatever would load a server's classes here needs consent. */
  @Test
  void classesOfAServerAreNotLoadedHereUnasked() throws Exception {
    Effort least = new Effort("least", new double[] {1e-3}, 1, 1, 0, 1, 0, 0, 60);
    RemoteModel model = service.read(PENDULUM);
    assertThatThrownBy(model::instances)
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContainingAll("S-168", "UserCode.unconfined");
    assertThatThrownBy(() -> model.report(folder, least, ReportProgress.SILENT))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContaining("S-168");
    assertThat(service.read(PENDULUM, UserCode.NONE.unconfined()).instances().model().description())
        .isEqualTo(MechModel.read(PENDULUM).instances().model().description());
  }

  @Test
  void analysesAreTheSame() throws Exception {
    MechModel here = MechModel.read(element("static"));
    RemoteModel there = service.read(element("static"));
    assertSame(there.equilibrium(), here.equilibrium());
    assertSame(there.modes(), here.modes());
    assertSame(there.linearise(), here.linearise());
    assertSame(
        service.read(element("inverseDynamic")).inverseDynamics(),
        MechModel.read(element("inverseDynamic")).inverseDynamics());
    assertSame(
        service.read(element("kinematic")).integrator("ode15s").kinematics(),
        MechModel.read(element("kinematic")).kinematics());
    LinearSystem system = service.read(element("input")).linearSystem();
    LinearSystem expected = MechModel.read(element("input")).linearSystem();
    assertThat(system.states()).isEqualTo(expected.states());
    assertThat(system.inputs()).isEqualTo(expected.inputs());
    assertThat(system.outputs()).isEqualTo(expected.outputs());
    assertThat(system.matrices()).usingRecursiveComparison().isEqualTo(expected.matrices());
  }

  @Test
  void stepsWithInputsAreTheSame() throws Exception {
    SteppedModel here = MechModel.read(element("input")).until(0.5).stepped(0.01);
    SteppedModel there = service.read(element("input")).until(0.5).stepped(0.01);
    assertThat(there.inputs()).isEqualTo(here.inputs()).isNotEmpty();
    while (here.isRunning()) {
      for (SteppedModel run : Set.of(here, there)) {
        run.input("force", 40 * (0.5 - run.value("slide.q")) - 12 * run.value("slide.v"));
        run.step();
      }
      assertThat(there.row()).isEqualTo(here.row());
    }
    assertThat(there.isRunning()).isFalse();
    assertThat(there.report().asMap().keySet()).isEqualTo(here.report().asMap().keySet());
    assertThat(there.report().steps()).isEqualTo(here.report().steps());
    byte[] saved = there.save();
    assertThat(service.read(element("input")).until(0.5).stepped(0.01, saved).time())
        .isEqualTo(there.time());
  }

  @Test
  void filesAreTheSame() throws Exception {
    MechModel.read(PENDULUM).writeJar(folder.resolve("here.jar"));
    service.read(PENDULUM).writeJar(folder.resolve("there.jar"));
    assertThat(folder.resolve("there.jar")).hasSameBinaryContentAs(folder.resolve("here.jar"));
    MechModel.read(PENDULUM).simulate(folder.resolve("here.csv"));
    service.read(PENDULUM).simulate(folder.resolve("there.csv"));
    assertThat(folder.resolve("there.csv")).hasSameBinaryContentAs(folder.resolve("here.csv"));
  }

  @Test
  void stopEndsTheRunAndKeepsItsRows() throws Exception {
    RunControl control = new RunControl();
    Thread stopper =
        new Thread(
            () -> {
              while (control.steps() == 0) {
                Thread.onSpinWait();
              }
              control.stop();
            });
    stopper.start();
    Trajectory rows = service.read(PENDULUM).until(1e6).every(1).simulate(control);
    stopper.join();
    assertThat(rows.report().outcome()).isInstanceOf(Outcome.Stopped.class);
    assertThat(rows.rows()).isPositive();
  }

  @Test
  void refusalsHaveTheSameCodes() throws Exception {
    MechmlException here =
        catchThrowableOfType(
            MechmlException.class, () -> MechModel.read(PENDULUM).set("nothing", 1));
    assertThatThrownBy(() -> service.read(PENDULUM).set("nothing", 1))
        .isInstanceOf(InvalidModelException.class)
        .hasMessageContaining(here.diagnostics().get(0).code().code());
    RunFailedException failed =
        catchThrowableOfType(RunFailedException.class, () -> MechModel.read(PENDULUM).kinematics());
    RunFailedException there =
        catchThrowableOfType(RunFailedException.class, () -> service.read(PENDULUM).kinematics());
    assertThat(there.failure().code()).isEqualTo(failed.failure().code());
    assertThat(there.failure().message()).isEqualTo(failed.failure().message());
  }

  @Test
  void everyVerbOfTheLibraryIsThere() {
    assertThat(verbs(RemoteModel.class)).isEqualTo(verbs(MechModel.class));
  }

  @Test
  void whatIsOnlyInProcessIsNotThere() {
    assertThat(RemoteModel.class.getDeclaredMethods())
        .filteredOn(m -> m.getParameterCount() == 0)
        .extracting(Method::getName)
        .doesNotContainAnyElementsOf(HERE)
        .doesNotContain("writeUrdf");
    assertThat(MechModel.class.getDeclaredMethods())
        .extracting(Method::getName)
        .containsAll(HERE)
        .contains("writeUrdf");
  }

  private static Set<String> verbs(Class<?> model) {
    return Arrays.stream(model.getDeclaredMethods())
        .filter(m -> Modifier.isPublic(m.getModifiers()) && !Modifier.isStatic(m.getModifiers()))
        .filter(m -> m.getParameterCount() > 0 || !HERE.contains(m.getName()))
        .filter(m -> !ONLY_HERE.contains(m.getName()))
        .map(m -> signature(m))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static String signature(Method verb) {
    String result = verb.getReturnType().getSimpleName();
    return verb.getName()
        + Arrays.stream(verb.getParameterTypes()).map(Class::getSimpleName).toList()
        + " "
        + (result.endsWith("Model") && !result.startsWith("Stepped") ? "the model" : result)
            .replaceAll("CheckReport|CheckText", "check");
  }

  /** The program of docs/library.md, at this server. */
  @Test
  void programOfThePageRunsHereAndThere() throws Exception {
    String page = Files.readString(Path.of("../docs/library.md"));
    Matcher found =
        Pattern.compile(
                "```java\n([^`]*final class Remote [^`]*)```\n\nIt printed\n\n```\n([^`]*)```")
            .matcher(page);
    assertThat(found.find()).isTrue();
    assertThat(EXAMPLES.resolve("client/Remote.java")).hasContent(found.group(1));
    String text =
        found
            .group(1)
            .replace("\"localhost:15000\"", "\"" + SERVER.url() + "\"")
            .replace("Path.of(\"examples/", "Path.of(\"../examples/")
            .replace("printf(", "printf(java.util.Locale.ROOT, ")
            .replace("final class", "public final class");
    Path file = Files.writeString(folder.resolve("Remote.java"), text);
    String classPath = System.getProperty("java.class.path", "");
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                "-proc:none",
                "-cp",
                classPath,
                "-d",
                folder.toString(),
                file.toString());
    assertThat(status).isZero();
    assertThat(printed()).isEqualTo(found.group(2));
  }

  private String printed() throws Exception {
    PrintStream before = System.out;
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
      System.setOut(new PrintStream(bytes, true, StandardCharsets.UTF_8));
      loader
          .loadClass("Remote")
          .getMethod("main", String[].class)
          .invoke(null, (Object) new String[0]);
    } finally {
      System.setOut(before);
    }
    return bytes.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n");
  }
}
