package org.mechservice.sim.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.MechmlReader;
import org.mechservice.sim.build.emit.CodeForm;
import org.mechservice.sim.build.jar.Packing;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.ResidualModel;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.mechanism.Mechanism;

/** Sizes and speed of generated code; the soak run writes them to a page of docs/reports. */
class GeneratedCodePageTest {
  private static final String PENDULUM = "pendulum/pendulum.xml";
  private static final String SUSPENSION = "five-point-suspension/variants/elements.xml";
  private static final String DRIVER = "driver/driver-free-c0.xml";
  private static final Path PAGE = Path.of("..", "docs", "reports", "generated-code.md");
  private static final int ROUNDS = 401;
  private static final long NANOS_PER_ROUND = 1_500_000;

  @TempDir private Path folder = Path.of("");

  private static MechmlModel example(String file) throws IOException, MechmlException {
    Path path = Path.of("..", "examples").resolve(file);
    return MechmlReader.read(path.getFileName().toString(), Files.readAllBytes(path));
  }

  private static BuildOptions options(String formulation, boolean compact) {
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "DE";
    RunSettings settings = new RunSettings(0, 1, 0.01, integrator, 1e-5, 1e-5);
    return new BuildOptions(formulation, "auto", compact, Set.of(ColumnGroup.ENERGY), settings);
  }

  private static PackedJar jar(String file, String formulation, boolean compact) throws Exception {
    MechmlModel model = example(file);
    BuildOptions options = options(formulation, compact);
    GeneratedModel generated = ModelFactory.generate(model, options);
    return ModelFactory.modelJar(
        ModelFactory.compile(model, options, generated), "0".repeat(64), Packing.SMALLEST);
  }

  /** Issue 6: 2.2 KB, as the paper's; 1.5 KB for manifest and description. */
  @Test
  void thePendulumInCompactFormIsNoLargerThanThePapers() throws Exception {
    PackedJar jar = jar(PENDULUM, "DTR", true);
    assertThat(jar.modelBytes()).isLessThanOrEqualTo(2252);
    assertThat(jar.bytes().length - jar.modelBytes()).isLessThanOrEqualTo(1536);
  }

  /** Issue 6: 4 KB. */
  @ParameterizedTest
  @ValueSource(strings = {"DTR", "DSR"})
  void thePendulumSpecialisedIsSmall(String formulation) throws Exception {
    PackedJar jar = jar(PENDULUM, formulation, false);
    assertThat(jar.modelBytes()).isLessThanOrEqualTo(4096);
    assertThat(jar.bytes().length - jar.modelBytes()).isLessThanOrEqualTo(1536);
  }

  /** Issue 6: 28 KB, and 1.5 KB for manifest and description. */
  @Test
  void theDriverSpecialisedIsSmall() throws Exception {
    PackedJar jar = jar(DRIVER, "DTR", false);
    assertThat(jar.modelBytes()).isLessThanOrEqualTo(28 * 1024);
    assertThat(jar.bytes().length - jar.modelBytes()).isLessThanOrEqualTo(1536);
  }

  /** Issue 6: 11.8 KB, as the paper's. */
  @Test
  void theDriverInCompactFormIsNoLargerThanThePapers() throws Exception {
    PackedJar jar = jar(DRIVER, "DTR", true);
    assertThat(jar.modelBytes()).isLessThanOrEqualTo(12083);
    assertThat(jar.bytes().length - jar.modelBytes()).isLessThanOrEqualTo(1536);
  }

  /** Issue 6: 7.1 KB, as the paper's, with the forces of its elements. */
  @Test
  void theSuspensionInCompactFormIsNoLargerThanThePapers() throws Exception {
    PackedJar jar = jar(SUSPENSION, "DSR", true);
    assertThat(jar.modelBytes()).isLessThanOrEqualTo(7270);
    assertThat(jar.bytes().length - jar.modelBytes()).isLessThanOrEqualTo(1536);
  }

  @Tag("soak")
  @Test
  void pageOfSizesAndSpeed() throws Exception {
    List<String> lines = new ArrayList<>();
    lines.add("# Generated code: sizes and speed");
    lines.add("");
    lines.add(
        String.format(
                Locale.ROOT,
                "Measured on %s by `mvn verify -Psoak`: %s %s, %d cores at load %.0f, Java %s. Times"
                    + " are the least of %d",
                LocalDate.now(ZoneOffset.UTC),
                System.getProperty("os.name"),
                System.getProperty("os.arch"),
                Runtime.getRuntime().availableProcessors(),
                ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
                System.getProperty("java.version"),
                ROUNDS)
            + " rounds of 1.5 ms; energy is part of every class.");
    lines.add("");
    sizes(lines);
    lines.add("");
    speed(lines);
    lines.add("");
    forms(lines);
    Files.writeString(PAGE, String.join("\n", lines) + "\n");
  }

  private static void sizes(List<String> lines) throws Exception {
    lines.add(
        "| model | formulation | classes, compressed [B] | JAR [B] | generate + write, warm [ms] |");
    lines.add("|---|---|---|---|---|");
    for (String file : List.of(PENDULUM, DRIVER)) {
      for (String formulation : List.of("compact", "DTR", "DSR", "RR", "RR-JF")) {
        boolean compact = formulation.equals("compact");
        String asked = compact ? "DTR" : formulation;
        PackedJar jar = jar(file, asked, compact);
        lines.add(
            String.format(
                Locale.ROOT,
                "| %s | %s | %d | %d | %.1f |",
                file,
                formulation,
                jar.modelBytes(),
                jar.bytes().length,
                generationTime(example(file), options(asked, compact))));
      }
    }
    lines.add("");
    lines.add("Runtime JAR: " + ModelFactory.runtimeJar().bytes().length + " B.");
  }

