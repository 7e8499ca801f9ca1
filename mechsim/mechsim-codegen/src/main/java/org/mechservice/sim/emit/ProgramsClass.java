package org.mechservice.sim.emit;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.mechservice.sim.emit.bytes.ClassMethods;
import org.mechservice.sim.emit.bytes.NumberInstructions;
import org.mechservice.sim.emit.bytes.ProgramBytes;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.ParameterSlots;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.emit.plan.CodeLayout;
import org.mechservice.sim.emit.source.ProgramPrinter;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.symbol.Program;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * A planned class that contains only the methods of programs; one plan gives source and class file.
 * Both compute the same operations in the same order, so their results have the same bits.
 */
final class ProgramsClass implements GeneratedClass {
  private final String simpleName;
  private final List<String> documentation;
  private final List<Class<?>> interfaces;
  private final boolean hasUserForces;
  private final CodeForm form;
  private final ConstantTable constants = new ConstantTable();
  private final List<ModelPlan.Part> parts = new ArrayList<>();

  /**
   * @param documentation lines of the class comment
   * @param interfaces interfaces that the class implements
   * @param hasUserForces whether it receives loads of user forces
   */
  ProgramsClass(
      String simpleName,
      List<String> documentation,
      List<Class<?>> interfaces,
      boolean hasUserForces,
      CodeForm form) {
    this.simpleName = simpleName;
    this.documentation = List.copyOf(documentation);
    this.interfaces = List.copyOf(interfaces);
    this.hasUserForces = hasUserForces;
    this.form = form;
  }

  /** Adds a method of one of the interfaces. */
  void add(MethodSignature head, Program program) {
    parts.add(new ModelPlan.Part(head, CodeLayout.plan(program, head, form, constants)));
  }

  @Override
  public String simpleName() {
    return simpleName;
  }

  @Override
  public String code() {
    return ModelPlan.code(parts);
  }

  @Override
  public long plannedValues() {
    return ModelPlan.plannedValues(parts);
  }

  @Override
  public boolean takesNumbers() {
    return hasUserForces || ModelPlan.readNumbers(parts);
  }

  private int slots() {
    return parts.stream().mapToInt(part -> part.plan().slots()).max().orElse(0);
  }

  @Override
  public String source() {
    return source(ModelClass.PACKAGE);
  }

  /** Returns the source as a class of a package. */
  String source(String packageName) {
    SourceLines source = new SourceLines();
    source.line("package " + packageName + ";").blank();
    List<String> imports = new ArrayList<>();
    interfaces.forEach(type -> imports.add(outermost(type).getName()));
    if (slots() > 0 && parts.stream().anyMatch(part -> !part.plan().angles().isEmpty())) {
      imports.add("org.mechservice.solver.spatial.SinCos");
    }
    if (!constants.isEmpty()) {
      imports.add(ConstantTable.READER.getName());
    }
    ModelPlan.functionOwners(parts).forEach(owner -> imports.add(owner.replace('/', '.')));
    imports.stream().sorted().distinct().forEach(name -> source.line("import " + name + ";"));
    source.blank().documentation(documentation);
    String implemented =
        interfaces.stream().map(ProgramsClass::nameInSource).collect(Collectors.joining(", "));
    source.open("public final class " + simpleName + " implements " + implemented);
    if (!constants.isEmpty()) {
      ProgramPrinter.constants(source, constants);
    }
    if (slots() > 0) {
      source.line("private final double[] w = new double[" + slots() + "];");
    }
    if (takesNumbers()) {
      source.line("private final double[] p;");
      source.blank().open("public " + simpleName + "(double[] p)");
      source.line("this.p = p;").close();
    }
    for (ModelPlan.Part part : parts) {
      new ProgramPrinter(source, part.head(), part.plan()).method(List.of(), List.of());
    }
    return source.close().toString();
  }

  private static Class<?> outermost(Class<?> type) {
    Class<?> outer = type.getDeclaringClass();
    return outer == null ? type : outermost(outer);
  }

  private static String nameInSource(Class<?> type) {
    return type.getName().substring(type.getPackageName().length() + 1).replace('$', '.');
  }

  @Override
  public byte[] classFile() {
    ClassWriter file = new ClassWriter(ClassWriter.COMPUTE_MAXS);
    String name = (ModelClass.PACKAGE + "." + simpleName).replace('.', '/');
    int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER;
    String[] types = interfaces.stream().map(Type::getInternalName).toArray(String[]::new);
    file.visit(Opcodes.V17, access, name, null, "java/lang/Object", types);
    if (!constants.isEmpty()) {
      ProgramBytes.constants(file, name, constants);
    }
    constructor(file, name);
    for (ModelPlan.Part part : parts) {
      new ProgramBytes(file, name, part.head(), part.plan())
          .method((code, parameters) -> {}, (code, parameters) -> {});
    }
    file.visitEnd();
    return ModelBytesWriter.checked(file, simpleName);
  }

  private void constructor(ClassWriter file, String name) {
    String given = takesNumbers() ? "([D)V" : "()V";
    MethodVisitor code = ClassMethods.beginPublic(file, "<init>", given);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, "java/lang/Object", "<init>", "()V", false);
    if (slots() > 0) {
      field(file, ParameterSlots.WORKSPACE);
      code.visitVarInsn(Opcodes.ALOAD, 0);
      new NumberInstructions(code).push(slots());
      code.visitIntInsn(Opcodes.NEWARRAY, Opcodes.T_DOUBLE);
      code.visitFieldInsn(Opcodes.PUTFIELD, name, ParameterSlots.WORKSPACE, "[D");
    }
    if (takesNumbers()) {
      String parameters = MethodSignature.MODEL_PARAMETERS.name();
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
