package org.mechservice.sim.packaging;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.Chains;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.FreshMachine;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.mechanism.Mechanism;

/** Tables of what one evaluation by generated code takes, and of what its forms take. */
final class CodeSpeeds {
  private static final int ROUNDS = 401;
  private static final long NANOS_PER_ROUND = 1_500_000;

  private final List<String> lines = new ArrayList<>();
  private final Path folder;

  /**
   * @param folder is filled with models' classes
   */
  CodeSpeeds(Path folder) {
    this.folder = folder;
  }

  /** Returns the tables. */
  List<String> lines() throws Exception {
    lines.add("## Speed");
    lines.add("");
    lines.add(
        "The least of "
            + ROUNDS
            + " rounds of 1.5 ms. No peer ran beside these: [peers](peers.md).");
    lines.add("");
    speed();
    lines.add("");
    lines.add("## Straight line and shared kernels");
    lines.add("");
    forms();
    return lines;
  }

  private void speed() {
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
        "DTR, DSR: forward dynamics; RR: the residual alone. DSR of chain200 is left out: factors"
            + " of its mass matrix are left to data.");
  }

  private void forms() throws Exception {
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
        lines.add(form(mechanism, CodeSizes.options("DTR", false).in(form), form.label()));
      }
      lines.add(form(mechanism, CodeSizes.options("DTR", true), "compact"));
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
            + " different60 are the first links of chain200, in equal1000 two of them take turns.");
  }

  private String form(Mechanism mechanism, BuildOptions options, String form) throws Exception {
    MechmlModel file = Scenes.model(mechanism);
    GeneratedModel generated = ModelFactory.generate(file, options);
    CompiledModel compiled = ModelFactory.compile(file, options, generated);
    JarImage jar = ModelJars.model(compiled, "0".repeat(64));
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
        CodeSizes.leastTime(2, () -> CodeSizes.throughBytes(file, options)),
        evaluationTime((ExplicitModel) compiled.newInstance(), mechanism, false),
        first[0],
        first[1]);
  }

  private static String speed(String name, String formulation) {
    MechmlModel file = Scenes.model(Scenes.timingModel(name).mechanism());
    BuildOptions options = CodeSizes.options(formulation, false);
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
    double[] y = RandomMechmlTrees.state(1, mechanism);
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
