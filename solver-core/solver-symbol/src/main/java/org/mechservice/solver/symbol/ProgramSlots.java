package org.mechservice.solver.symbol;

import java.util.ArrayList;
import java.util.List;

/**
 * Numbers the nodes that a program uses: a slot for each number that a run holds. The place of a
 * {@linkplain GivenFunction function given by points} has none where one value alone needs it.
 */
public final class ProgramSlots {
  private final int[] slot;
  private final List<Scalar> used = new ArrayList<>();

  /** Numbers the nodes of a program as it is now. */
  public ProgramSlots(Program program) {
    int[] uses = program.uses();
    slot = new int[uses.length];
    for (int id = 0; id < uses.length; id++) {
      Scalar node = program.expressions().node(id);
      boolean ofOneValue = uses[id] == 1 && isPlace(node);
      if (uses[id] > 0 && !ofOneValue) {
        slot[id] = used.size();
        used.add(node);
      } else {
        slot[id] = -1;
      }
    }
  }

  private static boolean isPlace(Scalar node) {
    return node.is(ScalarOperation.FUNCTION) && node.function() == MathFunction.PLACE;
  }

  /** Returns the slot of a node; −1 if it has none. */
  public int slot(Scalar node) {
    return slot[node.id()];
  }

  /** Returns the slots of nodes. */
  public int[] slots(List<Scalar> nodes) {
    return nodes.stream().mapToInt(this::slot).toArray();
  }

  /** Returns the inputs among the nodes. */
  public List<Scalar> inputs() {
    return used.stream().filter(node -> node.is(ScalarOperation.INPUT)).toList();
  }

  /** Returns the nodes that are computed, each after its operands. */
  public List<Scalar> steps() {
    return used.stream().filter(node -> !node.operands().isEmpty()).toList();
  }

  /** Returns what the slots hold before a run: the constants, zero elsewhere. */
  public double[] initial() {
    return used.stream().mapToDouble(node -> node.isNumber() ? node.value() : 0).toArray();
  }
}
