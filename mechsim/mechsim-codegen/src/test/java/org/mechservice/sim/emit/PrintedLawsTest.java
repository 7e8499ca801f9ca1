package org.mechservice.sim.emit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.MethodSignature.Argument;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.force.law.CoordinateLaw;
import org.mechservice.solver.force.law.CoordinateLoad;
import org.mechservice.solver.force.law.Frames;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.PairLoad;
import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.force.law.printed.PrintedLaws;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * The printed methods of force laws are what their formulas say. Run it with {@code
 * -Dgolden.write=true} to print them anew.
 */
class PrintedLawsTest {
  private static final String PACKAGE = PrintedLaws.class.getPackageName();
  private static final Path SOURCES =
      Path.of("../../solver-core/solver-mechanics/src/main/java", PACKAGE.replace('.', '/'));

  private static final List<String> ABOUT =
      List.of(
          "Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and",
          "prints it anew with -Dgolden.write=true.");

  private static final String FORM = "Returns a new instance of a law.";
  private static final String SMOOTH =
      "whether its smoothing is positive, otherwise zero; of no effect if it has none";

  @Test
  void printedMethodsAreThoseOfTheFormulas() throws IOException {
    boolean write = Boolean.getBoolean("golden.write");
    for (Map.Entry<String, String> source : sources().entrySet()) {
      Path file = SOURCES.resolve(source.getKey() + ".java");
      if (write) {
        Files.writeString(file, source.getValue());
      }
      assertThat(file).content().isEqualTo(source.getValue());
    }
  }

  private static Map<String, String> sources() {
    Map<String, String> sources = new LinkedHashMap<>();
    for (PairLaw law : PairLaw.values()) {
      for (boolean smooth : forms(law.smoothing())) {
        String name = className(law, smooth);
        sources.put(name, source(name, new OfPair(law, smooth)));
      }
    }
    for (CoordinateLaw law : CoordinateLaw.values()) {
      for (boolean smooth : forms(law.smoothing())) {
        String name = className(law, smooth);
        sources.put(name, source(name, new OfCoordinate(law, smooth)));
      }
    }
    sources.put("PrintedLaws", choice());
    sources.put("package-info", packageInfo());
    return sources;
  }

  /** Returns the forms of a law: without smoothing, and with it if it has one. */
  private static boolean[] forms(int smoothing) {
    return smoothing < 0 ? new boolean[] {false} : new boolean[] {false, true};
  }

  /** Returns the smoothing of a form of a law: zero or positive. */
  private static Scalar smoothing(Expressions e, int input, boolean smooth) {
    return smooth ? e.input(input).markedPositive() : e.zero();
  }

  private static String className(Enum<?> law, boolean smooth) {
    StringBuilder name =
        new StringBuilder(
            "Printed" + (smooth ? "Smooth" : "") + (law instanceof CoordinateLaw ? "Joint" : ""));
    for (String word : List.of(law.name().toLowerCase(Locale.ROOT).split("_", -1))) {
      name.append(Character.toUpperCase(word.charAt(0))).append(word.substring(1));
    }
    return name.toString();
  }

  /** Returns the class that makes printed laws. */
  private static String choice() {
    SourceLines source = new SourceLines();
    source.line("package " + PACKAGE + ";").blank();
    for (Class<?> type : List.of(CoordinateLaw.class, PairLaw.class, PrintedLaw.class)) {
      source.line("import " + type.getName() + ";");
    }
    source.blank().documentation(List.of("The printed laws. " + ABOUT.get(0), ABOUT.get(1)));
    source.open("public final class PrintedLaws").line("private PrintedLaws() {}");
    source.blank().documentation(List.of(FORM, "", "@param smooth " + SMOOTH));
    source.open("public static PrintedLaw of(PairLaw law, boolean smooth)");
    source.open("return switch (law)");
    for (PairLaw law : PairLaw.values()) {
      source.line("case " + law + " -> " + made(law, law.smoothing()) + ";");
    }
    source.line("default -> throw new IllegalStateException(law + \" is not printed\");");
    source.closeStatement().close();
    source.blank().documentation(List.of(FORM, "", "@param smooth " + SMOOTH));
    source.open("public static PrintedLaw of(CoordinateLaw law, boolean smooth)");
    source.open("return switch (law)");
    for (CoordinateLaw law : CoordinateLaw.values()) {
      source.line("case " + law + " -> " + made(law, law.smoothing()) + ";");
    }
    source.line("default -> throw new IllegalStateException(law + \" is not printed\");");
    source.closeStatement().close();
    return source.close().toString();
  }

  private static String made(Enum<?> law, int smoothing) {
    String plain = "new " + className(law, false) + "()";
    return smoothing < 0 ? plain : "smooth ? new " + className(law, true) + "() : " + plain;
  }

  private static String packageInfo() {
    SourceLines source = new SourceLines();
    source.documentation(
        List.of(
            "The methods of the force laws of {@code force.law}, printed from their formulas.",
            "",
            "<p>{@code PrintedLaws} makes an instance of each; nothing here is edited."));
    return source.line("package " + PACKAGE + ";").toString();
  }

