package org.mechservice.sim.emit.c;

import java.util.List;
import java.util.Locale;
import org.mechservice.sim.emit.source.JavaText;

/**
 * Writes the header of a model in C: its type, the sizes and names of its arrays, its functions.
 */
final class CHeader {
  private final CModel model;
  private final String name;
  private final int slots;
  private final StringBuilder text = new StringBuilder();

  /**
   * @param slots length of the workspace of an instance
   */
  CHeader(CModel model, int slots) {
    this.model = model;
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
    list("Outputs", "y", model.outputs());
    line(" */");
    line("#ifndef " + guard);
    line("#define " + guard);
    line("");
    line("/* Sizes: states, tunable parameters, inputs, outputs, event functions. */");
    line("enum {");
    line("  " + name + "_NX = " + model.states().size() + ",");
    line("  " + name + "_NP = " + model.parameters().size() + ",");
    line("  " + name + "_NU = 0,");
    line("  " + name + "_NY = " + model.outputs().size() + ",");
    line("  " + name + "_NG = 0");
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
    line(" * Set p before the start; the other members are the model's own.");
    line(" */");
    line("typedef struct {");
    line("  double p[" + Math.max(1, model.parameters().size()) + "];");
    line("  double u[1];");
    line("  double w[" + Math.max(1, slots) + "];");
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
        "outputs(@ *m, double t, const double *x, double *y)",
        "Evaluates the outputs. Returns 0.");
    function(
        "int",
        "energy(@ *m, double t, const double *x, double *energy)",
        "Evaluates kinetic and potential energy, J. Returns 0.");
    function(
        "int",
        "project(@ *m, double t, double *x)",
        "Normalises Euler parameters. Returns 1 if the state has any, else 0.");
    function(
        "int",
        "event_values(@ *m, double t, const double *x, double *g)",
        "Evaluates the event functions, of which this model has none. Returns 0.");
    function(
        "int",
        "event(@ *m, int event, int direction, double t, double *x)",
        "Changes the state at an event. Returns 0: nothing changed.");
    function("const char *", "failure(const @ *m)", "Returns why the last evaluation failed.");
    line("#endif");
    return text.toString();
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
