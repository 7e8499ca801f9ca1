package org.mechservice.sim.emit.c;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.sim.emit.source.JavaText;

/**
 * Writes the header of a model in C: its type, the sizes and names of its arrays, its functions.
 */
final class CHeader {
  private final CModel model;
  private final String name;
  private final int slots;
  private final Optional<CWatch> watch;
  private final StringBuilder text = new StringBuilder();

  /**
   * @param slots length of the workspace of an instance
   * @param watch what the steps of the model watch, if its code has it
   */
  CHeader(CModel model, int slots, Optional<CWatch> watch) {
    this.model = model;
    this.watch = watch;
    this.slots = slots;
    this.name = model.name();
  }

  String text() {
    String guard = "MECH_" + name.toUpperCase(Locale.ROOT) + "_H";
    line("/*");
    line(" * Model \"" + comment(model.modelName()) + "\", generated. SI units: m, kg, s, rad, N.");
    line(" *");
    list("States x = [q; v; further states]", "x", model.states());
    list("Tunable parameters", "p", model.parameters());
    if (!model.inputs().variables().isEmpty()) {
      list("Inputs", "u", model.inputs().variables());
    }
    list("Outputs", "y", model.outputs());
    list(
        "Event functions, whose changes of sign are events",
        "g",
        model.events().names().stream()
            .map(event -> new CVariable(event, "", "event function", 0))
            .toList());
    line(" */");
    line("#ifndef " + guard);
    line("#define " + guard);
    line("");
    if (model.motion() instanceof CLoops) {
      line("#include \"mech_loops.h\"");
      line("");
    }
    line("/* Sizes: states, tunable parameters, inputs, outputs, event functions. */");
    line("enum {");
    line("  " + name + "_NX = " + model.states().size() + ",");
    line("  " + name + "_NP = " + model.parameters().size() + ",");
    line("  " + name + "_NU = " + model.inputs().variables().size() + ",");
    line("  " + name + "_NY = " + model.outputs().size() + ",");
    line("  " + name + "_NG = " + model.events().kinds().size());
    line("};");
    line("");
    line("/* An element of an array: its name, SI unit, what it is, its value at the start. */");
    line("typedef struct {");
    line("  const char *name;");
    line("  const char *unit;");
    line("  const char *description;");
    line("  double start;");
    line("} " + name + "_variable_t;");
    line("");
    for (String array : List.of("states", "parameters", "inputs", "output_variables")) {
      line("extern const " + name + "_variable_t " + name + "_" + array + "[];");
    }
    line("");
    line("/*");
    line(
        " * An instance. It holds no pointers: a copy of the structure is a copy of the instance.");
    line(
        " * Set p before the start, and u, if there are inputs; the other members are the"
            + " model's.");
    line(" */");
    line("typedef struct {");
    line("  double p[" + Math.max(1, model.parameterSlots()) + "];");
    line("  double u[" + Math.max(1, model.inputs().variables().size()) + "];");
    line("  double w[" + Math.max(1, slots) + "];");
    if (model.motion() instanceof CLoops loops) {
      int velocities = model.description().velocityCount();
      line(
          "  double loop[MECH_LOOPS_WORK(%d, %d, %d, %d)];"
              .formatted(
                  loops.rows(),
                  velocities,
                  loops.column().size(),
                  model.states().size() + 2 * loops.angleStarts().size()));
    }
    line("  double went_on;");
    line("  int failure;");
    line("} " + name + "_t;");
    line("");
    function("void", "init(@ *m)", "Sets parameters to their values in the model file.");
    function(
        "int", "start(@ *m, double t0, double *x)", "Writes the state at the start. Returns 0.");
    function(
        "int",
        "derivatives(@ *m, double t, const double *x, double *dx)",
        "Evaluates dx/dt. Returns 0, or -1 if the model is singular there: see failure.");
    function(
        "int",
        "directional(@ *m, double t, const double *x, const double *seed, double *dx)",
        "Evaluates the derivative of dx/dt along a direction: seed has the rates of x, of p and of"
            + " u, one behind the other. Returns as derivatives.");
    function(
        "int",
        "jacobian(@ *m, double t, const double *x, double *jacobian)",
        "Evaluates the derivatives of dx/dt by x, row after row: element i * NX + k is that of"
            + " dx[i]/dt by x[k]. Returns as derivatives.");
    function(
        "int",
        "outputs(@ *m, double t, const double *x, double *y)",
        "Evaluates the outputs. Returns 0.");
    function(
        "int",
        "energy(@ *m, double t, const double *x, double *energy)",
        "Evaluates kinetic and potential energy, J. Returns 0.");
    function(
        "int",
        "project(@ *m, double t, double *x)",
        "Moves the state onto the constraints after a step: Euler parameters, closed loops."
            + " Returns 0 if the model has none, 1, or -1 if the loops cannot be closed.");
    function(
        "int",
        "close(@ *m, double t, double *x, const unsigned char *set)",
        "Closes loops of a state that may be far from them, such as changed start values; what is"
            + " marked in set (NULL: nothing) is kept as far as possible. Returns as project.");
    if (model.motion() instanceof CLoops) {
      function(
          "int",
          "complete(@ *m, double t, double *x, const unsigned char *given, double *pivot)",
          "Computes all coordinates from those of the velocities that are marked in given (one"
              + " mark for each velocity), by Newton's method from the values that the others have."
              + " Returns 1, or -1 if that fails; *pivot tells how well they are determined: 0 not"
              + " at all, 1 best.");
      function(
          "int",
          "choose(@ *m, double t, const double *x, unsigned char *given)",
          "Marks velocities that determine all others at a state. Returns the number of others.");
    }
    function(
        "void",
        "accepted(@ *m, double t, const double *x)",
        "Records an accepted step, from which angles of cut joints are counted on.");
    function(
        "int",
        "event_values(@ *m, double t, const double *x, double *g)",
        "Evaluates the event functions. Returns 0.");
    function(
        "int",
        "event(@ *m, const signed char *occurred, double t, double *x)",
        "Changes the state at events: +1 for those whose functions have risen through zero, -1"
            + " for those that have fallen, else 0. Returns 1 if the state changed, plus 2 if the"
            + " run ends; or -1.");
    function(
        "double",
        "next_jump(const @ *m, double t)",
        "Returns the next time at which the equations jump or states are sampled, s; HUGE_VAL if there is none. No step"
            + " may pass it.");
    function(
        "int",
        "begin(@ *m, double t, double *x)",
        "Applies the samples at the start of a run to the state, loops closed. Returns 1 if it"
            + " changed, 0, or -1.");
    function(
        "int",
        "go_on(@ *m, double t, double *x)",
        "Records that the run goes on behind the jump at t, and changes the state there: samples,"
            + " and impulses where a prescribed velocity jumps. Returns 1 if the state changed, 0,"
            + " or -1.");
    watch.ifPresent(this::watched);
    function(
        "const char *",
        "failure(const @ *m)",
        "Returns why the last evaluation failed; empty if it did not.");
    line("#endif");
    return text.toString();
  }

