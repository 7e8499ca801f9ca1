package org.mechservice.sim.emit.c;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.NumberText;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.emit.plan.CodeLayout;
import org.mechservice.sim.emit.plan.ProgramPlan;
import org.mechservice.sim.emit.source.ProgramPrinter;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.DirectedForces;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.mechanism.force.ForceElement;

/** Writes the code of a model in C. */
final class CSource {
  private record Part(MethodSignature head, ProgramPlan plan) {}

  private final CModel model;
  private final String name;
  private final ConstantTable constants = new ConstantTable();
  private final List<Part> parts = new ArrayList<>();
  private final NumberText numbers = new NumberText();
  private final SourceLines source = new SourceLines();

  CSource(CModel model) {
    this.model = model;
    this.name = model.name();
    add("derivative", "dx", true, model.derivative());
    add(COutputs.ENERGIES, "energy", false, model.energy());
    for (COutputs group : model.groups()) {
      if (!group.name().equals(COutputs.ENERGIES)) {
        add(group.name(), "values", false, group.program());
      }
    }
  }

  private void add(String function, String output, boolean returnsResult, Program program) {
    List<MethodSignature.Argument> state =
        List.of(
            new MethodSignature.Argument("t", false, Program.TIME),
            new MethodSignature.Argument("x", true, 0));
    MethodSignature head = new MethodSignature(function, state, output, returnsResult, false);
    parts.add(new Part(head, CodeLayout.plan(program, head, CodeForm.AUTO, constants)));
  }

  /** Returns the length of the workspace that the instances need. */
  int slots() {
    return parts.stream().mapToInt(part -> part.plan().slots()).max().orElse(0);
  }

  String text() {
    source.line("#include \"" + name + ".h\"").blank();
    source.line("#include <math.h>");
    source.line("#include <string.h>").blank();
    source.line("#include \"mech_math.h\"").blank();
    source.line("enum { REGULAR = " + ExplicitModel.REGULAR + " };").blank();
    table("states", model.states());
    table("parameters", model.parameters());
    table("inputs", List.of());
    table("output_variables", model.outputs());
    if (!constants.isEmpty()) {
      source.line("static const double " + ConstantTable.FIELD + "[] = {");
      for (String text : constants.texts()) {
        source.line("    " + text.strip().replace(" ", ", ") + ",");
      }
      source.line("};").blank();
    }
    programs();
    start();
    derivatives();
    outputs();
    project();
    events();
    failure();
    return source.toString();
  }

  private void programs() {
    SourceLines functions = new SourceLines();
    List<String> prototypes = new ArrayList<>();
    for (Part part : parts) {
      ProgramPrinter printer =
          new ProgramPrinter(functions, part.head(), part.plan(), new CSyntax(name + "_t"));
      printer.method(List.of(), List.of());
      prototypes.addAll(printer.prototypes());
    }
    prototypes.forEach(prototype -> source.line(prototype + ";"));
    source.append(functions);
  }

  private void table(String array, List<CVariable> variables) {
    source.line("const " + name + "_variable_t " + name + "_" + array + "[] = {");
    for (CVariable one : variables) {
      source.line(
          "    {%s, %s, %s, %s},"
              .formatted(
                  literal(one.name()),
                  literal(one.unit()),
                  literal(one.description()),
                  numbers.of(one.start())));
    }
    if (variables.isEmpty()) {
      source.line("    {\"\", \"\", \"\", 0},");
    }
    source.line("};").blank();
  }

  /** Returns a literal in UTF-8 by octal escapes, which no following digit joins. */
  private static String literal(String text) {
    StringBuilder literal = new StringBuilder("\"");
    for (byte b : text.getBytes(StandardCharsets.UTF_8)) {
      boolean plain = b >= ' ' && b <= '~' && b != '"' && b != '\\' && b != '?';
      literal.append(plain ? Character.toString(b) : "\\%03o".formatted(b & 0xff));
    }
    return literal.append('"').toString();
  }

  private void open(String result, String function, String parameters) {
    source.blank().open(result + name + "_" + function + "(" + parameters + ")");
  }

  private String instance() {
    return name + "_t *m";
  }

