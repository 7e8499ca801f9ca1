package org.mechservice.sim.emit.source;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.emit.method.AngleGroup;
import org.mechservice.sim.emit.method.CallSequence;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.IndexExpression;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.NumberText;
import org.mechservice.sim.emit.method.ParameterSlots;
import org.mechservice.sim.emit.method.Statement;
import org.mechservice.sim.emit.plan.ProgramPlan;

/** Writes a planned program as the methods of a class, or as functions. */
public final class ProgramPrinter {
  private final Syntax syntax;
  private SourceLines source;
  private final MethodSignature head;
  private final ProgramPlan plan;
  private final LocalNames names;
  private final List<List<AngleGroup>> angleParts;
  private final NumberText numbers = new NumberText();
  private final List<String> prototypes = new ArrayList<>();

  /** Prints Java. */
  public ProgramPrinter(SourceLines source, MethodSignature head, ProgramPlan plan) {
    this(source, head, plan, Syntax.JAVA);
  }

  /**
   * @param source receives the text
   */
  public ProgramPrinter(SourceLines source, MethodSignature head, ProgramPlan plan, Syntax syntax) {
    this.syntax = syntax;
    this.source = source;
    this.head = head;
    this.plan = plan;
    this.names = new LocalNames(plan, head, syntax.reserved());
    this.angleParts = plan.angleParts();
  }

  /** Writes the field that holds the constants of a class. */
  public static void constants(SourceLines source, ConstantTable constants) {
    List<String> texts = constants.texts();
    source.line("private static final double[] " + ConstantTable.FIELD + " =");
    source.line("    NumberTable.of(");
    source.line("        " + constants.size() + ",");
    for (int i = 0; i < texts.size(); i++) {
      String end = i + 1 < texts.size() ? "," : ");";
      source.line("        " + JavaText.literal(texts.get(i)) + end);
    }
  }

  /** Writes the method of the interface, with lines for its beginning and its end. */
  public void method(List<String> first, List<String> last) {
    source.blank();
    if (head.isPublic()) {
      source.line("@Override");
    }
    SourceLines whole = source;
    whole.open(
        syntax.head(
            head.isPublic() ? "public" : "private",
            head.returnsResult() ? "int" : "void",
            head.name(),
            parameters(head.arguments())));
    source = whole.sameIndentation();
    plan.fields().forEach(name -> source.line(syntax.field(name)));
    first.forEach(source::line);
    angles();
    if (!plan.angles().isEmpty()) {
      source.blank();
    }
    if (plan.isOneMethod()) {
      body(plan.methods().get(0));
    } else if (!plan.steps().isEmpty()) {
      steps();
    }
    last.forEach(source::line);
    if (head.returnsResult()) {
      source.line("return REGULAR;");
    }
    List<String> given = argumentNames(head.arguments());
    given.add(syntax.receiver());
    closeBody(whole, given);
    angleParts();
    if (!plan.isOneMethod()) {
      parts();
    }
  }

  /** Ends a body that was written apart, after what the language says of unused parameters. */
  private void closeBody(SourceLines whole, List<String> names) {
    syntax.unused(names, source.toString()).forEach(whole::line);
    whole.append(source).close();
    source = whole;
  }

  /**
   * Returns the lines that opened the parts of the program, for languages that need them before
   * their calls.
   */
  public List<String> prototypes() {
    return List.copyOf(prototypes);
  }

  private List<String> parameters(List<MethodSignature.Argument> arguments) {
    List<String> parameters = new ArrayList<>();
    for (MethodSignature.Argument argument : arguments) {
      parameters.add(
          argument.isArray() ? syntax.array(argument.name(), false) : "double " + argument.name());
    }
    parameters.add(syntax.array(head.output(), true));
    return parameters;
  }

  private List<String> argumentNames(List<MethodSignature.Argument> arguments) {
    List<String> names = new ArrayList<>();
    arguments.forEach(argument -> names.add(argument.name()));
    names.add(head.output());
    return names;
  }

  private ExpressionPrinter printer(MethodPlan method) {
    return new ExpressionPrinter(method, head, names, numbers, plan.constants(), syntax);
  }

  /** Writes the angles, or calls of the methods that compute them. */
  private void angles() {
    if (angleParts.isEmpty()) {
      angles(AngleGroup.of(plan.angles()));
    }
    for (int i = 0; i < angleParts.size(); i++) {
      call(head.anglesName(i) + "(" + names(plan.arguments(head)) + ")", false);
    }
  }

  private void angles(List<AngleGroup> runs) {
    ExpressionPrinter printer = printer(MethodPlan.EMPTY);
    for (AngleGroup run : runs) {
      if (run.isLoop()) {
        loop(run, printer);
      } else {
        String angle = printer.value(run.angle());
        source.line(syntax.sinCos(angle, Integer.toString(2 * run.start())));
      }
    }
  }

