package org.mechservice.sim.emit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.MethodSignature.Argument;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.step.StepKernel;
import org.mechservice.solver.step.StepKind;
import org.mechservice.solver.step.StepSweep;

/**
 * The printed methods of the steps of recursions are what the equations say. Run it with {@code
 * -Dgolden.write=true} to print them anew.
 */
class PrintedStepsTest {
  private static final String PACKAGE = StepKernel.class.getPackageName() + ".printed";
  private static final Path SOURCES =
      Path.of("../../solver-core/solver-mechanics/src/main/java", PACKAGE.replace('.', '/'));

  private static final List<String> ABOUT =
      List.of(
          "Printed from its equations; do not edit. PrintedStepsTest compares it with them and",
          "prints it anew with -Dgolden.write=true.");

  // Names of the arrays while a method is printed; as long as what stands for them in the end.
  private static final String OWN = "link_";
  private static final String PARENT = "above";
  private static final String OUT = "out__";

  /** Largest method that the virtual machine compiles, in bytes of code. */
  private static final int LARGEST_COMPILED = 8000;

  @Test
  void printedMethodsAreThoseOfTheEquations() throws IOException {
    boolean write = Boolean.getBoolean("golden.write");
    for (Map.Entry<String, String> source : sources().entrySet()) {
      Path file = SOURCES.resolve(source.getKey() + ".java");
      if (write) {
        Files.createDirectories(SOURCES);
        Files.writeString(file, source.getValue());
      }
      assertThat(file).content().isEqualTo(source.getValue());
    }
  }

  @Test
  void theVirtualMachineCompilesEachMethod() {
    for (StepKind kind : StepKind.values()) {
      for (StepSweep sweep : StepSweep.values()) {
        // an operation takes two loads, itself and a store at most: 9 bytes with wide slots
        assertThat(9 * sweep.program(kind).operationCount())
            .as("%s of %s", sweep, kind)
            .isLessThan(LARGEST_COMPILED);
      }
    }
  }

  private static Map<String, String> sources() {
    Map<String, String> sources = new LinkedHashMap<>();
    for (StepKind kind : StepKind.values()) {
      sources.put(className(kind), source(kind));
    }
    sources.put("PrintedSteps", choice());
    sources.put("package-info", packageInfo());
    return sources;
  }

  private static String className(StepKind kind) {
    StringBuilder name = new StringBuilder("Printed");
    for (String word : kind.name().toLowerCase(Locale.ROOT).split("_", -1)) {
      name.append(Character.toUpperCase(word.charAt(0))).append(word.substring(1));
    }
    return name.toString();
  }

  private static String source(StepKind kind) {
    ProgramsClass printed =
        new ProgramsClass(
            className(kind), ABOUT, List.of(StepKernel.class), false, CodeForm.STRAIGHT);
    List<Argument> blocks =
        List.of(new Argument(OWN, true, 0), new Argument(PARENT, true, StepSweep.PARENT));
    for (StepSweep sweep : StepSweep.values()) {
      printed.add(
          new MethodSignature(sweep.method(), blocks, OUT, false, true), sweep.program(kind));
    }
    return inBlocks(printed.source(PACKAGE).replace("public final class", "final class"));
  }

  /** Returns a source whose arrays are blocks of one array. */
  private static String inBlocks(String source) {
    String heads =
        source.replace(
            "double[] " + OWN + ", double[] " + PARENT + ", double[] " + OUT,
            "double[] w, int i, int p");
    String inputs = heads.replace(OWN + "[", "w[i + ").replace(PARENT + "[", "w[p + ");
    return Pattern.compile(OUT + "\\[(\\d+)]").matcher(inputs).replaceAll(PrintedStepsTest::output);
  }

  private static String output(MatchResult index) {
    int at = Integer.parseInt(index.group(1));
    return at < StepSweep.PARENT ? "w[i + " + at + "]" : "w[p + " + (at - StepSweep.PARENT) + "]";
  }

  /** Returns the class that makes printed steps. */
  private static String choice() {
    SourceLines source = new SourceLines();
    source.line("package " + PACKAGE + ";").blank();
    source.line("import " + StepKernel.class.getName() + ";");
    source.line("import " + StepKind.class.getName() + ";");
    source.blank().documentation(List.of("The printed steps. " + ABOUT.get(0), ABOUT.get(1)));
    source.open("public final class PrintedSteps").line("private PrintedSteps() {}");
    source.blank().documentation(List.of("Returns the methods of a kind of step."));
    source.open("public static StepKernel of(StepKind kind)");
    source.open("return switch (kind)");
    for (StepKind kind : StepKind.values()) {
      source.line("case " + kind + " -> new " + className(kind) + "();");
    }
    return source.closeStatement().close().close().toString();
  }

  private static String packageInfo() {
    SourceLines source = new SourceLines();
    source.documentation(
        List.of(
            "The methods of the steps of {@code solver.step}, printed from their equations.",
            "",
            "<p>{@code PrintedSteps} makes an instance of each kind; nothing here is edited."));
    return source.line("package " + PACKAGE + ";").toString();
  }
}
