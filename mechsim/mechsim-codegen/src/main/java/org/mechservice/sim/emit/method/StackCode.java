package org.mechservice.sim.emit.method;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * Translates a planned method to instructions of a stack machine: operands first, then the
 * operation.
 *
 * <p>The order of operations is that of the plan, so every machine computes the same bits as the
 * source printed from the plan.
 */
public final class StackCode {
  /** Receives the instructions. */
  public interface Machine {
    /** Pushes an input. */
    void pushInput(int index);

    /** Pushes an element of the workspace. */
    void pushSlot(int index);

    /** Pushes a local variable. */
    void pushLocal(Scalar value);

    /** Pops into a local variable. */
    void popLocal(Scalar value);

    /** Pushes a number. */
    void pushConstant(double value);

    /** Pops the operands of an operation and pushes its result. */
    void operate(ScalarOperation operation);

    /** Pushes the array of constants, and place and number of a row's elements in it. */
    void pushRow(NumberRow row);

    /** Pops the arguments of a function and pushes its result. */
    void call(MathFunction function);

    /** Prepares a pop into an element of the workspace. */
    void beginSlot(int index);

    /** Prepares a pop into an output. */
    void beginOutput(int index);

    /** Pushes an element of an array. */
    void pushElement(ValueLocation.Element element);

    /** Prepares a pop into an element of an array. */
    void beginElement(ValueLocation.Element element);

    /** Pops into the prepared location. */
    void endElement();

    /** Copies consecutive inputs to outputs. */
    void copyInputs(int input, int index, int count);

    /** Pops a bound and a pivot and ends the program with a result unless the pivot is above. */
    void check(IndexExpression result);
  }

  private final MethodPlan method;
  private final Machine machine;

  private StackCode(MethodPlan method, Machine machine) {
    this.method = method;
    this.machine = machine;
  }

  /** Sends the instructions of a method to a machine. */
  public static void emit(MethodPlan method, Machine machine) {
    StackCode code = new StackCode(method, machine);
    for (Statement statement : method.statements()) {
      code.statement(statement);
    }
  }

  /** Sends to a machine the instructions that push a value without locations. */
  public static void emitValue(Scalar value, Machine machine) {
    new StackCode(new MethodPlan(List.of(), Map.of()), machine).value(value);
  }

  private void statement(Statement statement) {
    if (statement instanceof Statement.Load load) {
      place(load.from());
      machine.popLocal(load.value());
    } else if (statement instanceof Statement.Define define) {
      operation(define.value());
      machine.popLocal(define.value());
    } else if (statement instanceof Statement.Store store) {
      machine.beginSlot(store.slot());
      value(store.value());
      machine.endElement();
    } else if (statement instanceof Statement.PutOut output) {
      machine.beginOutput(output.index());
      value(output.value());
      machine.endElement();
    } else if (statement instanceof Statement.Put put) {
      machine.beginElement(put.to());
      value(put.value());
      machine.endElement();
    } else if (statement instanceof Statement.CopyInputs copy) {
      machine.copyInputs(copy.input(), copy.index(), copy.count());
    } else if (statement instanceof Statement.Check check) {
      value(check.pivot());
      value(check.bound());
      machine.check(check.result());
    }
  }

  private void binary(BinaryForm form) {
    term(form.first());
    term(form.second());
    machine.operate(form.operation());
  }

  private void term(BinaryForm.Term term) {
    if (term.opposite()) {
      opposite(term.value());
    } else {
      value(term.value());
    }
  }

  /** Emits the opposite of a value that absorbs the sign. */
  private void opposite(Scalar node) {
    OptionalDouble constant = BinaryForm.constant(node, method.places());
    if (constant.isPresent()) {
      machine.pushConstant(-constant.getAsDouble());
    } else {
      binary(BinaryForm.ofOpposite(node, method.places()));
    }
  }

  private void value(Scalar node) {
    ValueLocation place = method.places().get(node);
    if (place != null) {
      place(place);
    } else {
      operation(node);
    }
  }

  private void place(ValueLocation place) {
    if (place instanceof ValueLocation.Local local) {
      machine.pushLocal(local.value());
    } else if (place instanceof ValueLocation.Slot slot) {
      machine.pushSlot(slot.index());
    } else if (place instanceof ValueLocation.Element element) {
      machine.pushElement(element);
    } else if (place instanceof ValueLocation.Constant constant) {
      machine.pushConstant(constant.value());
    } else {
      machine.pushInput(((ValueLocation.Input) place).index());
    }
  }

  private void operation(Scalar node) {
    switch (node.operation()) {
      case CONSTANT -> machine.pushConstant(node.value());
      case INPUT -> machine.pushInput(node.index());
      case SINE, COSINE -> throw new IllegalStateException("an angle function has a place");
      case ADD, SUBTRACT, MULTIPLY, DIVIDE -> binary(BinaryForm.of(node, method.places()));
      case NEGATE -> negate(node.first());
      default -> {
        if (node.operation() == ScalarOperation.FUNCTION && node.function().readsRow()) {
          machine.pushRow(node.row());
        }
        List<Scalar> operands = node.operands();
        for (int i = 0; i < operands.size(); i++) {
          value(operands.get(i));
        }
        if (node.operation() == ScalarOperation.FUNCTION) {
          machine.call(node.function());
        } else {
          machine.operate(node.operation());
        }
      }
    }
  }

  private void negate(Scalar operand) {
    if (BinaryForm.absorbsSign(operand, method.places())) {
      opposite(operand);
    } else {
      value(operand);
      machine.operate(ScalarOperation.NEGATE);
    }
  }
}
