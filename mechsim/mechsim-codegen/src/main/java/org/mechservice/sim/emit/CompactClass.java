package org.mechservice.sim.emit;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.sim.emit.bytes.ClassMethods;
import org.mechservice.sim.emit.source.JavaText;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.analysis.ExtendedSource;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.UserForcedTerms;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.CompactSource;
import org.mechservice.solver.compact.DataDrivenLoops;
import org.mechservice.solver.compact.DataDrivenTree;
import org.mechservice.solver.dynamics.UserForcedModel;
import org.mechservice.solver.dynamics.UserLoads;
import org.mechservice.solver.dynamics.event.WrittenValues;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * A model's class in compact form. It holds the mechanism as data for the solver's data-driven
 * formulations, or it adds columns computed from data to a generated model.
 *
 * @param model the data
 * @param columns groups of columns computed from the data, separated by commas; empty for none
 * @param generated the generated class that is extended by columns; empty for a data-driven model
 * @param values the generated class of triggers and assignments of events and of outputs, if there
 *     is one
 * @param task the analysis, if the model is not integrated in time
 */
public record CompactClass(
    CompactModel model,
    String columns,
    Optional<GeneratedClass> generated,
    Optional<GeneratedClass> values,
    Optional<AnalysisTask> task)
    implements GeneratedClass {
  private static final String TEXT = "java/lang/String";
  private static final String TEXTS = "[Ljava/lang/String;";
  private static final String NOTHING_TO_VOID = "()V";
  private static final String VALUES =
      "(" + Type.getDescriptor(CompactModel.class) + ")" + Type.getDescriptor(Optional.class);
  private static final String BARE =
      "("
          + Type.getDescriptor(CompactModel.class)
          + Type.getDescriptor(UserForceSource.class)
          + ")Ljava/lang/Object;";

  @Override
  public String simpleName() {
    String name = JavaText.className(model.mechanism().name());
    if (generated.isEmpty()) {
      return name;
    }
    return name + (columns.isEmpty() ? "WithData" : "WithColumns");
  }

  @Override
  public String code() {
    return "none: data for the solver";
  }

  private Class<?> base() {
    return task.<Class<?>>map(AnalysisTask::source)
        .orElse(columns.isEmpty() ? CompactSource.class : ExtendedSource.class);
  }

  /** Returns the texts from which the base class is constructed. */
  private List<String> arguments() {
    return task.map(asked -> List.of(asked.options(), columns))
        .orElse(columns.isEmpty() ? List.of() : List.of(columns));
  }

  @Override
  public String source() {
    SourceLines source = new SourceLines();
    source.line("package " + ModelClass.PACKAGE + ";").blank();
    source.line("import " + base().getName() + ";");
    if (task.isEmpty()) {
      source.line("import " + CompactModel.class.getName() + ";");
      source.line("import " + UserForceSource.class.getName() + ";");
      if (generated.isEmpty() || hasLoops()) {
        source.line("import " + dataDriven().getName() + ";");
      }
      if (generated.isPresent() && hasUserForces()) {
        source.line("import " + forced().getName() + ";");
        source.line("import " + UserLoads.class.getName() + ";");
      }
    }
    if (values.isPresent()) {
      source.line("import " + Optional.class.getName() + ";");
      source.line("import " + WrittenValues.class.getName() + ";");
    }
    source.blank();
    source.documentation(
        List.of(
            JavaText.comment("Model \"" + model.mechanism().name() + "\" in compact form: data.")));
    source.open("public final class " + simpleName() + " extends " + base().getSimpleName());
    if (!arguments().isEmpty()) {
      source.open("public " + simpleName() + "()");
      source.line(
          arguments().stream()
              .map(CompactClass::literal)
              .collect(Collectors.joining(", ", "super(", ");")));
      source.close().blank();
    }
    if (task.isEmpty() && generated.isEmpty()) {
      source.line("@Override");
      source.open("protected Object bare(CompactModel data, UserForceSource userForces)");
      source.line("return " + dataDriven().getSimpleName() + ".model(data, userForces);");
      source.close().blank();
    }
    if (generated.isPresent()) {
      source.line("@Override");
      source.open("protected Object bare(CompactModel data, UserForceSource userForces)");
      String code = made(generated.get());
      if (hasUserForces()) {
        source.line("double[] p = UserLoads.inputs(data.mechanism());");
        code =
            forced().getSimpleName()
                + ".of(new "
                + generated.get().simpleName()
                + "(p), p, data.mechanism(), userForces)";
      }
      String made = hasLoops() ? "DataDrivenLoops.model(data, userForces, " : "data.watched(";
      source.line("return " + made + code + ", values(data));");
      source.close().blank();
    }
    if (values.isPresent()) {
      source.line("@Override");
      source.open("protected Optional<WrittenValues> values(CompactModel data)");
      source.line("return Optional.of(" + made(values.get()) + ");");
      source.close().blank();
    }
    source.line("@Override").open("protected String[] texts()");
    source.line("return new String[] {");
    for (String text : model.texts()) {
      source.line("  " + literal(text) + ",");
    }
    source.line("};");
    source.close();
    return source.close().toString();
  }

  private static String made(GeneratedClass written) {
    String given = written.takesNumbers() ? "data.parameterValues()" : "";
    return "new " + written.simpleName() + "(" + given + ")";
  }

  /** Returns a literal on one line of any length; the data need not be readable. */
  private static String literal(String text) {
    StringBuilder literal = new StringBuilder("\"");
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c >= ' ' && c < 0x7f && c != '"' && c != '\\') {
        literal.append(c);
      } else {
        // Octal, not Unicode, escapes: the compiler replaces Unicode escapes before it finds
        // literals.
        literal.append('\\').append(Integer.toOctalString(01000 | c).substring(1));
      }
    }
    return literal.append('"').toString();
  }

  @Override
  public byte[] classFile() {
    ClassWriter file = new ClassWriter(ClassWriter.COMPUTE_MAXS);
    file.visit(
        Opcodes.V17,
        Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER,
        internal(simpleName()),
        null,
        Type.getInternalName(base()),
        null);
    constructor(file);
    if (generated.isPresent()) {
      bare(file, generated.get());
    } else if (task.isEmpty()) {
      bare(file);
    }
    if (values.isPresent()) {
      values(file, values.get());
    }
    texts(file);
    file.visitEnd();
    return file.toByteArray();
  }

  /**
   * Returns whether the model has loops; its generated class then has only the terms of its
   * equations.
   */
  private boolean hasLoops() {
    return !model.mechanism().closures().isEmpty();
  }

  private boolean hasUserForces() {
    return ModelClass.hasUserForces(model.mechanism());
  }

  /** Returns the solver class that evaluates user forces before the code. */
  private Class<?> forced() {
    return hasLoops() ? UserForcedTerms.class : UserForcedModel.class;
  }

  @Override
  public long plannedValues() {
    return 0;
  }

  @Override
  public boolean takesNumbers() {
    return false;
  }

  private static String internal(String simpleName) {
    return (ModelClass.PACKAGE + "." + simpleName).replace('.', '/');
  }

  private void constructor(ClassWriter file) {
    MethodVisitor code = ClassMethods.begin(file, Opcodes.ACC_PUBLIC, "<init>", NOTHING_TO_VOID);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    arguments().forEach(code::visitLdcInsn);
    String texts = ("L" + TEXT + ";").repeat(arguments().size());
    code.visitMethodInsn(
        Opcodes.INVOKESPECIAL, Type.getInternalName(base()), "<init>", "(" + texts + ")V", false);
    ClassMethods.end(code, Opcodes.RETURN);
  }

  /** Returns the solver class that evaluates the data. */
  private Class<?> dataDriven() {
    return hasLoops() ? DataDrivenLoops.class : DataDrivenTree.class;
  }

  private void bare(ClassWriter file) {
    MethodVisitor code = ClassMethods.begin(file, Opcodes.ACC_PROTECTED, "bare", BARE);
    code.visitVarInsn(Opcodes.ALOAD, 1);
    code.visitVarInsn(Opcodes.ALOAD, 2);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        Type.getInternalName(dataDriven()),
        "model",
        BARE.substring(0, BARE.indexOf(')') + 1) + Type.getDescriptor(Model.class),
        false);
    ClassMethods.end(code, Opcodes.ARETURN);
  }

  private void bare(ClassWriter file, GeneratedClass equations) {
    MethodVisitor code = ClassMethods.begin(file, Opcodes.ACC_PROTECTED, "bare", BARE);
    String data = Type.getInternalName(CompactModel.class);
    String model = Type.getDescriptor(Model.class);
    code.visitVarInsn(Opcodes.ALOAD, 1);
    if (hasLoops()) {
      code.visitVarInsn(Opcodes.ALOAD, 2);
    }
    if (hasUserForces()) {
      forced(code, data, equations);
    } else {
      made(code, equations);
    }
    String given =
        hasLoops()
            ? Type.getDescriptor(CompactModel.class)
                + Type.getDescriptor(UserForceSource.class)
                + Type.getDescriptor(LoopTerms.class)
            : model;
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitVarInsn(Opcodes.ALOAD, 1);
    code.visitMethodInsn(Opcodes.INVOKEVIRTUAL, internal(simpleName()), "values", VALUES, false);
    code.visitMethodInsn(
        hasLoops() ? Opcodes.INVOKESTATIC : Opcodes.INVOKEVIRTUAL,
        hasLoops() ? Type.getInternalName(DataDrivenLoops.class) : data,
        hasLoops() ? "model" : "watched",
        "(" + given + Type.getDescriptor(Optional.class) + ")" + model,
        false);
    ClassMethods.end(code, Opcodes.ARETURN);
  }

  private static void values(ClassWriter file, GeneratedClass written) {
    MethodVisitor code = ClassMethods.begin(file, Opcodes.ACC_PROTECTED, "values", VALUES);
    made(code, written);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        Type.getInternalName(Optional.class),
        "of",
        "(Ljava/lang/Object;)" + Type.getDescriptor(Optional.class),
        false);
    ClassMethods.end(code, Opcodes.ARETURN);
  }

  /** Pushes the generated object combined with user forces. */
  private void forced(MethodVisitor code, String data, GeneratedClass equations) {
    String mechanism = Type.getDescriptor(Mechanism.class);
    String inputs = Type.getInternalName(UserLoads.class);
    String coded = Type.getDescriptor(hasLoops() ? LoopTerms.class : ExplicitModel.class);
    String source = Type.getDescriptor(UserForceSource.class);
    code.visitVarInsn(Opcodes.ALOAD, 1);
    code.visitMethodInsn(Opcodes.INVOKEVIRTUAL, data, "mechanism", "()" + mechanism, false);
    code.visitMethodInsn(Opcodes.INVOKESTATIC, inputs, "inputs", "(" + mechanism + ")[D", false);
    code.visitVarInsn(Opcodes.ASTORE, 3);
    code.visitTypeInsn(Opcodes.NEW, internal(equations.simpleName()));
    code.visitInsn(Opcodes.DUP);
    code.visitVarInsn(Opcodes.ALOAD, 3);
    code.visitMethodInsn(
        Opcodes.INVOKESPECIAL, internal(equations.simpleName()), "<init>", "([D)V", false);
    code.visitVarInsn(Opcodes.ALOAD, 3);
    code.visitVarInsn(Opcodes.ALOAD, 1);
    code.visitMethodInsn(Opcodes.INVOKEVIRTUAL, data, "mechanism", "()" + mechanism, false);
    code.visitVarInsn(Opcodes.ALOAD, 2);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        Type.getInternalName(forced()),
        "of",
        "(" + coded + "[D" + mechanism + source + ")" + coded,
        false);
  }

  /** Pushes an instance of a generated class. */
  private static void made(MethodVisitor code, GeneratedClass written) {
    String type = internal(written.simpleName());
    code.visitTypeInsn(Opcodes.NEW, type);
    code.visitInsn(Opcodes.DUP);
    if (written.takesNumbers()) {
      code.visitVarInsn(Opcodes.ALOAD, 1);
      code.visitMethodInsn(
          Opcodes.INVOKEVIRTUAL,
          Type.getInternalName(CompactModel.class),
          "parameterValues",
          "()[D",
          false);
    }
    String given = written.takesNumbers() ? "([D)V" : NOTHING_TO_VOID;
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, type, "<init>", given, false);
  }

  private void texts(ClassWriter file) {
    MethodVisitor code = ClassMethods.begin(file, Opcodes.ACC_PROTECTED, "texts", "()" + TEXTS);
    List<String> texts = model.texts();
    code.visitLdcInsn(texts.size());
    code.visitTypeInsn(Opcodes.ANEWARRAY, TEXT);
    for (int i = 0; i < texts.size(); i++) {
      code.visitInsn(Opcodes.DUP);
      code.visitLdcInsn(i);
      code.visitLdcInsn(texts.get(i));
      code.visitInsn(Opcodes.AASTORE);
    }
    ClassMethods.end(code, Opcodes.ARETURN);
  }
}
