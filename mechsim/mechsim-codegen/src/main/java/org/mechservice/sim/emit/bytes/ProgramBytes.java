package org.mechservice.sim.emit.bytes;

import java.util.List;
import org.mechservice.sim.emit.method.AngleGroup;
import org.mechservice.sim.emit.method.CallSequence;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.LocalSlots;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.ParameterSlots;
import org.mechservice.sim.emit.method.StackCode;
import org.mechservice.sim.emit.plan.ProgramPlan;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Writes a planned program as methods of a class file: the same methods as its printer writes as
 * Java source.
 */
public final class ProgramBytes {
  private final ClassVisitor classFile;
  private final String className;
  private final MethodSignature head;
  private final ProgramPlan plan;
  private final List<String> fields;
  private final List<List<AngleGroup>> angleParts;

  /**
   * @param className internal name of the class
   */
  public ProgramBytes(
      ClassVisitor classFile, String className, MethodSignature head, ProgramPlan plan) {
    this.classFile = classFile;
    this.className = className;
    this.head = head;
    this.plan = plan;
    this.fields = plan.fields();
    this.angleParts = plan.angleParts();
  }

  /** Writes the field that holds the constants of a class, and the code that fills it. */
  public static void constants(ClassVisitor file, String className, ConstantTable constants) {
    int access = Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_FINAL;
    file.visitField(access, ConstantTable.FIELD, "[D", null, null).visitEnd();
    MethodVisitor code = ClassMethods.begin(file, Opcodes.ACC_STATIC, "<clinit>", "()V");
    NumberInstructions push = new NumberInstructions(code);
    List<String> texts = constants.texts();
    push.push(constants.size());
    push.push(texts.size());
    code.visitTypeInsn(Opcodes.ANEWARRAY, "java/lang/String");
    for (int i = 0; i < texts.size(); i++) {
      code.visitInsn(Opcodes.DUP);
      push.push(i);
      code.visitLdcInsn(texts.get(i));
      code.visitInsn(Opcodes.AASTORE);
    }
    String owner = Type.getInternalName(ConstantTable.READER);
    String descriptor = "(I[Ljava/lang/String;)[D";
    code.visitMethodInsn(Opcodes.INVOKESTATIC, owner, "of", descriptor, false);
    code.visitFieldInsn(Opcodes.PUTSTATIC, className, ConstantTable.FIELD, "[D");
    ClassMethods.end(code, Opcodes.RETURN);
  }

  /** Writes further instructions at the beginning or before the end of the interface's method. */
  public interface Extra {
    void write(MethodVisitor code, ParameterSlots parameters);
  }

  /** Writes the method of the interface and its parts. */
  public void method(Extra first, Extra last) {
    ParameterSlots parameters = ParameterSlots.ofInstance(head, className, fields);
    String descriptor = ParameterSlots.descriptor(head.arguments(), "[D", head.returnsResult());
    MethodVisitor code =
        ClassMethods.begin(
            classFile,
            head.isPublic() ? Opcodes.ACC_PUBLIC : Opcodes.ACC_PRIVATE,
            head.name(),
            descriptor);
    for (String field : fields) {
      if (field.equals(ConstantTable.NAME)) {
        code.visitFieldInsn(Opcodes.GETSTATIC, className, ConstantTable.FIELD, "[D");
      } else {
        code.visitVarInsn(Opcodes.ALOAD, 0);
        code.visitFieldInsn(Opcodes.GETFIELD, className, field, "[D");
      }
      code.visitVarInsn(Opcodes.ASTORE, parameters.slotOf(field));
    }
    MethodPlan only = plan.isOneMethod() ? plan.methods().get(0) : MethodPlan.EMPTY;
    LocalSlots locals = LocalSlots.of(only, parameters.end());
    MethodBytes body = body(code, parameters, locals);
    first.write(code, parameters);
    angles(code, body, parameters);
    StackCode.emit(only, body);
    if (!plan.isOneMethod() && !plan.steps().isEmpty()) {
      steps(code, parameters);
    }
    last.write(code, parameters);
    end(code, body, head.returnsResult());
    angleParts();
    if (!plan.isOneMethod()) {
      parts();
    }
  }