  private static double generationTime(MechmlModel model, BuildOptions options) {
    long best = Long.MAX_VALUE;
    long end = System.nanoTime() + 5_000_000_000L;
    for (int i = 0; i < 3 || (i < 20 && System.nanoTime() < end); i++) {
      long start = System.nanoTime();
      ModelFactory.compile(model, options, ModelFactory.generate(model, options));
      best = Math.min(best, System.nanoTime() - start);
    }
    return best * 1e-6;
  }

  private static void speed(List<String> lines) {
    lines.add("| model | formulation | operations of the derivative | one evaluation [ns] |");
    lines.add("|---|---|---|---|");
    for (String name : List.of("pend5", "pend5s", "driver41", "chain200")) {
      for (String formulation : List.of("DTR", "DSR", "RR")) {
        if (!formulation.equals("DSR") || !name.equals("chain200")) {
          lines.add(speed(name, formulation));
        }
      }
    }
    lines.add("");
    lines.add(
        "DTR, DSR: forward dynamics; RR: the residual alone. DSR of chain200 is left out: its mass"
            + " matrix has 20 100 elements, each written out. No peer ran beside these.");
  }

  private void forms(List<String> lines) throws Exception {
    lines.add(
        "| model | form | operations | class [B] | JAR [B] | generate + write, warm [ms] | one"
            + " evaluation [ns] | first 1 000 [ms] | first 10 000 [ms] |");
    lines.add("|---|---|---|---|---|---|---|---|---|");
    for (Mechanism mechanism :
        List.of(
            Chains.ofDifferentLinks(20),
            Scenes.timingModel("driver41").mechanism(),
            Chains.ofDifferentLinks(60),
            Scenes.timingModel("chain200").mechanism(),
            Chains.ofEqualLinks(1000))) {
      for (CodeForm form : List.of(CodeForm.STRAIGHT, CodeForm.SHARED)) {
        lines.add(form(mechanism, options("DTR", false).in(form), form.label()));
      }
      lines.add(form(mechanism, options("DTR", true), "compact"));
    }
    lines.add("");
    lines.add(
        "Straight: every operation written out; shared: one method for links of the same structure,"
            + " the constants in which they differ in a table. Both have the same bits. Chosen are"
            + " shared kernels from "
            + CodeForm.LEAST_OPERATIONS
            + " operations on where they take at most half the code. The first evaluations run in a"
            + " fresh virtual machine and are told in processor time, that of its compilers"
            + " included, with loading the class; steps of the clock are 10 ms. different20 and"
            + " different60 are the first links of chain200, in equal1000 two of them take turns;"
            + " straight lines that do not fit into a class file are left out.");
  }

  private String form(Mechanism mechanism, BuildOptions options, String form) throws Exception {
    MechmlModel file = Scenes.model(mechanism);
    GeneratedModel generated = ModelFactory.generate(file, options);
    if (!options.compact() && generated.operations() == 0) {
      return "| " + mechanism.name() + " | " + form + " | | | | | | | |";
    }
    CompiledModel compiled = ModelFactory.compile(file, options, generated);
    PackedJar jar = ModelFactory.modelJar(compiled, "0".repeat(64), Packing.SMALLEST);
    double[] first =
        FreshMachine.firstEvaluations(compiled, folder.resolve(mechanism.name() + form));
    return String.format(
        Locale.ROOT,
        "| %s | %s | %d | %d | %d | %.0f | %d | %.0f | %.0f |",
        mechanism.name(),
        form,
        generated.operations(),
        compiled.classFiles().values().stream().mapToInt(bytes -> bytes.length).sum(),
        jar.bytes().length,
        generationTime(file, options),
        evaluationTime((ExplicitModel) compiled.newInstance(), mechanism, false),
        first[0],
        first[1]);
  }

  private static String speed(String name, String formulation) {
    MechmlModel file = Scenes.model(Scenes.timingModel(name).mechanism());
    BuildOptions options = options(formulation, false);
    GeneratedModel generated = ModelFactory.generate(file, options);
    ExplicitModel model =
        (ExplicitModel) ModelFactory.compile(file, options, generated).newInstance();
    return String.format(
        Locale.ROOT,
        "| %s | %s | %d | %d |",
        name,
        formulation,
        generated.operations(),
        evaluationTime(model, file.mechanism(), formulation.equals("RR")));
  }

  private static long evaluationTime(
      ExplicitModel model, Mechanism mechanism, boolean residualAlone) {
    double[] y = RandomTrees.state(1, mechanism);
    double[] yDot = new double[y.length];
    double[] out = new double[y.length];
    long best = Long.MAX_VALUE;
    int evaluations = 200;
    for (int round = 0; round < 2 * ROUNDS; round++) {
      long start = System.nanoTime();
      for (int i = 0; i < evaluations; i++) {
        y[0] += 1e-9;
        if (residualAlone) {
          ((ResidualModel) model).residual(0, y, yDot, out);
        } else {
          model.derivative(0, y, out);
        }
      }
      long each = Math.max(1, (System.nanoTime() - start) / evaluations);
      best = Math.min(best, each);
      evaluations = (int) Math.max(1, NANOS_PER_ROUND / each);
    }
    assertThat(out).doesNotContain(Double.NaN);
    return best;
  }
}
