package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/** Counts the bytes of code of planned methods. */
public final class CodeSize implements StackCode.Machine {
  /** Bytes of an access to an array element. */
  private static final int ELEMENT = 5;

  private static final int NUMBER = 3;
  private static final int CHECK = 10;
  private static final int COPY = 12;
  private static final int CALL = 3;

  /** Bytes of an addition to an index. */
  private static final int SUM = 4;

  /**
   * Bytes of a call of a method with its arrays, including the check whether it ends the program.
   */
  public static final int STEP = 24;

  private static final int LOOP = 16;

  /** Size of an access to a local variable whose slot is not known yet. */
  private static final int LOCAL = 3;

  /** Estimated size of the output of a value that has a place. */
  public static final int OUTPUT = ELEMENT + LOCAL;

  /** Estimated size of the check of a value that has a place. */
  public static final int GUARD = 2 * LOCAL + CHECK;

  /** Last slot with the short form of access, two bytes; other slots take four. */
  private static final int LAST_SHORT_SLOT = 255;

  private static final int SHORT_LOCAL = 2;
  private static final int WIDE_LOCAL = 4;

  /** Slots of the instance, the parameters and the workspace. */
  private static final int FIRST_SLOT = 7;

  private final List<Scalar> accesses = new ArrayList<>();
  private int bytes;

  private CodeSize() {}

  /**
   * Returns an estimate of the bytes of each section of a program, as if all were in one method.
   */
  public static int[] ofSections(Program program, ValueUsage usage) {
    int[] bytes = new int[program.sections().size()];
    for (int s = 0; s < bytes.length; s++) {
      for (Scalar node : usage.placedIn(s)) {
        bytes[s] += ofValue(usage, node);
      }
      Program.Section section = program.sections().get(s);
      bytes[s] += section.outputs().size() * OUTPUT;
      bytes[s] += section.guards().size() * GUARD;
    }
    return bytes;
  }

  /** Returns an estimate of the code that computes a value and stores it. */
  public static int ofValue(ValueUsage usage, Scalar node) {
    return LOCAL + sizeIn(usage, node);
  }

  private static int sizeIn(ValueUsage usage, Scalar node) {
    int bytes = 1;
    List<Scalar> operands = node.operands();
    for (int i = 0; i < operands.size(); i++) {
      Scalar operand = operands.get(i);
      boolean inline = !operand.operands().isEmpty() && !usage.isPlaced(operand);
      bytes += inline ? sizeIn(usage, operand) : LOCAL;
    }
    return bytes;
  }

  /** Returns the size of a planned method whose variables share slots. */
  public static int of(MethodPlan method) {
    CodeSize size = new CodeSize();
    StackCode.emit(method, size);
    LocalSlots locals = new LocalSlots(size.accesses, FIRST_SLOT);
    int bytes = size.bytes;
    for (int i = 0; i < locals.count(); i++) {
      bytes += locals.next() <= LAST_SHORT_SLOT ? SHORT_LOCAL : WIDE_LOCAL;
    }
    return bytes;
  }

  /** Returns an estimate of the code of a step. */
  public static int of(CallSequence step) {
    int number = step.isLoop() ? NUMBER + SUM + NUMBER : NUMBER;
    int bytes = step.isLoop() ? LOOP : 0;
    for (CallSequence.Call call : step.calls()) {
      bytes += STEP + call.numbers().size() * number;
    }
    return bytes;
  }

  /** Returns an estimate of the code that computes sines and cosines. */
  public static int of(AngleGroup run) {
    CodeSize size = new CodeSize();
    StackCode.emitValue(run.angle(), size);
    return size.bytes + ELEMENT + CALL + (run.isLoop() ? LOOP + 2 * SUM : 0);
  }

  @Override
  public void pushLocal(Scalar value) {
    accesses.add(value);
  }

  @Override
  public void popLocal(Scalar value) {
    accesses.add(value);
  }

  @Override
  public void pushInput(int index) {
    bytes += ELEMENT;
  }

  @Override
  public void pushSlot(int index) {
    bytes += ELEMENT;
  }

  @Override
  public void pushConstant(double value) {
    bytes += value < 0 ? NUMBER + 1 : NUMBER;
  }

  @Override
  public void operate(ScalarOperation operation) {
    bytes += operation == ScalarOperation.SQUARE_ROOT ? CALL : 1;
  }

  @Override
  public void pushRow(NumberRow row) {
    bytes += CALL + 2 * NUMBER;
  }

  @Override
  public void call(MathFunction function) {
    bytes += CALL;
  }

  @Override
  public void beginSlot(int index) {
    bytes += ELEMENT;
  }

  @Override
  public void beginOutput(int index) {
    bytes += ELEMENT;
  }

  @Override
  public void pushElement(ValueLocation.Element element) {
    bytes += ELEMENT + SUM;
  }

  @Override
  public void beginElement(ValueLocation.Element element) {
    bytes += ELEMENT + SUM;
  }

  @Override
  public void endElement() {
    // Counted at its beginning.
  }

  @Override
  public void copyInputs(int input, int index, int count) {
    bytes += COPY;
  }

  @Override
  public void check(IndexExpression result) {
    bytes += CHECK;
  }
}