  private void start() {
    open("void ", "init", instance());
    source.line("memset(m, 0, sizeof *m);");
    List<CVariable> parameters = model.parameters();
    for (int i = 0; i < parameters.size(); i++) {
      source.line("m->p[" + i + "] = " + numbers.of(parameters.get(i).start()) + ";");
    }
    source.close();
    open("int ", "start", instance() + ", double t0, double *x");
    source.line("(void)m;").line("(void)t0;");
    source.line("memset(x, 0, " + name + "_NX * sizeof(double));");
    double[] start = model.start();
    for (int i = 0; i < start.length; i++) {
      if (start[i] != 0) {
        source.line("x[" + i + "] = " + numbers.of(start[i]) + ";");
      }
    }
    source.line("return 0;").close();
  }

  private void derivatives() {
    open("int ", "derivatives", instance() + ", double t, const double *x, double *dx");
    source.line("m->failure = derivative(m, t, x, dx);");
    source.line("return m->failure == REGULAR ? 0 : -1;").close();
    open("int ", "energy", instance() + ", double t, const double *x, double *energy");
    source.line(COutputs.ENERGIES + "(m, t, x, energy);");
    source.line("return 0;").close();
  }

  private void outputs() {
    open("int ", "outputs", instance() + ", double t, const double *x, double *y");
    int at = 0;
    for (COutputs group : model.groups()) {
      source.line(group.name() + "(m, t, x, y + " + at + ");");
      if (group.poses()) {
        poses(at, group.variables().size());
      }
      at += group.variables().size();
    }
    if (at == 0) {
      source.line("(void)m;").line("(void)t;").line("(void)x;").line("(void)y;");
    }
    source.line("return 0;").close();
  }

  /** Of the two sets of Euler parameters of an orientation the one with e0 ≥ 0. */
  private void poses(int at, int count) {
    int first = at + 3;
    int step = BodyPoses.NUMBERS_PER_BODY;
    source.open("for (int i = " + first + "; i < " + (at + count) + "; i += " + step + ")");
    source.open("if (y[i] < 0)");
    source.open("for (int j = i; j < i + 4; j++)");
    source.line("y[j] = 0 - y[j];");
    source.close().close().close();
  }

  private void project() {
    List<Integer> sets = model.eulerParameters();
    open("int ", "project", instance() + ", double t, double *x");
    source.line("(void)m;").line("(void)t;");
    if (sets.isEmpty()) {
      source.line("(void)x;").line("return 0;").close();
      return;
    }
    source.line("static const int FIRST[] = {" + joined(sets) + "};");
    source.open("for (int i = 0; i < " + sets.size() + "; i++)");
    source.line("double *e = x + FIRST[i];");
    source.line("double norm = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);");
    source.open("for (int j = 0; j < 4; j++)").line("e[j] /= norm;").close();
    source.close();
    source.line("return 1;").close();
  }

  private static String joined(List<Integer> numbers) {
    return String.join(", ", numbers.stream().map(String::valueOf).toList());
  }

  private void events() {
    open("int ", "event_values", instance() + ", double t, const double *x, double *g");
    source.line("(void)m;").line("(void)t;").line("(void)x;").line("(void)g;");
    source.line("return 0;").close();
    open("int ", "event", instance() + ", int event, int direction, double t, double *x");
    source.line("(void)m;").line("(void)event;").line("(void)direction;");
    source.line("(void)t;").line("(void)x;");
    source.line("return 0;").close();
  }

  private void failure() {
    open("const char *", "failure", "const " + instance());
    List<String> joints = new ArrayList<>();
    for (JointVariables joint : model.description().joints()) {
      joints.add("beyond joint " + joint.name() + " there is no inertia for its motion");
    }
    List<String> forces = new ArrayList<>();
    for (ForceElement force : model.mechanism().forces()) {
      forces.add("force " + force.name() + " has no direction, as its points coincide");
    }
    texts("JOINTS", joints);
    texts("FORCES", forces);
    source.open("if (m->failure >= 0)").line("return JOINTS[m->failure];").close();
    source.open("if (m->failure <= " + DirectedForces.FIRST + ")");
    source.line("return FORCES[" + DirectedForces.FIRST + " - m->failure];").close();
    source.line("return \"nothing has failed\";").close();
  }

  private void texts(String array, List<String> texts) {
    source.line("static const char *const " + array + "[] = {");
    texts.forEach(text -> source.line("    " + literal(text) + ","));
    source.line("    \"\",").line("};");
  }
}
