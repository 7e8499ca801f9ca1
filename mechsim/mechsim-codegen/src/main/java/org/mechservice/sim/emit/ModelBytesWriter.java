package org.mechservice.sim.emit;

import java.util.Arrays;
import java.util.List;
import org.mechservice.sim.emit.bytes.ClassMethods;
import org.mechservice.sim.emit.bytes.MethodSizes;
import org.mechservice.sim.emit.bytes.NumberInstructions;
import org.mechservice.sim.emit.bytes.ProgramBytes;
import org.mechservice.sim.emit.bytes.TextInstructions;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.ParameterSlots;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.MessageCode;
import org.objectweb.asm.ClassTooLargeException;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Writes the class of a model as a class file, without source and compiler. Its instructions are
 * those of the source that {@link ModelSourceWriter} writes.
 */
final class ModelBytesWriter {
  private static final String OBJECT = "java/lang/Object";
  private static final String STRING = "Ljava/lang/String;";
  private static final String DESCRIPTION = Type.getInternalName(ModelDescription.class);
  private static final String SETTINGS = Type.getInternalName(RunSettings.class);
  private static final String ACCURACY = Type.getInternalName(Accuracy.class);
  private static final String SIX_SETTINGS = "DDD" + STRING + "DD";

  private final ModelPlan plan;
  private final String className;
  private final ClassWriter classFile = new ClassWriter(ClassWriter.COMPUTE_MAXS);

  ModelBytesWriter(ModelPlan plan) {
    this.plan = plan;
    this.className = (ModelClass.PACKAGE + "." + plan.simpleName()).replace('.', '/');
  }

  /** Returns the class file. */
  byte[] bytes() {
    String[] interfaces = new String[plan.interfaces().size()];
    for (int i = 0; i < interfaces.length; i++) {
      interfaces[i] = Type.getInternalName(plan.interfaces().get(i));
    }
    int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER;
    String base = Type.getInternalName(plan.base().type());
    classFile.visit(Opcodes.V17, access, className, null, base, interfaces);
    if (!plan.constants().isEmpty()) {
      ProgramBytes.constants(classFile, className, plan.constants());
    }
    constructor();
    describe();
    method(plan.start(), ModelBytesWriter::fillWithZeros, (code, parameters) -> {});
    for (ModelPlan.Part part : plan.programs()) {
      method(part);
    }
    if (plan.poses().isPresent()) {
      bodies();
      method(plan.poses().get(), (code, parameters) -> {}, ModelBytesWriter::chooseSigns);
    }
    ForceColumnBytes forces = new ForceColumnBytes(classFile, className);
    if (plan.power().isPresent()) {
      method(plan.power().get());
    }
    if (plan.forces().isPresent()) {
      forces.columns(plan.forceNames(), plan.forceUnits());
      forces.values(plan.forceCount());
      method(plan.forces().get());
    }
    if (plan.directedForces().isPresent()) {
      directedForce(plan.directedForces().get());
    }
    if (plan.formulas().isPresent()) {
      formulas(plan.formulas().get());
    }
    classFile.visitEnd();
    return checked(classFile, plan.simpleName());
  }

  /** Returns the bytes of a class that is not too large. */
  static byte[] checked(ClassWriter classFile, String simpleName) {
    try {
      byte[] bytes = classFile.toByteArray();
      MethodSizes.requireCompilable(bytes);
      return bytes;
    } catch (ClassTooLargeException e) {
      throw new ModelBuildException(
          MessageCode.MODEL_CLASS_TOO_LARGE,
          "the generated class "
              + simpleName
              + " is too large for a class file ("
              + e.getConstantPoolCount()
              + " constants, the limit is 65535); use fewer bodies");
    }
  }

  private void method(ModelPlan.Part part) {
    method(part, (code, parameters) -> {}, (code, parameters) -> {});
  }

  private void method(ModelPlan.Part part, ProgramBytes.Extra first, ProgramBytes.Extra last) {
    new ProgramBytes(classFile, className, part.head(), part.plan()).method(first, last);
  }

  private void constructor() {
    int slots = plan.slots();
    String given = plan.takesNumbers() ? "([D)V" : "()V";
    MethodVisitor code = ClassMethods.beginPublic(classFile, "<init>", given);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    for (String argument : plan.base().arguments()) {
      code.visitLdcInsn(argument);
    }
    code.visitMethodInsn(
        Opcodes.INVOKESPECIAL,
        Type.getInternalName(plan.base().type()),
        "<init>",
        "(" + STRING.repeat(plan.base().arguments().size()) + ")V",
        false);
    if (slots > 0) {
      array(code, ParameterSlots.WORKSPACE, slots);
    }
    if (plan.takesNumbers()) {
      String field = MethodSignature.MODEL_PARAMETERS.name();
      field(field);
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitVarInsn(Opcodes.ALOAD, 1);
      code.visitFieldInsn(Opcodes.PUTFIELD, className, field, "[D");
    }
    if (plan.forces().isPresent()) {
      array(code, "forces", plan.forceCount());
    }
    ClassMethods.end(code, Opcodes.RETURN);
  }

