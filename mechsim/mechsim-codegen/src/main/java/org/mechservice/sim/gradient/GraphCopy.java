package org.mechservice.sim.gradient;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;

/** Copies expressions of one graph into another. */
final class GraphCopy {
  private final Expressions into;
  private final Map<Scalar, Scalar> copies = new HashMap<>();

  GraphCopy(Expressions into) {
    this.into = into;
  }

  /** Returns the copy of a node. */
  Scalar of(Scalar node) {
    List<Scalar> open = new ArrayList<>(List.of(node));
    // operands first; a stack of our own, since graphs are deep
    while (!open.isEmpty()) {
      Scalar next = open.get(open.size() - 1);
      int before = open.size();
      for (Scalar operand : next.operands()) {
        if (!copies.containsKey(operand)) {
          open.add(operand);
        }
      }
      if (open.size() == before) {
        open.remove(before - 1);
        copies.computeIfAbsent(
            next, same -> into.alike(same, same.operands().stream().map(this::known).toList()));
      }
    }
    return known(node);
  }

  private Scalar known(Scalar node) {
    return Objects.requireNonNull(copies.get(node));
  }
}
