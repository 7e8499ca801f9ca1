package org.mechservice.sim.build.emit;

import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import org.mechservice.sim.symbolic.MathFunction;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Scalar;

/**
 * Slots of the local variables of a planned method: each variable has the lowest pair of slots that
 * is free while it lives, from the statement that gives it its value to its last use.
 */
final class LocalSlots {
  /** A variable: the slot it has, and how many accesses are still to come. */
  private static final class Variable {
    private int slot = -1;
    private int accesses;
  }

  private final Map<Scalar, Variable> variables = new HashMap<>();
  private final BitSet taken = new BitSet();
  private final int first;

  /**
   * @param first first slot behind the parameters
   */
  LocalSlots(MethodPlan method, int first) {
    this.first = first;
    StackCode.tell(method, new AccessCounter());
  }

  /** Returns the slot of a variable that is accessed now; after its last access it is free. */
  int access(Scalar value) {
    Variable variable = variables.computeIfAbsent(value, key -> new Variable());
    if (variable.slot < 0) {
      int pair = taken.nextClearBit(0);
      taken.set(pair);
      variable.slot = first + 2 * pair;
    }
    int slot = variable.slot;
    variable.accesses--;
    if (variable.accesses == 0) {
      taken.clear((slot - first) / 2);
      variable.slot = -1;
    }
    return slot;
  }

  /** Returns how many pairs of slots lie up to the last that is taken now. */
  int pairs() {
    return taken.length();
  }

  /** Returns whether a pair of slots is taken now. */
  boolean isTaken(int pair) {
    return taken.get(pair);
  }

  /** Counts the accesses to local variables. */
  private final class AccessCounter implements StackCode.Machine {
    private void count(Scalar value) {
      variables.computeIfAbsent(value, key -> new Variable()).accesses++;
    }

    @Override
    public void pushLocal(Scalar value) {
      count(value);
    }

    @Override
    public void popLocal(Scalar value) {
      count(value);
    }

    @Override
    public void pushInput(int index) {}

    @Override
    public void pushSlot(int index) {}

    @Override
    public void pushConstant(double value) {}

    @Override
    public void operate(Operation operation) {}

    @Override
    public void call(MathFunction function) {}

    @Override
    public void beginSlot(int index) {}

    @Override
    public void beginOutput(int index) {}

    @Override
    public void pushElement(Place.Element element) {}

    @Override
    public void beginElement(Place.Element element) {}

    @Override
    public void endElement() {}

    @Override
    public void copyInputs(int input, int index, int count) {}

    @Override
    public void check(Index result) {}
  }
}