  /** The programs of a law. */
  private interface Programs {
    /** Returns the number of variables. */
    int variables();

    /** Returns the number of coefficients. */
    int coefficients();

    /** Returns how many of them, the first, are the same in a run. */
    int settled();

    Program load();

    Program slopes();

    Program results();
  }

  private static String source(String name, Programs programs) {
    ProgramsClass printed =
        new ProgramsClass(name, ABOUT, List.of(PrintedLaw.class), false, CodeForm.STRAIGHT);
    Argument coefficients = new Argument("c", true, programs.variables());
    List<Argument> all = List.of(new Argument("x", true, 0), coefficients);
    Settled settled = new Settled(programs);
    add(printed, "load", all, settled.program(programs.load()));
    add(printed, "slopes", all, settled.program(programs.slopes()));
    add(printed, "results", all, settled.program(programs.results()));
    if (settled.count() > 0) {
      add(printed, "settle", List.of(coefficients), settled.settling());
    }
    String text = printed.source(PACKAGE).replace("public final class", "final class");
    SourceLines rest = new SourceLines();
    rest.open("").blank();
    if (settled.count() == 0) {
      rest.line("@Override").line("public void settle(double[] c, double[] out) {}").blank();
    }
    rest.line("@Override").open("public int size()");
    rest.line("return " + (programs.coefficients() + settled.count()) + ";").close();
    String more = rest.close().toString();
    return text.substring(0, text.lastIndexOf('}')) + more.substring(more.indexOf('\n') + 1);
  }

  private static void add(
      ProgramsClass printed, String name, List<Argument> arguments, Program program) {
    printed.add(new MethodSignature(name, arguments, "out", false, true), program);
  }

  /** What depends on coefficients alone, as further inputs behind them. */
  private static final class Settled {
    private final int first;
    private final int firstMoving;
    private final int next;
    private final Program settling = new Program();
    private final Map<Scalar, Integer> places = new LinkedHashMap<>();

    Settled(Programs programs) {
      first = programs.variables();
      firstMoving = first + programs.settled();
      next = first + programs.coefficients();
      settling.section("What depends on coefficients alone.", "c");
    }

    int count() {
      return places.size();
    }

    /** Returns the program that computes them. */
    Program settling() {
      places.forEach((value, place) -> settling.output(place, value));
      return settling;
    }

    /** Returns a program with them as inputs. */
    Program program(Program source) {
      Program program = new Program();
      Map<Scalar, Scalar> images = new HashMap<>();
      for (Program.Section section : source.sections()) {
        program.section(section.title(), section.subject());
        for (Program.Output output : section.outputs()) {
          program.output(output.index(), image(source, program, output.value(), images));
        }
      }
      return program;
    }

    private Scalar image(Program source, Program program, Scalar node, Map<Scalar, Scalar> images) {
      Scalar known = images.get(node);
      if (known != null) {
        return known;
      }
      Expressions e = program.expressions();
      Scalar image;
      if (isSettled(node) && isWorthIt(node)) {
        int place = places.computeIfAbsent(copied(node), value -> next - first + places.size());
        image = program.named("settled_" + (place - next + first + 1), e.input(first + place));
      } else {
        List<Scalar> operands = new ArrayList<>();
        for (Scalar operand : node.operands()) {
          operands.add(image(source, program, operand, images));
        }
        image = e.alike(node, operands);
        source.nameOf(node).ifPresent(name -> program.named(name, e.alike(node, operands)));
      }
      images.put(node, image);
      return image;
    }

    private boolean isSettled(Scalar node) {
      return switch (node.operation()) {
        case CONSTANT -> true;
        case INPUT -> node.index() >= first && node.index() < firstMoving;
        default -> node.operands().stream().allMatch(this::isSettled);
      };
    }

    /** A sign costs nothing where it is used. */
    private static boolean isWorthIt(Scalar node) {
      Scalar inner = node.operation() == ScalarOperation.NEGATE ? node.first() : node;
      return !inner.operands().isEmpty();
    }

    private Scalar copied(Scalar node) {
      return settling
          .expressions()
          .alike(node, node.operands().stream().map(this::copied).toList());
    }
  }

  /** A law between two frames, of inputs. */
  private static final class OfPair implements Programs {
    private final PairLaw law;
    private final boolean smooth;

    OfPair(PairLaw law, boolean smooth) {
      this.law = law;
      this.smooth = smooth;
    }

    @Override
    public int variables() {
      return PairLaw.VARIABLES;
    }

    @Override
    public int coefficients() {
      return law.coefficientCount();
    }

    @Override
    public int settled() {
      return law.settledCount();
    }

