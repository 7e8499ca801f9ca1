package org.mechservice.solver.expression;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Composed;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.Power;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Turns expressions into steps on slots: one slot per leaf, per constant and per step, numbered as
 * they come up.
 */
final class TapeCompiler {
  /** An operation on two slots; of one operand both are the same. */
  record Step(TapeStep operation, int first, int second) {}

  final List<Expression> leaves = new ArrayList<>();
  final List<Step> steps = new ArrayList<>();

  /** Slot that each step writes. */
  final List<Integer> targets = new ArrayList<>();

  /** Value of each slot that is constant, zero elsewhere. */
  final List<Double> constants = new ArrayList<>();

  private final IdentityHashMap<Expression, Integer> done = new IdentityHashMap<>();
  private final Map<Expression, Integer> slotOfLeaf = new HashMap<>();
  private final Map<Double, Integer> slotOfConstant = new HashMap<>();
  private final Map<PointFunction, TapeStep> curves = new HashMap<>();
  private final Map<Step, Integer> slotOfStep = new HashMap<>();

  /** Compiles without recursion: a sum of thousands of terms is a tree as deep. */
  int compile(Expression root) {
    Deque<Expression> open = new ArrayDeque<>();
    open.push(root);
    while (!open.isEmpty()) {
      Expression next = open.element();
      boolean ready = true;
      for (Expression operand : Expression.operands(next)) {
        if (!done.containsKey(operand)) {
          open.push(operand);
          ready = false;
        }
      }
      if (ready) {
        open.pop();
        done.computeIfAbsent(next, e -> slot(e));
      }
    }
    return done.getOrDefault(root, -1);
  }

  private int slot(Expression expression) {
    if (expression instanceof Constant constant) {
      return constantSlot(constant.value());
    }
    List<Expression> operands = Expression.operands(expression);
    if (operands.isEmpty()) {
      return slotOfLeaf.computeIfAbsent(expression, this::newLeaf);
    }
    int a = done.getOrDefault(operands.get(0), -1);
    int b = done.getOrDefault(operands.get(operands.size() - 1), -1);
    if (expression instanceof Composed) {
      return a;
    }
    TapeStep operation = operation(expression);
    if (operation == Operation.SQUARE) {
      b = a;
    }
    return step(new Step(operation, a, b));
  }

  private int newLeaf(Expression leaf) {
    leaves.add(leaf);
    return newSlot(0);
  }

  private int newSlot(double value) {
    constants.add(value);
    return constants.size() - 1;
  }

  private int constantSlot(double value) {
    return slotOfConstant.computeIfAbsent(value, this::newSlot);
  }

  private int step(Step step) {
    if (isConstant(step.first()) && isConstant(step.second())) {
      double value =
          step.operation().value(constants.get(step.first()), constants.get(step.second()));
      // a constant that is not finite stays a step, so that its use is reported
      if (Double.isFinite(value)) {
        return constantSlot(value);
      }
    }
    return slotOfStep.computeIfAbsent(step, this::newStep);
  }

  private int newStep(Step step) {
    int slot = newSlot(0);
    steps.add(step);
    targets.add(slot);
    return slot;
  }

  boolean isConstant(int slot) {
    return slotOfConstant.getOrDefault(constants.get(slot), -1) == slot;
  }

  private TapeStep operation(Expression expression) {
    if (expression instanceof Sum) {
      return Operation.ADD;
    } else if (expression instanceof Product) {
      return Operation.MULTIPLY;
    } else if (expression instanceof Quotient) {
      return Operation.DIVIDE;
    } else if (expression instanceof Power power) {
      boolean square = power.exponent() instanceof Constant exponent && exponent.value() == 2;
      return square ? Operation.SQUARE : new FunctionStep(MathFunction.POWER);
    } else if (expression instanceof Call call) {
      return new FunctionStep(call.function());
    } else if (expression instanceof TableValue value) {
      return curves.computeIfAbsent(value.table(), PointFunction::step);
    }
    return Operation.NEGATE;
  }

  /** Returns the slots of the leaves, in their order. */
  int[] leafSlots() {
    return leaves.stream().mapToInt(leaf -> slotOfLeaf.getOrDefault(leaf, -1)).toArray();
  }
}
