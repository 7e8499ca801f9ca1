package org.mechservice.sim.emit.plan;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.Statement;
import org.mechservice.solver.symbol.Scalar;

/**
 * Orders what a method loads at its beginning by its first use. In the graph the operands of a
 * section are in the order in which they were made, which differs between sections that compute the
 * same of them: one value may come from a body, another from a body beyond it.
 */
final class LoadOrder {
  private final Map<Scalar, Statement.Load> loads = new LinkedHashMap<>();
  private final List<Statement> ordered = new ArrayList<>();
  private final List<Statement> others = new ArrayList<>();
  private final Set<Scalar> met = new HashSet<>();

  private LoadOrder() {}

  /** Returns the statements of a method, its first loads in the order of their first use. */
  static List<Statement> byFirstUse(MethodPlan method) {
    LoadOrder order = new LoadOrder();
    order.divide(method.statements());
    order.others.forEach(order::use);
    order.ordered.addAll(order.loads.values());
    order.ordered.addAll(order.others);
    return order.ordered;
  }

  private void divide(List<Statement> statements) {
    int i = 0;
    for (; i < statements.size(); i++) {
      Statement statement = statements.get(i);
      if (statement instanceof Statement.Load load) {
        loads.put(load.value(), load);
      } else if (!(statement instanceof Statement.Comment)) {
        break;
      }
    }
    others.addAll(statements.subList(i, statements.size()));
  }

  private void use(Statement statement) {
    if (statement instanceof Statement.Define define) {
      define.value().operands().forEach(this::use);
    } else if (statement instanceof Statement.Store store) {
      use(store.value());
    } else if (statement instanceof Statement.PutOut output) {
      use(output.value());
    } else if (statement instanceof Statement.Check check) {
      use(check.pivot());
      use(check.bound());
    }
  }

  /** Goes down from a value to what was loaded or defined before, operands in their order. */
  private void use(Scalar value) {
    Deque<Scalar> open = new ArrayDeque<>();
    open.push(value);
    while (!open.isEmpty() && !loads.isEmpty()) {
      Scalar node = open.pop();
      if (!met.add(node)) {
        continue;
      }
      Statement.Load load = loads.remove(node);
      if (load != null) {
        ordered.add(load);
        continue;
      }
      List<Scalar> operands = node.operands();
      for (int k = operands.size() - 1; k >= 0; k--) {
        open.push(operands.get(k));
      }
    }
  }
}