  private void watched(CWatch watched) {
    function(
        "int",
        "watched(@ *m, double t, const double *x, double *values)",
        "Evaluates the quantities from which the watched formulas follow. Returns 0.");
    if (!watched.contacts().isEmpty()) {
      function(
          "int",
          "overlaps(@ *m, double t, const double *x, double *values)",
          "Evaluates how far the shapes of each contact are inside each other, and how far its law"
              + " means, m. Returns 0.");
    }
  }

  private void list(String title, String array, List<CVariable> variables) {
    line(" * " + title + ":" + (variables.isEmpty() ? " none." : ""));
    for (int i = 0; i < variables.size(); i++) {
      CVariable one = variables.get(i);
      String unit = one.unit().isEmpty() ? "" : ", " + comment(one.unit());
      line(" *   " + array + "[" + i + "]  " + comment(one.name()) + unit);
    }
    line(" *");
  }

  /** Returns ASCII text that does not end a comment. */
  static String comment(String text) {
    return JavaText.comment(text.replace("·", "*").replace("²", "^2"));
  }

  private void function(String result, String signature, String purpose) {
    line("/* " + purpose + " */");
    String space = result.endsWith("*") ? "" : " ";
    line(result + space + name + "_" + signature.replace("@", name + "_t") + ";");
    line("");
  }

  private void line(String line) {
    text.append(line).append('\n');
  }
}