  private MethodBytes body(MethodVisitor code, ParameterSlots parameters, LocalSlots locals) {
    return new MethodBytes(code, head, parameters, locals, className, plan.constants());
  }

  private static void end(MethodVisitor code, MethodBytes body, boolean returnsResult) {
    if (returnsResult) {
      body.returnRegular();
    } else {
      code.visitInsn(Opcodes.RETURN);
    }
    code.visitMaxs(0, 0);
    code.visitEnd();
  }

  /** Writes the angles, or calls of the methods that compute them. */
  private void angles(MethodVisitor code, MethodBytes body, ParameterSlots parameters) {
    if (angleParts.isEmpty()) {
      angles(code, body, parameters, AngleGroup.of(plan.angles()));
    }
    for (int i = 0; i < angleParts.size(); i++) {
      pushArrays(code, parameters);
      invoke(code, head.anglesName(i), false, 0);
    }
  }

  private void angles(
      MethodVisitor code, MethodBytes body, ParameterSlots parameters, List<AngleGroup> runs) {
    for (AngleGroup run : runs) {
      if (run.isLoop()) {
        loop(code, body, parameters, run);
      } else {
        StackCode.emitValue(run.angle(), body);
        code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(ParameterSlots.WORKSPACE));
        new NumberInstructions(code).push(2 * run.start());
        sinCos(code);
      }
    }
  }

  private static void sinCos(MethodVisitor code) {
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC, "org/mechservice/solver/spatial/SinCos", "sinCos", "(D[DI)V", false);
  }

  private void loop(
      MethodVisitor code, MethodBytes body, ParameterSlots parameters, AngleGroup run) {
    int input = run.input().index();
    MethodSignature.Argument array = head.argumentOf(input);
    CountingLoop loop =
        CountingLoop.begin(code, parameters.types(), parameters.end(), 0, run.count());
    if (run.isMultiple()) {
      StackCode.emitValue(run.factor(), body);
    }
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(array.name()));
    loop.pushCounter(1, input - array.first());
    code.visitInsn(Opcodes.DALOAD);
    if (run.isMultiple()) {
      code.visitInsn(Opcodes.DMUL);
    }
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(ParameterSlots.WORKSPACE));
    loop.pushCounter(2, 2 * run.start());
    sinCos(code);
    loop.end(1);
  }

  /** Writes the steps, or calls of the parts that contain them. */
  private void steps(MethodVisitor code, ParameterSlots parameters) {
    List<List<CallSequence>> parts = plan.parts();
    if (parts.size() == 1) {
      steps(code, parameters, parts.get(0));
      return;
    }
    for (int i = 0; i < parts.size(); i++) {
      pushArrays(code, parameters);
      invoke(code, partName(i), plan.checks(parts.get(i)), 0);
      if (plan.checks(parts.get(i))) {
        returnUnlessRegular(code, parameters.types(), parameters.end());
      }
    }
  }

  private String partName(int part) {
    return head.name() + "Part" + (part + 1);
  }

  private String methodName(int method) {
    return head.name() + (method + 1);
  }

  private void steps(MethodVisitor code, ParameterSlots parameters, List<CallSequence> some) {
    NumberInstructions numbers = new NumberInstructions(code);
    for (CallSequence step : some) {
      if (step.isLoop()) {
        loop(code, parameters, step);
      } else {
        for (CallSequence.Call call : step.calls()) {
          pushArrays(code, parameters);
          call.numbers().forEach(numbers::push);
          invoke(code, call, parameters.types(), parameters.end());
        }
      }
    }
  }

  private void loop(MethodVisitor code, ParameterSlots parameters, CallSequence step) {
    int counter = parameters.end();
    CountingLoop loop = CountingLoop.begin(code, parameters.types(), counter, 0, step.count());
    for (CallSequence.Call call : step.calls()) {
      pushArrays(code, parameters);
      for (int parameter = 0; parameter < call.numbers().size(); parameter++) {
        loop.pushCounter(call.strides().get(parameter), call.numbers().get(parameter));
      }
      invoke(code, call, loop.types(), counter + 1);
    }
    loop.end(1);
  }

  private void pushArrays(MethodVisitor code, ParameterSlots parameters) {
    for (MethodSignature.Argument argument : plan.arguments(head)) {
      int slot = parameters.slotOf(argument.name());
      code.visitVarInsn(argument.isArray() ? Opcodes.ALOAD : Opcodes.DLOAD, slot);
    }
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(head.output()));
    for (String field : fields) {
      code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(field));
    }
  }

  /**
   * @param types of all slots below {@code free}; not modified
   * @param free an unused slot
   */
  private void invoke(MethodVisitor code, CallSequence.Call call, List<Object> types, int free) {
    invoke(code, methodName(call.method()), plan.checks(call), call.numbers().size());
    if (plan.checks(call)) {
      returnUnlessRegular(code, types, free);
    }
  }

  private void invoke(MethodVisitor code, String name, boolean checks, int wholeNumbers) {
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC, className, name, descriptor(checks, wholeNumbers), false);
  }

  /** Returns the descriptor of a part: inputs of the program, the output, fields and integers. */
  private String descriptor(boolean checks, int wholeNumbers) {
    String rest = "[D" + "[D".repeat(fields.size()) + "I".repeat(wholeNumbers);
    return ParameterSlots.descriptor(plan.arguments(head), rest, checks);
  }

  /**
   * @param types of all slots below {@code free}, as stack map frames tell them; not modified
   * @param free an unused slot
   */
  private static void returnUnlessRegular(MethodVisitor code, List<Object> types, int free) {
    Label regular = new Label();
    code.visitVarInsn(Opcodes.ISTORE, free);
    code.visitVarInsn(Opcodes.ILOAD, free);
    code.visitInsn(Opcodes.ICONST_M1);
    code.visitJumpInsn(Opcodes.IF_ICMPEQ, regular);
    code.visitVarInsn(Opcodes.ILOAD, free);
    code.visitInsn(Opcodes.IRETURN);
    code.visitLabel(regular);
    code.visitFrame(Opcodes.F_NEW, types.size(), types.toArray(), 0, new Object[0]);
  }

  private void angleParts() {
    for (int i = 0; i < angleParts.size(); i++) {
      ParameterSlots parameters = ParameterSlots.ofPart(head, plan.arguments(head), fields, 0);
      MethodVisitor code = begin(head.anglesName(i), false, 0);
      MethodBytes body = body(code, parameters, LocalSlots.of(MethodPlan.EMPTY, parameters.end()));
      angles(code, body, parameters, angleParts.get(i));
      end(code, body, false);
    }
  }

  private void parts() {
    List<List<CallSequence>> parts = plan.parts();
    for (int i = 0; i < parts.size() && parts.size() > 1; i++) {
      boolean checks = plan.checks(parts.get(i));
      ParameterSlots parameters = ParameterSlots.ofPart(head, plan.arguments(head), fields, 0);
      MethodVisitor code = begin(partName(i), checks, 0);
      steps(code, parameters, parts.get(i));
      MethodBytes body = body(code, parameters, LocalSlots.of(MethodPlan.EMPTY, 0));
      end(code, body, checks);
    }
    for (int i = 0; i < plan.methods().size(); i++) {
      MethodPlan method = plan.methods().get(i);
      int wholeNumbers = method.parameters();
      ParameterSlots parameters =
          ParameterSlots.ofPart(head, plan.arguments(head), fields, wholeNumbers);
      MethodVisitor code = begin(methodName(i), method.checks(), wholeNumbers);
      LocalSlots locals = LocalSlots.of(method, parameters.end());
      MethodBytes body = body(code, parameters, locals);
      StackCode.emit(method, body);
      end(code, body, method.checks());
    }
  }

  private MethodVisitor begin(String name, boolean checks, int wholeNumbers) {
    int access = Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC;
    return ClassMethods.begin(classFile, access, name, descriptor(checks, wholeNumbers));
  }
}
