package org.mechservice.sim.emit.c;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.mechservice.sim.emit.method.NumberText;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.DirectedForces;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.mechanism.force.ForceElement;

/** Writes the code of a model in C: what a program calls, around the {@link CPrograms}. */
final class CSource {
  /**
   * Failure of a model whose loops cannot be closed, and the first of velocities without inertia.
   */
  private static final int LOOPS_OPEN = 2_000_000;

  private static final int WITHOUT_INERTIA = 1_000_000;

  /** Number of rates that give a direction: of states, time and what the programs read. */
  private final int seeds;

  private final CModel model;
  private final Optional<CWatch> watch;
  private final String name;
  private final CPrograms programs;
  private final NumberText numbers = new NumberText();
  private final SourceLines source = new SourceLines();
  private final CArrays arrays = new CArrays(source, numbers);

  /**
   * @param watch what the steps of the model watch, if its code is to have it
   */
  CSource(CModel model, Optional<CWatch> watch) {
    this.model = model;
    this.watch = watch;
    this.name = model.name();
    seeds = model.states().size() + 1 + model.parameterSlots();
    programs = new CPrograms(model, watch);
  }

  /** Returns the length of the workspace that the instances need. */
  int slots() {
    return programs.slots();
  }

  String text() {
    source.line("#include \"" + name + ".h\"").blank();
    source.line("#include <float.h>").line("#include <math.h>");
    source.line("#include <string.h>").blank();
    source.line("#include \"mech_math.h\"").blank();
    source.line("enum { LOOPS_OPEN = " + LOOPS_OPEN + " };");
    source.line("enum { REGULAR = " + ExplicitModel.REGULAR + " };").blank();
    table("states", model.states());
    table("parameters", model.parameters());
    table("inputs", model.inputs().variables());
    table("output_variables", model.outputs());
    programs.write(source);
    inputs();
    if (model.motion() instanceof CLoops loops) {
      new CLoopLayout(model, loops, source, arrays, numbers).write();
    }
    CJumps jumps = new CJumps(model, source, arrays);
    jumps.times();
    start();
    derivatives();
    outputs();
    project();
    close();
    jumps.changes();
    watch.ifPresent(this::watched);
    failure();
    return source.toString();
  }

  private void table(String array, List<CVariable> variables) {
    source.line("const " + name + "_variable_t " + name + "_" + array + "[] = {");
    for (CVariable one : variables) {
      source.line(
          "    {%s, %s, %s, %s},"
              .formatted(
                  CArrays.literal(one.name()),
                  CArrays.literal(one.unit()),
                  CArrays.literal(one.description()),
                  numbers.of(one.start())));
    }
    if (variables.isEmpty()) {
      source.line("    {\"\", \"\", \"\", 0},");
    }
    source.line("};").blank();
  }

  private void open(String result, String function, String parameters) {
    source.blank().open(result + name + "_" + function + "(" + parameters + ")");
  }

  private String instance() {
    return name + "_t *m";
  }

  /** Writes where the programs read the inputs. */
  private void inputs() {
    if (!model.inputs().variables().isEmpty()) {
      arrays.integers("LOAD_OF", model.inputs().places());
      source.blank().open("static void take_inputs(" + instance() + ")");
      source.open("for (int i = 0; i < " + name + "_NU; i++)");
      source.line("m->p[" + name + "_NP + LOAD_OF[i]] = m->u[i];");
      source.close().close().blank();
    }
  }

  /** Writes that a function evaluates with the present inputs, beside a jump. */
  private void beside() {
    model.placeLines().forEach(source::line);
  }

  /** Writes that a function evaluates programs of a state with unwrapped angles behind it. */
  private void behind() {
    if (model.hasAngles()) {
      source.line("x = mech_loops_state(&LOOPS, m->loop, x);");
    }
  }

