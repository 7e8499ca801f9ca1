package org.mechservice.sim.build.emit;

import java.util.List;
import java.util.Map;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Scalar;

/** Writes a planned program as Java methods. */
final class ProgramPrinter {
  /** Fewer angles in a row than this are written one by one. */
  private static final int SHORTEST_LOOP = 3;

  private final SourceLines source;
  private final String name;
  private final String outputArray;
  private final ProgramPlan plan;
  private final boolean returnsResult;
  private final NumberText numbers = new NumberText();

  /**
   * @param name name of the method, and the beginning of those of its parts
   * @param outputArray name of its last parameter
   */
  ProgramPrinter(SourceLines source, String name, String outputArray, ProgramPlan plan) {
    this.source = source;
    this.name = name;
    this.outputArray = outputArray;
    this.plan = plan;
    this.returnsResult = name.equals("derivative");
  }

  /** Writes the method of the interface; {@code last} goes before its end. */
  void method(List<String> last) {
    source.blank().line("@Override");
    source.open(
        "public "
            + (returnsResult ? "int " : "void ")
            + name
            + "(double t, double[] y, double[] "
            + outputArray
            + ")");
    if (plan.slots() > 0) {
      source.line("double[] w = this.w;");
    }
    angles();
    if (!plan.angles().isEmpty()) {
      source.blank();
    }
    if (plan.methods().size() == 1) {
      body(plan.methods().get(0));
    } else {
      calls();
    }
    last.forEach(source::line);
    if (returnsResult) {
      source.line("return REGULAR;");
    }
    source.close();
    if (plan.methods().size() > 1) {
      parts();
    }
  }

  private void angles() {
    List<Scalar> angles = plan.angles();
    ExpressionPrinter printer = new ExpressionPrinter(Map.of(), "y", numbers);
    for (int i = 0; i < angles.size(); ) {
      int run = runOfInputs(i);
      if (run >= SHORTEST_LOOP) {
        loop(i, run);
        i += run;
      } else {
        String angle = printer.value(angles.get(i));
        source.line("SinCos.sinCos(" + angle + ", w, " + 2 * i + ");");
        i++;
      }
    }
  }

  private void loop(int start, int count) {
    int input = plan.angles().get(start).index();
    source.open("for (int i = 0; i < " + count + "; i++)");
    source.line("SinCos.sinCos(y[" + sum("i", input) + "], w, " + sum("2 * i", 2 * start) + ");");
    source.close();
  }

  private static String sum(String variable, int offset) {
    return offset == 0 ? variable : variable + " + " + offset;
  }

  private int runOfInputs(int start) {
    int run = 0;
    for (int i = start; i < plan.angles().size(); i++) {
      Scalar angle = plan.angles().get(i);
      if (angle.operation() != Operation.INPUT
          || angle.index() != plan.angles().get(start).index() + run) {
        return run;
      }
      run++;
    }
    return run;
  }

  /** The main method of a program in parts: one call each, until a part ends the program. */
  private void calls() {
    boolean declared = false;
    for (int i = 0; i < plan.methods().size(); i++) {
      String call = name + (i + 1) + "(y, " + outputArray + ", w)";
      if (plan.methods().get(i).checks()) {
        source.line((declared ? "" : "int ") + "singular = " + call + ";");
        source.open("if (singular != REGULAR)").line("return singular;").close();
        declared = true;
      } else {
        source.line(call + ";");
      }
    }
  }

  private void parts() {
    for (int i = 0; i < plan.methods().size(); i++) {
      MethodPlan part = plan.methods().get(i);
      source.blank();
      source.open(
          "private static "
              + (part.checks() ? "int " : "void ")
              + name
              + (i + 1)
              + "(double[] y, double[] "
              + outputArray
              + ", double[] w)");
      body(part);
      if (part.checks()) {
        source.line("return REGULAR;");
      }
      source.close();
    }
  }

  private void body(MethodPlan method) {
    ExpressionPrinter printer = new ExpressionPrinter(method.places(), "y", numbers);
    boolean first = true;
    for (Statement statement : method.statements()) {
      if (statement instanceof Statement.Comment comment) {
        if (!first) {
          source.blank();
        }
        source.comment(JavaText.comment(comment.text()));
      } else {
        statement(statement, printer);
      }
      first = false;
    }
  }

  private void statement(Statement statement, ExpressionPrinter printer) {
    if (statement instanceof Statement.Load load) {
      source.line("double " + load.local() + " = " + printer.place(load.from()) + ";");
    } else if (statement instanceof Statement.Define define) {
      source.line("double " + define.local() + " = " + printer.operation(define.value()) + ";");
    } else if (statement instanceof Statement.Store store) {
      store(store, printer);
    } else if (statement instanceof Statement.PutOut output) {
      source.line(
          outputArray + "[" + output.index() + "] = " + printer.value(output.value()) + ";");
    } else if (statement instanceof Statement.CopyInputs copy) {
      source.line(
          "System.arraycopy(y, %d, %s, %d, %d);"
              .formatted(copy.input(), outputArray, copy.index(), copy.count()));
    } else if (statement instanceof Statement.Check check) {
      check(check, printer);
    }
  }

  /** A value that is nowhere else in this method is named in a comment. */
  private void store(Statement.Store store, ExpressionPrinter printer) {
    String value = printer.value(store.value());
    if (!value.equals(store.name())) {
      source.comment(store.name());
    }
    source.line("w[" + store.slot() + "] = " + value + ";");
  }

  private void check(Statement.Check check, ExpressionPrinter printer) {
    source.comment(JavaText.comment(check.meaning()));
    source.open(
        "if (" + printer.value(check.pivot()) + " <= " + printer.value(check.bound()) + ")");
    source.line("return " + check.result() + ";");
    source.close();
  }
}
