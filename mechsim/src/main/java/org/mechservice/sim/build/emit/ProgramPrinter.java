package org.mechservice.sim.build.emit;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.mechservice.sim.symbolic.Scalar;

/** Writes a planned program as Java methods. */
final class ProgramPrinter {
  /** Fewer angles in a row than this are written one by one. */
  static final int SHORTEST_LOOP = 3;

  private final SourceLines source;
  private final Head head;
  private final ProgramPlan plan;
  private final LocalNames names;
  private final NumberText numbers = new NumberText();

  ProgramPrinter(SourceLines source, Head head, ProgramPlan plan) {
    this.source = source;
    this.head = head;
    this.plan = plan;
    this.names = new LocalNames(plan);
  }

  /** Writes the method of the interface, with what goes to its beginning and before its end. */
  void method(List<String> first, List<String> last) {
    source.blank();
    if (head.isPublic()) {
      source.line("@Override");
    }
    source.open(
        (head.isPublic() ? "public " : "private ")
            + (head.returnsResult() ? "int " : "void ")
            + head.name()
            + "("
            + parameters(head.arguments())
            + ")");
    plan.fields().forEach(field -> source.line("double[] " + field + " = this." + field + ";"));
    first.forEach(source::line);
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
    if (head.returnsResult()) {
      source.line("return REGULAR;");
    }
    source.close();
    if (plan.methods().size() > 1) {
      parts();
    }
  }

  private String parameters(List<Head.Argument> arguments) {
    StringBuilder parameters = new StringBuilder();
    for (Head.Argument argument : arguments) {
      parameters.append(argument.isArray() ? "double[] " : "double ");
      parameters.append(argument.name()).append(", ");
    }
    return parameters.append("double[] ").append(head.output()).toString();
  }

  private ExpressionPrinter printer(Map<Scalar, Place> places) {
    return new ExpressionPrinter(places, head, names, numbers);
  }

  private void angles() {
    List<Scalar> angles = plan.angles();
    ExpressionPrinter printer = printer(Map.of());
    for (int i = 0; i < angles.size(); ) {
      int run = plan.runOfInputs(i);
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
    Head.Argument array = head.argumentOf(input);
    String angle = array.name() + "[" + sum("i", input - array.first()) + "]";
    source.open("for (int i = 0; i < " + count + "; i++)");
    source.line("SinCos.sinCos(" + angle + ", w, " + sum("2 * i", 2 * start) + ");");
    source.close();
  }

  private static String sum(String variable, int offset) {
    return offset == 0 ? variable : variable + " + " + offset;
  }

  /** The main method of a program in parts: one call each, until a part ends the program. */
  private void calls() {
    boolean declared = false;
    for (int i = 0; i < plan.methods().size(); i++) {
      String call = head.name() + (i + 1) + "(" + names(plan.arguments(head)) + ")";
      if (plan.methods().get(i).checks()) {
        source.line((declared ? "" : "int ") + "singular = " + call + ";");
        source.open("if (singular != REGULAR)").line("return singular;").close();
        declared = true;
      } else {
        source.line(call + ";");
      }
    }
  }

  private String names(List<Head.Argument> arguments) {
    StringBuilder list = new StringBuilder();
    for (Head.Argument argument : arguments) {
      list.append(argument.name()).append(", ");
    }
    list.append(head.output());
    plan.fields().forEach(field -> list.append(", ").append(field));
    return list.toString();
  }

  private void parts() {
    for (int i = 0; i < plan.methods().size(); i++) {
      MethodPlan part = plan.methods().get(i);
      source.blank();
      source.open(
          "private static "
              + (part.checks() ? "int " : "void ")
              + head.name()
              + (i + 1)
              + "("
              + parameters(plan.arguments(head))
              + plan.fields().stream().map(", double[] "::concat).collect(Collectors.joining())
              + ")");
      body(part);
      if (part.checks()) {
        source.line("return REGULAR;");
      }
      source.close();
    }
  }

  private void body(MethodPlan method) {
    ExpressionPrinter printer = printer(method.places());
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
      source.line("double " + names.of(load.value()) + " = " + printer.place(load.from()) + ";");
    } else if (statement instanceof Statement.Define define) {
      source.line(
          "double " + names.of(define.value()) + " = " + printer.operation(define.value()) + ";");
    } else if (statement instanceof Statement.Store store) {
      store(store, printer);
    } else if (statement instanceof Statement.PutOut output) {
      source.line(
          head.output() + "[" + output.index() + "] = " + printer.value(output.value()) + ";");
    } else if (statement instanceof Statement.CopyInputs copy) {
      source.line(
          "System.arraycopy(%s, %d, %s, %d, %d);"
              .formatted(
                  head.argumentOf(copy.input()).name(),
                  copy.input() - head.argumentOf(copy.input()).first(),
                  head.output(),
                  copy.index(),
                  copy.count()));
    } else if (statement instanceof Statement.Check check) {
      check(check, printer);
    }
  }

  /** A value that is nowhere else in this method is named in a comment. */
  private void store(Statement.Store store, ExpressionPrinter printer) {
    String value = printer.value(store.value());
    String name = names.of(store.value());
    if (!value.equals(name)) {
      source.comment(name);
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
