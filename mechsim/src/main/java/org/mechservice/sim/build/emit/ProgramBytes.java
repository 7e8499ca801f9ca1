package org.mechservice.sim.build.emit;

import java.util.List;
import java.util.Map;
import org.mechservice.sim.symbolic.Scalar;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Writes a planned program as methods of a class file: what {@link ProgramPrinter} writes. */
final class ProgramBytes {
  private static final MethodPlan NONE = new MethodPlan(List.of(), Map.of());

  private final ClassVisitor classFile;
  private final String className;
  private final Head head;
  private final ProgramPlan plan;
  private final List<String> fields;

  /**
   * @param className internal name of the class
   */
  ProgramBytes(ClassVisitor classFile, String className, Head head, ProgramPlan plan) {
    this.classFile = classFile;
    this.className = className;
    this.head = head;
    this.plan = plan;
    this.fields = plan.fields();
  }

  /** Goes to the beginning, or before the end, of the method of the interface. */
  interface Extra {
    void write(MethodVisitor code, Parameters parameters);
  }

  /** Writes the method of the interface and its parts. */
  void method(Extra first, Extra last) {
    Parameters parameters = Parameters.ofInstance(head, className, fields);
    String descriptor = Parameters.descriptor(head.arguments(), "[D", head.returnsResult());
    MethodVisitor code =
        ClassMethods.begin(
            classFile,
            head.isPublic() ? Opcodes.ACC_PUBLIC : Opcodes.ACC_PRIVATE,
            head.name(),
            descriptor);
    for (String field : fields) {
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitFieldInsn(Opcodes.GETFIELD, className, field, "[D");
      code.visitVarInsn(Opcodes.ASTORE, parameters.slotOf(field));
    }
    MethodPlan only = plan.methods().size() == 1 ? plan.methods().get(0) : NONE;
    LocalSlots locals = new LocalSlots(only, parameters.end());
    MethodBytes body = new MethodBytes(code, head, parameters, locals);
    first.write(code, parameters);
    angles(code, body, parameters);
    StackCode.tell(only, body);
    if (plan.methods().size() > 1) {
      calls(code, parameters);
    }
    last.write(code, parameters);
    end(code, body, head.returnsResult());
    if (plan.methods().size() > 1) {
      parts();
    }
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

  private void angles(MethodVisitor code, MethodBytes body, Parameters parameters) {
    List<Scalar> angles = plan.angles();
    for (int i = 0; i < angles.size(); ) {
      int run = plan.runOfInputs(i);
      if (run >= ProgramPrinter.SHORTEST_LOOP) {
        loop(code, parameters, i, run);
        i += run;
      } else {
        StackCode.tellValue(angles.get(i), body);
        code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(Parameters.WORKSPACE));
        new NumberCode(code).push(2 * i);
        sinCos(code);
        i++;
      }
    }
  }

  private static void sinCos(MethodVisitor code) {
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC, "org/mechservice/solver/spatial/SinCos", "sinCos", "(D[DI)V", false);
  }

  private void loop(MethodVisitor code, Parameters parameters, int start, int count) {
    Head.Argument array = head.argumentOf(plan.angles().get(start).index());
    CountingLoop loop = CountingLoop.begin(code, parameters.types(), parameters.end(), 0, count);
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(array.name()));
    loop.pushCounter(1, plan.angles().get(start).index() - array.first());
    code.visitInsn(Opcodes.DALOAD);
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(Parameters.WORKSPACE));
    loop.pushCounter(2, 2 * start);
    sinCos(code);
    loop.end(1);
  }

  private void calls(MethodVisitor code, Parameters parameters) {
    List<Head.Argument> arguments = plan.arguments(head);
    for (int i = 0; i < plan.methods().size(); i++) {
      boolean checks = plan.methods().get(i).checks();
      for (Head.Argument argument : arguments) {
        int slot = parameters.slotOf(argument.name());
        code.visitVarInsn(argument.isArray() ? Opcodes.ALOAD : Opcodes.DLOAD, slot);
      }
      code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(head.output()));
      for (String field : fields) {
        code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(field));
      }
      code.visitMethodInsn(
          Opcodes.INVOKESTATIC,
          className,
          head.name() + (i + 1),
          Parameters.descriptor(arguments, partRest(), checks),
          false);
      if (checks) {
        returnUnlessRegular(code, parameters);
      }
    }
  }

  /** The output and the fields. */
  private String partRest() {
    return "[D" + "[D".repeat(fields.size());
  }

  private static void returnUnlessRegular(MethodVisitor code, Parameters parameters) {
    int singular = parameters.end();
    Label regular = new Label();
    code.visitVarInsn(Opcodes.ISTORE, singular);
    code.visitVarInsn(Opcodes.ILOAD, singular);
    code.visitInsn(Opcodes.ICONST_M1);
    code.visitJumpInsn(Opcodes.IF_ICMPEQ, regular);
    code.visitVarInsn(Opcodes.ILOAD, singular);
    code.visitInsn(Opcodes.IRETURN);
    code.visitLabel(regular);
    Object[] types = parameters.types().toArray();
    code.visitFrame(Opcodes.F_NEW, types.length, types, 0, new Object[0]);
  }

  private void parts() {
    List<Head.Argument> arguments = plan.arguments(head);
    for (int i = 0; i < plan.methods().size(); i++) {
      MethodPlan part = plan.methods().get(i);
      Parameters parameters = Parameters.ofPart(head, arguments, fields);
      MethodVisitor code =
          ClassMethods.begin(
              classFile,
              Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC,
              head.name() + (i + 1),
              Parameters.descriptor(arguments, partRest(), part.checks()));
      LocalSlots locals = new LocalSlots(part, parameters.end());
      MethodBytes body = new MethodBytes(code, head, parameters, locals);
      StackCode.tell(part, body);
      end(code, body, part.checks());
    }
  }
}