  /** Writes {@code private final double[] name = new double[length]}. */
  private void array(MethodVisitor code, String name, int length) {
    field(name);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    new NumberInstructions(code).push(length);
    code.visitIntInsn(Opcodes.NEWARRAY, Opcodes.T_DOUBLE);
    code.visitFieldInsn(Opcodes.PUTFIELD, className, name, "[D");
  }

  private void field(String name) {
    int access = Opcodes.ACC_PRIVATE | Opcodes.ACC_FINAL;
    classFile.visitField(access, name, "[D", null, null).visitEnd();
  }

  private void describe() {
    ModelDescription description = plan.content().description();
    MethodVisitor code =
        ClassMethods.beginPublic(classFile, "description", "()L" + DESCRIPTION + ";");
    TextInstructions.push(code, description.name());
    code.visitLdcInsn(description.formulation());
    TextInstructions.push(code, plan.jointTypes());
    TextInstructions.push(code, plan.jointNames());
    code.visitTypeInsn(Opcodes.NEW, SETTINGS);
    code.visitInsn(Opcodes.DUP);
    String rest = (plan.boundsSteps() ? "DDI" : "") + (plan.hasOneTolerance() ? "" : "DDD");
    settings(code, description.defaults());
    code.visitMethodInsn(
        Opcodes.INVOKESPECIAL, SETTINGS, "<init>", "(" + SIX_SETTINGS + rest + ")V", false);
    if (!plan.isStandardAccuracy()) {
      accuracy(code, description.defaults().accuracy());
    }
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        DESCRIPTION,
        "of",
        "(" + STRING.repeat(4) + "L" + SETTINGS + ";)L" + DESCRIPTION + ";",
        false);
    List<String> further = plan.furtherStates();
    if (!further.isEmpty()) {
      further.forEach(text -> TextInstructions.push(code, text));
      code.visitMethodInsn(
          Opcodes.INVOKEVIRTUAL,
          DESCRIPTION,
          "withFurtherStates",
          "(" + STRING.repeat(3) + ")L" + DESCRIPTION + ";",
          false);
    }
    ClassMethods.end(code, Opcodes.ARETURN);
  }

  /** Writes {@code .withAccuracy(Accuracy.STRICT)}. */
  private static void accuracy(MethodVisitor code, Accuracy accuracy) {
    code.visitFieldInsn(Opcodes.GETSTATIC, ACCURACY, accuracy.name(), "L" + ACCURACY + ";");
    code.visitMethodInsn(
        Opcodes.INVOKEVIRTUAL,
        SETTINGS,
        "withAccuracy",
        "(L" + ACCURACY + ";)L" + SETTINGS + ";",
        false);
  }

  private void settings(MethodVisitor code, RunSettings settings) {
    NumberInstructions numbers = new NumberInstructions(code);
    numbers.push(settings.tStart());
    numbers.push(settings.tEnd());
    numbers.push(settings.tStep());
    code.visitLdcInsn(settings.integrator());
    numbers.push(settings.relativeTolerance());
    numbers.push(settings.absoluteTolerance());
    if (plan.boundsSteps()) {
      numbers.push(settings.maxStep());
      numbers.push(settings.initialStep());
      numbers.push(settings.maxOrder());
    }
    if (!plan.hasOneTolerance()) {
      numbers.push(settings.angleTolerance());
      numbers.push(settings.velocityTolerance());
      numbers.push(settings.angularVelocityTolerance());
    }
  }

  /** Writes {@code Arrays.fill(y, 0.0)}. */
  private static void fillWithZeros(MethodVisitor code, ParameterSlots parameters) {
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf("y"));
    code.visitInsn(Opcodes.DCONST_0);
    code.visitMethodInsn(Opcodes.INVOKESTATIC, "java/util/Arrays", "fill", "([DD)V", false);
  }

  /** Writes {@code return List.of("…".split(" ", -1))}. */
  private void bodies() {
    MethodVisitor code = ClassMethods.beginPublic(classFile, "bodies", "()Ljava/util/List;");
    TextInstructions.push(code, plan.bodyNames());
    code.visitLdcInsn("\n");
    code.visitInsn(Opcodes.ICONST_M1);
    code.visitMethodInsn(
        Opcodes.INVOKEVIRTUAL, "java/lang/String", "split", "(" + STRING + "I)[" + STRING, false);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC, "java/util/List", "of", "([L" + OBJECT + ";)Ljava/util/List;", true);
    ClassMethods.end(code, Opcodes.ARETURN);
  }

  /** Writes {@code return ("…").split(" ", -1)[force]}. */
  private void directedForce(String names) {
    MethodVisitor code = ClassMethods.beginPublic(classFile, "directedForce", "(I)" + STRING);
    TextInstructions.push(code, names);
    code.visitLdcInsn("\n");
    code.visitInsn(Opcodes.ICONST_M1);
    code.visitMethodInsn(
        Opcodes.INVOKEVIRTUAL, "java/lang/String", "split", "(" + STRING + "I)[" + STRING, false);
    code.visitVarInsn(Opcodes.ILOAD, 1);
    code.visitInsn(Opcodes.AALOAD);
    ClassMethods.end(code, Opcodes.ARETURN);
  }

  private void formulas(ModelPlan.Part part) {
    ModelClass.FormulaParts parts = plan.content().formulas().orElseThrow();
    MethodVisitor lines = ClassMethods.beginPublic(classFile, "formulas", "()" + STRING);
    TextInstructions.push(lines, parts.lines());
    ClassMethods.end(lines, Opcodes.ARETURN);
    MethodVisitor count = ClassMethods.beginPublic(classFile, "formulaCount", "()I");
    new NumberInstructions(count).push(parts.count());
    ClassMethods.end(count, Opcodes.IRETURN);
    method(part);
  }

  /** Writes code that chooses the set of Euler parameters with e0 ≥ 0. */
  private static void chooseSigns(MethodVisitor code, ParameterSlots parameters) {
    int poses = parameters.slotOf("poses");
    int i = parameters.end();
    Object[] atLoop = typesWithCounter(parameters);
    Label next = new Label();
    Label body = new Label();
    Label test = new Label();
    code.visitInsn(Opcodes.ICONST_3);
    code.visitVarInsn(Opcodes.ISTORE, i);
    code.visitJumpInsn(Opcodes.GOTO, test);
    code.visitLabel(body);
    code.visitFrame(Opcodes.F_NEW, atLoop.length, atLoop, 0, new Object[0]);
    code.visitVarInsn(Opcodes.ALOAD, poses);
    code.visitVarInsn(Opcodes.ILOAD, i);
    code.visitInsn(Opcodes.DALOAD);
    code.visitInsn(Opcodes.DCONST_0);
    code.visitInsn(Opcodes.DCMPG);
    code.visitJumpInsn(Opcodes.IFGE, next);
    for (int j = 0; j < 4; j++) {
      changeSign(code, poses, i, j);
    }
    code.visitLabel(next);
    code.visitFrame(Opcodes.F_NEW, atLoop.length, atLoop, 0, new Object[0]);
    code.visitIincInsn(i, BodyPoses.NUMBERS_PER_BODY);
    code.visitLabel(test);
    code.visitFrame(Opcodes.F_NEW, atLoop.length, atLoop, 0, new Object[0]);
    code.visitVarInsn(Opcodes.ILOAD, i);
    code.visitVarInsn(Opcodes.ALOAD, poses);
    code.visitInsn(Opcodes.ARRAYLENGTH);
    code.visitJumpInsn(Opcodes.IF_ICMPLT, body);
  }

  /** Writes {@code poses[i + j] = 0 - poses[i + j]}. */
  private static void changeSign(MethodVisitor code, int poses, int i, int j) {
    pushElement(code, poses, i, j);
    code.visitInsn(Opcodes.DCONST_0);
    pushElement(code, poses, i, j);
    code.visitInsn(Opcodes.DALOAD);
    code.visitInsn(Opcodes.DSUB);
    code.visitInsn(Opcodes.DASTORE);
  }

  /** Pushes the array and the index i + j. */
  private static void pushElement(MethodVisitor code, int array, int i, int j) {
    code.visitVarInsn(Opcodes.ALOAD, array);
    code.visitVarInsn(Opcodes.ILOAD, i);
    new NumberInstructions(code).push(j);
    code.visitInsn(Opcodes.IADD);
  }

  private static Object[] typesWithCounter(ParameterSlots parameters) {
    Object[] types = parameters.types().toArray();
    Object[] all = Arrays.copyOf(types, types.length + 1);
    all[types.length] = Opcodes.INTEGER;
    return all;
  }
}
