package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.closure.LoopTerms;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * The class of the terms of a model with loops, planned: one plan, from which source and class file
 * are printed. Both compute the same operations in the same order, so their results have the same
 * bits.
 */
public final class TermsPlan implements WrittenClass {
  private static final Head.Argument TIME = new Head.Argument("t", false, Program.TIME);
  private static final Head.Argument STATE = new Head.Argument("y", true, 0);
  private static final String TERMS = "terms";

  private final TermsClass content;
  private final CodeForm form;
  private final ConstantTable constants = new ConstantTable();
  private final List<ModelPlan.Part> parts = new ArrayList<>();
  private final int slots;

  private TermsPlan(TermsClass content, CodeForm form) {
    this.content = content;
    this.form = form;
    add(ofState("loops", TERMS, false), content.loops());
    add(ofState("equations", TERMS, true), content.equations());
    add(ofState("energy", "energy", false), content.energy());
    add(ofState("power", "power", false), content.power());
    content
        .ofResidual()
        .ifPresent(
            programs -> {
              Head.Argument given = new Head.Argument("a", true, content.stateCount());
              add(ofState("offset", TERMS, false), programs.offset());
              add(
                  new Head("residual", List.of(TIME, STATE, given), "residual", true, true),
                  programs.residual());
              programs
                  .derivatives()
                  .ifPresent(
                      derivatives ->
                          add(ofDerivatives(given, content.velocityCount()), derivatives));
            });
    slots = parts.stream().mapToInt(part -> part.plan().slots()).max().orElse(0);
  }

  private static Head ofState(String name, String output, boolean returnsResult) {
    return new Head(name, List.of(TIME, STATE), output, returnsResult, true);
  }

  /** Multipliers come behind the accelerations. */
  private static Head ofDerivatives(Head.Argument given, int velocities) {
    Head.Argument lambda = new Head.Argument("lambda", true, given.first() + velocities);
    return new Head("derivatives", List.of(TIME, STATE, given, lambda), "derivatives", true, true);
  }

  private void add(Head head, Program program) {
    parts.add(new ModelPlan.Part(head, Layout.plan(program, head, form, constants)));
  }

  /** Plans a class. */
  public static TermsPlan of(TermsClass content, CodeForm form) {
    return new TermsPlan(content, form);
  }

  @Override
  public String simpleName() {
    return JavaText.className(content.modelName());
  }

  @Override
  public String code() {
    return ModelPlan.code(parts);
  }

  private Class<?> type() {
    return content
        .ofResidual()
        .<Class<?>>map(
            programs ->
                programs.derivatives().isPresent()
                    ? LoopTerms.OfDerivatives.class
                    : LoopTerms.OfResidual.class)
        .orElse(LoopTerms.class);
  }

  @Override
  public String source() {
    SourceLines source = new SourceLines();
    source.line("package " + ModelClass.PACKAGE + ";").blank();
    List<String> imports = new ArrayList<>();
    imports.add(LoopTerms.class.getName());
    if (slots > 0) {
      imports.add("org.mechservice.solver.spatial.SinCos");
    }
    if (!constants.isEmpty()) {
      imports.add(ConstantTable.READER.getName());
    }
    ModelPlan.functionOwners(parts).forEach(owner -> imports.add(owner.replace('/', '.')));
    imports.stream().sorted().forEach(name -> source.line("import " + name + ";"));
    source.blank().documentation(documentation());
    String implemented = type().getName().replace('$', '.');
    source.open(
        "public final class "
            + simpleName()
            + " implements "
            + implemented.substring(LoopTerms.class.getPackageName().length() + 1));
    if (!constants.isEmpty()) {
      constants.write(source);
    }
    if (slots > 0) {
      source.line("private final double[] w = new double[" + slots + "];");
    }
    if (content.hasInputs()) {
      source.line("private final double[] p;");
      source.blank().open("public " + simpleName() + "(double[] p)");
      source.line("this.p = p;").close();
    }
    for (ModelPlan.Part part : parts) {
      new ProgramPrinter(source, part.head(), part.plan()).method(List.of(), List.of());
    }
    return source.close().toString();
  }

  private List<String> documentation() {
    List<String> lines = new ArrayList<>();
    lines.add(
        JavaText.comment(
            "Terms of the equations of motion of model \""
                + content.modelName()
                + "\", whose loops the solver closes; generated."));
    List<String> notes = new ArrayList<>(content.notes());
    content
        .derivatives()
        .ifPresent(program -> notes.add(program.operationCount() + " give its derivatives."));
    for (String note : notes) {
      lines.add("");
      lines.add("<p>" + JavaText.comment(note));
    }
    lines.add("");
    lines.add("<p>" + ModelSource.LEGEND);
    return lines;
  }

  @Override
  public byte[] classFile() {
    ClassWriter file = new ClassWriter(ClassWriter.COMPUTE_MAXS);
    String name = (ModelClass.PACKAGE + "." + simpleName()).replace('.', '/');
    int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER;
    String[] interfaces = {Type.getInternalName(type())};
    file.visit(Opcodes.V17, access, name, null, "java/lang/Object", interfaces);
    if (!constants.isEmpty()) {
      constants.write(file, name);
    }
    constructor(file, name);
    for (ModelPlan.Part part : parts) {
      new ProgramBytes(file, name, part.head(), part.plan())
          .method((code, parameters) -> {}, (code, parameters) -> {});
    }
    file.visitEnd();
    return ModelBytes.checked(file, simpleName());
  }

  private void constructor(ClassWriter file, String name) {
    String given = content.hasInputs() ? "([D)V" : "()V";
    MethodVisitor code = ClassMethods.beginPublic(file, "<init>", given);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, "java/lang/Object", "<init>", "()V", false);
    if (slots > 0) {
      field(file, Parameters.WORKSPACE);
      code.visitVarInsn(Opcodes.ALOAD, 0);
      new NumberCode(code).push(slots);
      code.visitIntInsn(Opcodes.NEWARRAY, Opcodes.T_DOUBLE);
      code.visitFieldInsn(Opcodes.PUTFIELD, name, Parameters.WORKSPACE, "[D");
    }
    if (content.hasInputs()) {
      String parameters = Head.MODEL_PARAMETERS.name();
      field(file, parameters);
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitVarInsn(Opcodes.ALOAD, 1);
      code.visitFieldInsn(Opcodes.PUTFIELD, name, parameters, "[D");
    }
    ClassMethods.end(code, Opcodes.RETURN);
  }

  private static void field(ClassWriter file, String name) {
    int access = Opcodes.ACC_PRIVATE | Opcodes.ACC_FINAL;
    file.visitField(access, name, "[D", null, null).visitEnd();
  }
}
