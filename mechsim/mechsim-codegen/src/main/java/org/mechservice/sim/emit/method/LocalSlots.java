package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * Slots of the local variables of a planned method: each variable gets the lowest pair of slots
 * that is free during its lifetime, from its definition to its last use.
 */
public final class LocalSlots {
  /** A variable: its pair of slots, and the number of accesses left. */
  private static final class Variable {
    private int pair = -1;
    private int accesses;
  }

  private final int first;

  /** The pair of slots of each access, in order. */
  private final int[] pairs;

  /** Marks the last access of each variable. */
  private final BitSet ends = new BitSet();

  private int next;

  /**
   * @param accesses the variables that a method accesses, in order
   * @param first first slot behind the parameters
   */
  LocalSlots(List<Scalar> accesses, int first) {
    this.first = first;
    this.pairs = new int[accesses.size()];
    Variable[] variables = new Variable[pairs.length];
    Map<Scalar, Variable> known = new HashMap<>();
    for (int i = 0; i < pairs.length; i++) {
      Variable variable = known.get(accesses.get(i));
      if (variable == null) {
        variable = new Variable();
        known.put(accesses.get(i), variable);
      }
      variable.accesses++;
      variables[i] = variable;
    }
    give(variables);
  }

  private void give(Variable[] accesses) {
    BitSet taken = new BitSet();
    for (int i = 0; i < accesses.length; i++) {
      Variable variable = accesses[i];
      if (variable.pair < 0) {
        variable.pair = taken.nextClearBit(0);
        taken.set(variable.pair);
      }
      pairs[i] = variable.pair;
      variable.accesses--;
      if (variable.accesses == 0) {
        taken.clear(variable.pair);
        ends.set(i);
      }
    }
  }

  /**
   * Returns the slots of a method.
   *
   * @param first first slot behind the parameters
   */
  public static LocalSlots of(MethodPlan method, int first) {
    Accesses accesses = new Accesses();
    StackCode.emit(method, accesses);
    return new LocalSlots(accesses.values, first);
  }

  /** Returns the slot of the next access. */
  public int next() {
    int slot = first + 2 * pairs[next];
    next++;
    return slot;
  }

  /** Returns the number of accesses. */
  int count() {
    return pairs.length;
  }

  /** Returns the pairs of slots in use now. */
  public BitSet taken() {
    BitSet taken = new BitSet();
    for (int i = 0; i < next; i++) {
      taken.set(pairs[i], !ends.get(i));
    }
    return taken;
  }

  /** Records the accesses to local variables. */
  private static final class Accesses implements StackCode.Machine {
    private final List<Scalar> values = new ArrayList<>();

    @Override
    public void pushLocal(Scalar value) {
      values.add(value);
    }

    @Override
    public void popLocal(Scalar value) {
      values.add(value);
    }

    @Override
    public void pushInput(int index) {}

    @Override
    public void pushSlot(int index) {}

    @Override
    public void pushConstant(double value) {}

    @Override
    public void operate(ScalarOperation operation) {}

    @Override
    public void pushRow(NumberRow row) {}

    @Override
    public void call(MathFunction function) {}

    @Override
    public void beginSlot(int index) {}

    @Override
    public void beginOutput(int index) {}

    @Override
    public void pushElement(ValueLocation.Element element) {}

    @Override
    public void beginElement(ValueLocation.Element element) {}

    @Override
    public void endElement() {}

    @Override
    public void copyInputs(int input, int index, int count) {}

    @Override
    public void check(IndexExpression result) {}
  }
}
