package org.mechservice.sim.service.setup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.FutureTask;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.user.PushedCart;

/** Models that are read and built in processes of their own: the same answers, with bounds. */
@Tag("slow")
class SetUpWorkersTest {
  private static final NameValue[] AS_IN_FILE = {};

  private final List<SetUpWorkers> opened = new ArrayList<>();

  private SetUpWorkers workers(HostLimits limits) {
    SetUpWorkers workers = new SetUpWorkers(new CurrentLimits(limits), new ClassLibrary());
    opened.add(workers);
    return workers;
  }

  private SetUps outside() {
    return workers(HostLimits.DEFAULT).setUps();
  }

  private SetUps here() {
    return workers(HostLimits.OWN).setUps();
  }

  @AfterEach
  void close() {
    opened.forEach(SetUpWorkers::close);
    opened.clear();
  }

  private static ModelFiles pendulum() throws Exception {
    return files(Files.readAllBytes(Path.of("../../examples/pendulum/pendulum.xml")));
  }

  private static ModelFiles files(byte[] content) {
    return new ModelFiles("pendulum.xml", content, List.of(), false, ReadingBounds.NONE);
  }

  private static long processes() {
    return ProcessHandle.current().descendants().filter(SetUpWorkersTest::isSetUp).count();
  }

  private static boolean isSetUp(ProcessHandle process) {
    try {
      return Files.readString(Path.of("/proc", Long.toString(process.pid()), "cmdline"))
          .contains(SetUpMain.class.getName());
    } catch (java.io.IOException e) {
      return false; // it has ended
    }
  }

  @Test
  void answersOfAnotherProcessAreThoseOfThisOne() throws Exception {
    SetUps outside = outside();
    SetUps here = here();
    ModelFiles model = pendulum();
    NameValue[] options = {
      new NameValue("columns", "all"), new NameValue("integrator", "ode15s"),
    };
    assertThat(outside.load(model).warnings()).hasSameSizeAs(here.load(model).warnings());
    assertThat(outside.info(model)).usingRecursiveComparison().isEqualTo(here.info(model));
    assertThat(outside.roadmap(model)).usingRecursiveComparison().isEqualTo(here.roadmap(model));
    assertThat(outside.parameters(model))
        .usingRecursiveComparison()
        .isEqualTo(here.parameters(model));
    assertThat(outside.reading(model, options))
        .usingRecursiveComparison()
        .isEqualTo(here.reading(model, options));
    assertThat(outside.checkReport(model, AS_IN_FILE, true))
        .isEqualTo(here.checkReport(model, AS_IN_FILE, true));
    assertThat(outside.reportOf("m.xml", model.text()))
        .isEqualTo(here.reportOf("m.xml", model.text()));
    assertThat(outside.sources(model, options).files())
        .usingRecursiveComparison()
        .isEqualTo(here.sources(model, options).files());
    SetUps.Built built = outside.build(model, options);
    SetUps.Built same = here.build(model, options);
    assertThat(built.files().sha256()).isEqualTo(same.files().sha256());
    assertThat(built.request()).isEqualTo(same.request());
    assertThat(built.generated()).isEqualTo(same.generated());
    assertThat(built.warnings()).isEqualTo(same.warnings());
    assertThat(outside.pack(model, options).jar().sha256())
        .isEqualTo(here.pack(model, options).jar().sha256());
    assertThat(processes()).isEqualTo(1);
  }

  @Test
  void classesOfUsersAreCompiledBehindAnotherProcessAgain() throws Exception {
    ModelFiles pushed =
        new ModelFiles(
            "pushed.xml",
            PushedCart.file(),
            List.of(PushedCart.asSource(PushedCart.harmlessSource())),
            true,
            ReadingBounds.NONE);
    assertThat(outside().build(pushed, AS_IN_FILE).files().ofUsers().keySet())
        .isEqualTo(here().build(pushed, AS_IN_FILE).files().ofUsers().keySet())
        .isNotEmpty();
  }

  @Test
  void refusalsAreThoseOfTheContract() throws Exception {
    SetUps outside = outside();
    InvalidModel unreadable =
        catchThrowableOfType(
            InvalidModel.class,
            () -> outside.load(files("no model".getBytes(StandardCharsets.UTF_8))));
    assertThat(unreadable.code).isEqualTo("S-016");
    assertThat(unreadable.diagnostics).isNotEmpty();
    InvalidOption unknown =
        catchThrowableOfType(
            InvalidOption.class,
            () -> outside.build(pendulum(), new NameValue[] {new NameValue("speed", "1")}));
    assertThat(unknown.optionName).isEqualTo("speed");
    assertThat(
            outside
                .translate(
                    new ModelFile(
                        "r.urdf",
                        "<robot name='r'><link name='base'/></robot>"
                            .getBytes(StandardCharsets.UTF_8)))
                .model()
                .fileName)
        .isEqualTo("r.xml");
  }