    private PairLoad load(Program program) {
      program.section("The load by its formula.", "law");
      Frames x = Frames.ofInputs(program.expressions());
      program.named("r", x.displacement());
      program.named("R", x.rotation());
      program.named("omega", x.omega());
      program.named("u", x.rate());
      List<Scalar> c = new ArrayList<>();
      for (int i = 0; i < law.coefficientCount(); i++) {
        Expressions e = program.expressions();
        int at = PairLaw.VARIABLES + i;
        Scalar input = i == law.smoothing() ? smoothing(e, at, smooth) : e.input(at);
        c.add(program.named(law.symbols().get(i), input));
      }
      return law.of(x, c);
    }

    private static List<Scalar> wrench(PairLoad load) {
      List<Scalar> wrench = new ArrayList<>(load.moment().components());
      wrench.addAll(load.force().components());
      return wrench;
    }

    @Override
    public Program load() {
      Program program = new Program();
      PairLoad load = load(program);
      List<Scalar> wrench = wrench(load);
      for (int i = 0; i < 6; i++) {
        program.output(i, wrench.get(i));
      }
      Expressions e = program.expressions();
      Scalar direction =
          load.direction().map(d -> d.size().minus(e.constant(d.least()))).orElse(e.one());
      program.output(PairLaw.DIRECTION, direction);
      return program;
    }

    @Override
    public Program slopes() {
      Program program = new Program();
      List<Scalar> wrench = wrench(load(program));
      for (int j = 0; j < 12; j++) {
        program.section("Derivatives by motion " + (j + 1) + ".", "by" + (j + 1));
        Differentiation rates = new Differentiation(program.expressions(), motion(program, j));
        for (int i = 0; i < 6; i++) {
          Scalar slope = rates.of(wrench.get(i));
          if (!slope.isZero()) {
            program.output((j < 6 ? 0 : 30) + 6 * i + j, slope);
          }
        }
      }
      return program;
    }

    /** Returns the rates of the inputs: rotation, displacement, angular velocity, rate. */
    private static Map<Scalar, Scalar> motion(Program program, int direction) {
      Frames x = Frames.ofInputs(program.expressions());
      Scalar one = program.expressions().one();
      Map<Scalar, Scalar> rates = new HashMap<>();
      if (direction < 3) {
        // the axes of frame 2 turn by a unit vector × each
        for (int column = 0; column < 3; column++) {
          int next = (direction + 1) % 3;
          int last = (direction + 2) % 3;
          rates.put(x.rotation().at(next, column), x.rotation().at(last, column).negated());
          rates.put(x.rotation().at(last, column), x.rotation().at(next, column));
        }
      } else if (direction < 6) {
        rates.put(x.displacement().at(direction - 3), one);
      } else if (direction < 9) {
        rates.put(x.omega().at(direction - 6), one);
      } else {
        rates.put(x.rate().at(direction - 9), one);
      }
      return rates;
    }

    @Override
    public Program results() {
      Program program = new Program();
      PairLoad load = load(program);
      program.output(PairLaw.POTENTIAL, load.potential());
      program.output(PairLaw.POWER, load.power());
      for (int i = 0; i < load.values().size(); i++) {
        program.output(PairLaw.VALUES + i, load.values().get(i));
      }
      return program;
    }
  }

  /** A law on a coordinate, of inputs. */
  private static final class OfCoordinate implements Programs {
    private final CoordinateLaw law;
    private final boolean smooth;

    OfCoordinate(CoordinateLaw law, boolean smooth) {
      this.law = law;
      this.smooth = smooth;
    }

    @Override
    public int variables() {
      return CoordinateLaw.VARIABLES;
    }

    @Override
    public int coefficients() {
      return law.coefficientCount();
    }

    @Override
    public int settled() {
      return law.coefficientCount();
    }

    private CoordinateLoad load(Program program) {
      program.section("The load by its formula.", "law");
      Expressions e = program.expressions();
      List<Scalar> c = new ArrayList<>();
      for (int i = 0; i < law.coefficientCount(); i++) {
        int at = CoordinateLaw.VARIABLES + i;
        Scalar input = i == law.smoothing() ? smoothing(e, at, smooth) : e.input(at);
        c.add(program.named(law.symbols().get(i), input));
      }
      Scalar position = program.named("q", e.input(0));
      Scalar rate = program.named("v", e.input(1));
      return law.of(position, rate, c);
    }

    @Override
    public Program load() {
      Program program = new Program();
      program.output(0, load(program).force());
      return program;
    }

    @Override
    public Program slopes() {
      Program program = new Program();
      Scalar force = load(program).force();
      Expressions e = program.expressions();
      for (int i = 0; i < CoordinateLaw.VARIABLES; i++) {
        Scalar slope = new Differentiation(e, Map.of(e.input(i), e.one())).of(force);
        if (!slope.isZero()) {
          program.output(i, slope);
        }
      }
      return program;
    }

    @Override
    public Program results() {
      Program program = new Program();
      CoordinateLoad load = load(program);
      program.output(PairLaw.POTENTIAL, load.potential());
      program.output(PairLaw.POWER, load.power());
      return program;
    }
  }
}