  private void start() {
    open("void ", "init", instance());
    source.line("memset(m, 0, sizeof *m);");
    source.line("m->failure = REGULAR;");
    source.line("m->went_on = -HUGE_VAL;");
    List<CVariable> parameters = model.parameters();
    for (int i = 0; i < parameters.size(); i++) {
      source.line("m->p[" + i + "] = " + numbers.of(parameters.get(i).start()) + ";");
    }
    List<CVariable> inputs = model.inputs().variables();
    for (int i = 0; i < inputs.size(); i++) {
      if (inputs.get(i).start() != 0) {
        source.line("m->u[" + i + "] = " + numbers.of(inputs.get(i).start()) + ";");
      }
    }
    if (model.motion() instanceof CLoops loops && loops.angles().isPresent()) {
      source.line("memcpy(m->loop, ANGLE_STARTS, sizeof ANGLE_STARTS);");
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
    beside();
    if (model.motion() instanceof CLoops) {
      source.line("return mech_loops_derivatives(&LOOPS, m, m->loop, t, x, dx, &m->failure);");
    } else {
      source.line("m->failure = derivative(m, t, x, dx);");
      source.line("return m->failure == REGULAR ? 0 : -1;");
    }
    source.close();
    tangents();
    open("int ", "energy", instance() + ", double t, const double *x, double *energy");
    beside();
    behind();
    source.line(COutputs.ENERGIES + "(m, t, x, energy);");
    source.line("return 0;").close();
  }

  /** Writes the derivative of x' along directions, and by the states. */
  private void tangents() {
    String open = instance() + ", double t, const double *x, ";
    String refresh = model.motion() instanceof CLoops ? ", int again" : "";
    source.blank().line("/* seed: rates of x, of t and of what the programs read behind. */");
    source.open(
        "static int derivative_along(" + open + "const double *seed, double *dx" + refresh + ")");
    if (model.motion() instanceof CLoops) {
      source.line(
          "return mech_loops_along(&LOOPS, m, m->loop, t, x, seed, again, dx, &m->failure);");
    } else {
      source.line("m->failure = " + CPrograms.TANGENT + "(m, t, x, seed, dx);");
      source.line("return m->failure == REGULAR ? 0 : -1;");
    }
    source.close();
    String more = refresh.isEmpty() ? "" : ", 0";
    open("int ", "directional", open + "const double *seed, double *dx");
    source.line("double all[" + seeds + "] = {0};");
    source.line("memcpy(all, seed, " + name + "_NX * sizeof(double));");
    if (!model.parameters().isEmpty()) {
      source.line(
          "memcpy(all + %1$s_NX + 1, seed + %1$s_NX, %1$s_NP * sizeof(double));".formatted(name));
    }
    if (!model.inputs().variables().isEmpty()) {
      source.open("for (int i = 0; i < " + name + "_NU; i++)");
      source.line(
          "all[%1$s_NX + 1 + %1$s_NP + LOAD_OF[i]] = seed[%1$s_NX + %1$s_NP + i];".formatted(name));
      source.close();
    }
    beside();
    source.line("return derivative_along(m, t, x, all, dx" + more + ");").close();
    open("int ", "jacobian", open + "double *jacobian");
    source.line("double seed[" + seeds + "] = {0}, column[" + name + "_NX + 1];");
    beside();
    source.open("for (int k = 0; k < " + name + "_NX; k++)");
    source.line("int result;");
    source.line("seed[k] = 1;");
    source.line(
        "result = derivative_along(m, t, x, seed, column"
            + (refresh.isEmpty() ? "" : ", k > 0")
            + ");");
    source.open("if (result < 0)").line("return result;").close();
    source.line("seed[k] = 0;");
    source.open("for (int i = 0; i < " + name + "_NX; i++)");
    source.line("jacobian[i * " + name + "_NX + k] = column[i];").close();
    source.close();
    source.line("return 0;").close();
  }

  private void outputs() {
    open("int ", "outputs", instance() + ", double t, const double *x, double *y");
    beside();
    if (!model.outputs().isEmpty()) {
      behind();
    }
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
    if (!sets.isEmpty()) {
      open("static void ", "normalize", "double *x");
      for (int first : sets) {
        source.line("mech_normalize(x + " + first + ");");
      }
      source.close();
    }
    open("int ", "project", instance() + ", double t, double *x");
    source.line("(void)m;").line("(void)t;");
    if (model.motion() instanceof CLoops) {
      beside();
      normalizeSets();
      closed("mech_loops_project(&LOOPS, m, m->loop, t, x, &m->failure)");
    } else if (sets.isEmpty()) {
      source.line("(void)x;").line("return 0;");
    } else {
      normalizeSets();
      source.line("return 1;");
    }
    source.close();
    open("void ", "accepted", instance() + ", double t, const double *x");
    if (model.motion() instanceof CLoops) {
      beside();
      source.line("mech_loops_accepted(&LOOPS, m, m->loop, t, x);");
    } else {
      source.line("(void)m;").line("(void)t;").line("(void)x;");
    }
    source.close();
  }

  private void normalizeSets() {
    if (!model.eulerParameters().isEmpty()) {
      source.line(name + "_normalize(x);");
    }
  }

  /** Writes a return with the result of closing loops. */
  private void closed(String call) {
    source.line("m->failure = LOOPS_OPEN;");
    source.open("if (" + call + " < 0)").line("return -1;").close();
    source.line("m->failure = REGULAR;").line("return 1;");
  }

  private void close() {
    open("int ", "close", instance() + ", double t, double *x, const unsigned char *set");
    if (model.motion() instanceof CLoops) {
      beside();
      normalizeSets();
      closed("mech_loops_close(&LOOPS, m, m->loop, t, x, set, &m->failure)");
    } else {
      source.line("(void)set;").line("return " + name + "_project(m, t, x);");
    }
    source.close();
    if (model.motion() instanceof CLoops) {
      complete();
    }
  }

  /** Writes the functions that separate independent coordinates from the others. */
  private void complete() {
    String given = "unsigned char *given";
    open(
        "int ",
        "complete",
        instance() + ", double t, double *x, const " + given + ", double *pivot");
    beside();
    normalizeSets();
    closed("mech_loops_complete(&LOOPS, m, m->loop, t, x, given, pivot)");
    source.close();
    open("int ", "choose", instance() + ", double t, const double *x, " + given);
    beside();
    source.line("return mech_loops_choose(&LOOPS, m, m->loop, t, x, given);").close();
  }

  /** Writes the functions of what a search of steps evaluates. */
  private void watched(CWatch watched) {
    quantities("watched", CPrograms.WATCHED);
    if (!watched.contacts().isEmpty()) {
      quantities("overlaps", CPrograms.OVERLAPS);
    }
  }

  private void quantities(String function, String program) {
    open("int ", function, instance() + ", double t, const double *x, double *values");
    beside();
    behind();
    source.line(program + "(m, t, x, values);").line("return 0;").close();
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
    arrays.texts("JOINTS", joints);
    arrays.texts("FORCES", forces);
    source.open("if (m->failure == LOOPS_OPEN)");
    source.line("return \"the closed loops cannot be closed, as near a singular position\";");
    source.close();
    if (model.events().jumps().stream().anyMatch(CEvents.Jump::impulse)) {
      source.open("if (m->failure == NO_IMPULSE)");
      source.line("return \"a prescribed velocity jumps, and a free coordinate has no inertia\";");
      source.close();
    }
    if (model.motion() instanceof CLoops) {
      arrays.integers("JOINT_OF", jointsOfVelocities());
      source.open("if (m->failure >= " + WITHOUT_INERTIA + ")");
      source.line("return JOINTS[JOINT_OF[m->failure - " + WITHOUT_INERTIA + "]];").close();
    }
    source.open("if (m->failure >= 0)").line("return JOINTS[m->failure];").close();
    source.open("if (m->failure <= " + DirectedForces.FIRST + ")");
    source.line("return FORCES[" + DirectedForces.FIRST + " - m->failure];").close();
    source.line("return \"\";").close();
  }

  private List<Integer> jointsOfVelocities() {
    List<JointVariables> joints = model.description().joints();
    return IntStream.range(0, joints.size())
        .flatMap(j -> IntStream.generate(() -> j).limit(joints.get(j).type().velocityCount()))
        .boxed()
        .toList();
  }
}