  /** Bodies in a chain of free joints, each also tied to the ground: as many loops as bodies. */
  static byte[] loops(int count) {
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    for (int i = 0; i < count; i++) {
      String before = i == 0 ? "Ground" : "b" + (i - 1);
      bodies.append("<body name=\"b%d\"><sphere radius=\"0.1\" mass=\"1\"/></body>".formatted(i));
      joints.append(
          ("<joint name=\"k%1$d\" type=\"F\" body1=\"%2$s\" body2=\"b%1$d\"/>"
                  + "<joint name=\"l%1$d\" type=\"S\" body1=\"Ground\" body2=\"b%1$d\"/>")
              .formatted(i, before));
    }
    return ("<MechML><MBSsimulation><dynamic><timeSet tini=\"0\" tend=\"1\" tstep=\"0.1\"/>"
            + "</dynamic></MBSsimulation><MBSmodel name=\"big\" massUnits=\"kg\""
            + " lengthUnits=\"m\" silence=\"no-gravity\"><Bodies><body name=\"Ground\"/>"
            + bodies
            + "</Bodies><Joints>"
            + joints
            + "</Joints><topology><root name=\"Ground\"/></topology></MBSmodel></MechML>")
        .getBytes(StandardCharsets.UTF_8);
  }

  @Test
  void modelWithTooManyLoopsIsRefusedByName() {
    ModelFiles model =
        new ModelFiles("loops.xml", loops(11), List.of(), false, new ReadingBounds(10));
    LimitExceeded refusal = catchThrowableOfType(LimitExceeded.class, () -> outside().load(model));
    assertThat(refusal.limitName).isEqualTo("modelLoops");
    assertThat(refusal.limitValue).isEqualTo(10);
    assertThat(refusal.requested).isEqualTo(11);
    assertThat(refusal.text).contains("11 closed loops", "modelLoops");
  }

  @Test
  void modelThatNeedsMoreMemoryIsRefusedByNameAndTheNextIsBuilt() throws Exception {
    SetUps outside = workers(HostLimits.DEFAULT.with(HostLimit.SET_UP_MEMORY, 1 << 26)).setUps();
    LimitExceeded refusal =
        catchThrowableOfType(LimitExceeded.class, () -> outside.load(files(loops(2000))));
    assertThat(refusal.code).isEqualTo("S-110");
    assertThat(refusal.limitName).isEqualTo("setUpMemory");
    assertThat(refusal.text).contains("64 MB", "setUpMemory");
    assertThat(outside.build(pendulum(), AS_IN_FILE).files().own()).isNotEmpty();
  }

  @Test
  void modelThatTakesTooLongIsRefusedByName() {
    SetUps outside = workers(HostLimits.DEFAULT.with(HostLimit.SET_UP_TIME, 1)).setUps();
    LimitExceeded refusal =
        catchThrowableOfType(LimitExceeded.class, () -> outside.load(files(loops(2000))));
    assertThat(refusal.code).isEqualTo("S-230");
    assertThat(refusal.limitName).isEqualTo("setUpTime");
    assertThat(processes()).isZero();
  }

  @Test
  void processEndsWithTheCallThatWaitsForIt() throws Exception {
    SetUps outside = outside();
    CompletableFuture<Throwable> thrown = new CompletableFuture<>();
    Thread client =
        new Thread(
            () -> {
              try {
                outside.load(files(loops(2000)));
                thrown.complete(new AssertionError("it was read"));
              } catch (Exception e) {
                thrown.complete(e);
              }
            });
    client.start();
    while (processes() == 0) {
      Thread.sleep(10);
    }
    client.interrupt();
    assertThat(thrown.join()).isInstanceOf(CancellationException.class);
    client.join();
    while (processes() > 0) {
      Thread.sleep(10);
    }
  }

  /** Checks and builds of different models, all at the same moment. */
  @Test
  void manyAtOnceAreAllAnsweredByFewProcesses() throws Exception {
    SetUps outside = outside();
    SetUps here = here();
    String pendulum = pendulum().text();
    int callers = 3 * SetUpWorkers.MOST;
    List<FutureTask<String>> asked = new ArrayList<>();
    for (int i = 0; i < callers; i++) {
      String model = pendulum.replace("<MBSmodel name=\"", "<MBSmodel name=\"m" + i % 7 + "_");
      boolean check = i % 2 == 0;
      asked.add(new FutureTask<>(() -> answer(outside, model, check)));
    }
    asked.forEach(task -> new Thread(task).start());
    long most = 0;
    while (!asked.stream().allMatch(FutureTask::isDone)) {
      most = Math.max(most, processes());
      Thread.sleep(20);
    }
    for (int i = 0; i < callers; i++) {
      String model = pendulum.replace("<MBSmodel name=\"", "<MBSmodel name=\"m" + i % 7 + "_");
      assertThat(asked.get(i).get()).isEqualTo(answer(here, model, i % 2 == 0));
    }
    assertThat(most).isPositive().isLessThanOrEqualTo(SetUpWorkers.MOST);
    while (processes() > SetUpWorkers.WARM) {
      Thread.sleep(20); // the others are ending
    }
  }

  private static String answer(SetUps setUps, String model, boolean check) throws Exception {
    return check
        ? setUps.reportOf("m.xml", model)
        : setUps.build(files(model.getBytes(StandardCharsets.UTF_8)), AS_IN_FILE).files().sha256();
  }

  @Test
  void typesThatAreNoPlainValuesDoNotTravel() {
    assertThatThrownBy(
            () ->
                PlainValues.write(
                    Thread.class,
                    Thread.currentThread(),
                    new java.io.DataOutputStream(java.io.OutputStream.nullOutputStream())))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("no plain value");
    assertThat(
            Stream.of(SetUps.class.getMethods()).map(java.lang.reflect.Method::getName).distinct())
        .hasSameSizeAs(SetUps.class.getMethods());
  }
}
