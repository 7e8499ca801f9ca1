package org.mechservice.sim.emit.bytes;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.IndexExpression;
import org.mechservice.sim.emit.method.LocalSlots;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.ParameterSlots;
import org.mechservice.sim.emit.method.StackCode;
import org.mechservice.sim.emit.method.ValueLocation;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Writes the body of a planned method as byte code. */
final class MethodBytes implements StackCode.Machine {
  private final MethodVisitor code;
  private final MethodSignature head;
  private final ParameterSlots parameters;
  private final LocalSlots locals;
  private final NumberInstructions numbers;
  private final String className;
  private final ConstantTable constants;
  private final int workspace;

  /**
   * @param head names of the program's inputs and outputs
   * @param parameters slots of the method
   * @param className internal name of the class
   * @param constants the numbers in the static array of the class
   */
  MethodBytes(
      MethodVisitor code,
      MethodSignature head,
      ParameterSlots parameters,
      LocalSlots locals,
      String className,
      ConstantTable constants) {
    this.className = className;
    this.constants = constants;
    this.code = code;
    this.head = head;
    this.parameters = parameters;
    this.locals = locals;
    this.numbers = new NumberInstructions(code);
    this.workspace = parameters.slotOf(ParameterSlots.WORKSPACE);
  }

  @Override
  public void pushInput(int index) {
    MethodSignature.Argument argument = head.argumentOf(index);
    int slot = parameters.slotOf(argument.name());
    if (argument.isArray()) {
      code.visitVarInsn(Opcodes.ALOAD, slot);
      numbers.push(index - argument.first());
      code.visitInsn(Opcodes.DALOAD);
    } else {
      code.visitVarInsn(Opcodes.DLOAD, slot);
    }
  }

  @Override
  public void pushSlot(int index) {
    code.visitVarInsn(Opcodes.ALOAD, workspace);
    numbers.push(index);
    code.visitInsn(Opcodes.DALOAD);
  }

  @Override
  public void pushLocal(Scalar value) {
    code.visitVarInsn(Opcodes.DLOAD, locals.next());
  }

  @Override
  public void popLocal(Scalar value) {
    code.visitVarInsn(Opcodes.DSTORE, locals.next());
  }

  @Override
  public void pushConstant(double value) {
    numbers.push(value);
  }

  @Override
  public void operate(ScalarOperation operation) {
    switch (operation) {
      case ADD -> code.visitInsn(Opcodes.DADD);
      case SUBTRACT -> code.visitInsn(Opcodes.DSUB);
      case MULTIPLY -> code.visitInsn(Opcodes.DMUL);
      case DIVIDE -> code.visitInsn(Opcodes.DDIV);
      case NEGATE -> code.visitInsn(Opcodes.DNEG);
      case SQUARE_ROOT ->
          code.visitMethodInsn(Opcodes.INVOKESTATIC, "java/lang/Math", "sqrt", "(D)D", false);
      default -> throw new IllegalStateException(operation + " is no operation of a stack machine");
    }
  }

  @Override
  public void pushRow(NumberRow row) {
    code.visitFieldInsn(Opcodes.GETSTATIC, className, ConstantTable.FIELD, "[D");
    numbers.push(constants.placeOf(row));
    numbers.push(row.size());
  }

  @Override
  public void call(MathFunction function) {
    String row = function.readsRow() ? "[DII" : "";
    String descriptor = "(" + row + "D".repeat(function.arity()) + ")D";
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC, function.owner(), function.method(), descriptor, false);
  }

  @Override
  public void beginSlot(int index) {
    code.visitVarInsn(Opcodes.ALOAD, workspace);
    numbers.push(index);
  }

  @Override
  public void beginOutput(int index) {
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(head.output()));
    numbers.push(index);
  }

  @Override
  public void pushElement(ValueLocation.Element element) {
    beginElement(element);
    code.visitInsn(Opcodes.DALOAD);
  }

  @Override
  public void beginElement(ValueLocation.Element element) {
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(element.array()));
    push(element.index());
  }

  private void push(IndexExpression index) {
    if (index.parameter() == IndexExpression.NONE) {
      numbers.push(index.offset());
      return;
    }
    code.visitVarInsn(Opcodes.ILOAD, parameters.slotOf(IndexExpression.name(index.parameter())));
    if (index.offset() != 0) {
      numbers.push(index.offset());
      code.visitInsn(Opcodes.IADD);
    }
  }

  @Override
  public void endElement() {
    code.visitInsn(Opcodes.DASTORE);
  }

  @Override
  public void copyInputs(int input, int index, int count) {
    MethodSignature.Argument argument = head.argumentOf(input);
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(argument.name()));
    numbers.push(input - argument.first());
    code.visitVarInsn(Opcodes.ALOAD, parameters.slotOf(head.output()));
    numbers.push(index);
    numbers.push(count);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        "java/lang/System",
        "arraycopy",
        "(Ljava/lang/Object;ILjava/lang/Object;II)V",
        false);
  }

  /** {@inheritDoc} A comparison with NaN is false, as in the source. */
  @Override
  public void check(IndexExpression result) {
    Label above = new Label();
    code.visitInsn(Opcodes.DCMPG);
    code.visitJumpInsn(Opcodes.IFGT, above);
    push(result);
    code.visitInsn(Opcodes.IRETURN);
    code.visitLabel(above);
    frame();
  }

  /**
   * Writes the stack map frame at the target of a jump: the types of parameters and live variables.
   */
  private void frame() {
    List<Object> types = new ArrayList<>(parameters.types());
    BitSet taken = locals.taken();
    for (int pair = 0; pair < taken.length(); pair++) {
      if (taken.get(pair)) {
        types.add(Opcodes.DOUBLE);
      } else {
        types.add(Opcodes.TOP);
        types.add(Opcodes.TOP);
      }
    }
    code.visitFrame(Opcodes.F_NEW, types.size(), types.toArray(), 0, new Object[0]);
  }

  /** Ends a method that can end the program. */
  void returnRegular() {
    numbers.push(ExplicitModel.REGULAR);
    code.visitInsn(Opcodes.IRETURN);
  }
}