  private void loop(AngleGroup run, ExpressionPrinter printer) {
    int input = run.input().index();
    MethodSignature.Argument array = head.argumentOf(input);
    String factor = run.isMultiple() ? printer.value(run.factor()) + " * " : "";
    String angle = factor + array.name() + "[" + sum("i", input - array.first()) + "]";
    source.open("for (int i = 0; i < " + run.count() + "; i++)");
    source.line(syntax.sinCos(angle, sum("2 * i", 2 * run.start())));
    source.close();
  }

  private static String sum(String variable, int offset) {
    return offset == 0 ? variable : variable + " + " + offset;
  }

  /** Writes the main method of a program: its steps, or calls of the parts that contain them. */
  private void steps() {
    List<List<CallSequence>> parts = plan.parts();
    if (parts.size() == 1) {
      steps(parts.get(0));
      return;
    }
    declare(plan.steps());
    for (int i = 0; i < parts.size(); i++) {
      call(partName(i) + "(" + names(plan.arguments(head)) + ")", plan.checks(parts.get(i)));
    }
  }

  private String partName(int part) {
    return head.name() + "Part" + (part + 1);
  }

  private void declare(List<CallSequence> some) {
    if (plan.checks(some)) {
      source.line("int singular;");
    }
  }

  private void steps(List<CallSequence> some) {
    declare(some);
    for (CallSequence step : some) {
      if (step.isLoop()) {
        source.open("for (int i = 0; i < " + step.count() + "; i++)");
      }
      step.calls().forEach(this::call);
      if (step.isLoop()) {
        source.close();
      }
    }
  }

  private void call(CallSequence.Call call) {
    StringBuilder text = new StringBuilder(methodName(call.method())).append('(');
    text.append(names(plan.arguments(head)));
    for (int parameter = 0; parameter < call.numbers().size(); parameter++) {
      text.append(", ").append(call.text(parameter));
    }
    call(text.append(')').toString(), plan.checks(call));
  }

  /** Writes a call, with a check if it can end the program. */
  private void call(String call, boolean checks) {
    if (checks) {
      source.line("singular = " + call + ";");
      source.open("if (singular != REGULAR)").line("return singular;").close();
    } else {
      source.line(call + ";");
    }
  }

  private String methodName(int method) {
    return head.name() + (method + 1);
  }

  private String names(List<MethodSignature.Argument> arguments) {
    List<String> names = argumentNames(arguments);
    names.addAll(plan.fields());
    return String.join(", ", names);
  }

  private void angleParts() {
    for (int i = 0; i < angleParts.size(); i++) {
      int part = i;
      part(head.anglesName(i), false, 0, () -> angles(angleParts.get(part)));
    }
  }

  private void parts() {
    List<List<CallSequence>> parts = plan.parts();
    for (int i = 0; i < parts.size() && parts.size() > 1; i++) {
      boolean checks = plan.checks(parts.get(i));
      int part = i;
      part(partName(i), checks, 0, () -> steps(parts.get(part)));
    }
    for (int i = 0; i < plan.methods().size(); i++) {
      MethodPlan method = plan.methods().get(i);
      part(methodName(i), method.checks(), method.parameters(), () -> body(method));
    }
  }

  private void part(String name, boolean checks, int wholeNumbers, Runnable body) {
    List<String> parameters = parameters(plan.arguments(head));
    List<String> names = argumentNames(plan.arguments(head));
    for (String field : plan.fields()) {
      parameters.add(syntax.array(field, field.equals(ParameterSlots.WORKSPACE)));
      names.add(field);
    }
    for (int i = 0; i < wholeNumbers; i++) {
      parameters.add("int " + IndexExpression.name(i));
      names.add(IndexExpression.name(i));
    }
    String line = syntax.part(checks ? "int" : "void", name, parameters);
    prototypes.add(line);
    SourceLines whole = source.blank().open(line);
    source = whole.sameIndentation();
    body.run();
    if (checks) {
      source.line("return REGULAR;");
    }
    closeBody(whole, names);
  }

  private void body(MethodPlan method) {
    ExpressionPrinter printer = printer(method);
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
      source.line(
          (load.again() ? "" : "double ")
              + printer.name(load.value())
              + " = "
              + printer.place(load.from())
              + ";");
    } else if (statement instanceof Statement.Define define) {
      source.line(
          "double "
              + printer.name(define.value())
              + " = "
              + printer.operation(define.value())
              + ";");
    } else if (statement instanceof Statement.Store store) {
      store(store, printer);
    } else if (statement instanceof Statement.PutOut output) {
      source.line(
          head.output() + "[" + output.index() + "] = " + printer.value(output.value()) + ";");
    } else if (statement instanceof Statement.Put put) {
      source.line(printer.place(put.to()) + " = " + printer.value(put.value()) + ";");
    } else if (statement instanceof Statement.CopyInputs copy) {
      source.line(
          syntax.copy(
              head.argumentOf(copy.input()).name(),
              copy.input() - head.argumentOf(copy.input()).first(),
              head.output(),
              copy.index(),
              copy.count()));
    } else if (statement instanceof Statement.Check check) {
      check(check, printer);
    }
  }

  /** Writes a store; a comment names a value that is not named elsewhere in this method. */
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
    source.line("return " + check.result().text() + ";");
    source.close();
  }
}
