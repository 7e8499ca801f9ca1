package org.mechservice.sim.emit.source;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.ValueUsage;
import org.mechservice.sim.emit.plan.ProgramPlan;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * Names of local variables: the name of the value in mechanics, or else the subject of its section
 * with a number.
 */
final class LocalNames {
  /** Names that the methods use for other purposes. */
  private static final Set<String> TAKEN =
      Set.of(
          "t",
          "y",
          "yDot",
          "energy",
          "poses",
          "residual",
          "derivatives",
          "w",
          "p",
          "i",
          "singular");

  private final Map<Scalar, String> names = new HashMap<>();
  private final Map<String, Integer> numberOf = new HashMap<>();
  private final Set<String> given = new HashSet<>(TAKEN);

  /**
   * @param head the method that has the inputs as parameters
   * @param reserved words that cannot be names
   */
  LocalNames(ProgramPlan plan, MethodSignature head, Set<String> reserved) {
    given.addAll(reserved);
    Program program = plan.program();
    ValueUsage usage = plan.usage();
    for (Scalar node : usage.given()) {
      give(node, program.nameOf(node).orElseGet(() -> nameOfGiven(node, usage, head)));
    }
    for (int section = 0; section < program.sections().size(); section++) {
      String subject = program.sections().get(section).subject();
      for (Scalar node : usage.placedIn(section)) {
        program.nameOf(node).ifPresent(name -> give(node, name));
      }
      for (Scalar node : usage.placedIn(section)) {
        if (program.nameOf(node).isEmpty()) {
          numbered(node, subject);
        }
      }
    }
  }

  /**
   * Returns the name of an input from its index in its array, or of a sine or cosine from the
   * angle's number.
   */
  private static String nameOfGiven(Scalar node, ValueUsage usage, MethodSignature head) {
    if (node.operation() == ScalarOperation.INPUT) {
      MethodSignature.Argument argument = head.argumentOf(node.index());
      return argument.name() + "_" + (node.index() - argument.first());
    }
    String function = node.operation() == ScalarOperation.SINE ? "sin" : "cos";
    return function + "_angle_" + (usage.angles().indexOf(node.first()) + 1);
  }

  private void numbered(Scalar node, String subject) {
    String stem = Character.isLetter(subject.charAt(0)) ? subject : "b" + subject;
    String name;
    do {
      name = stem + "_" + numberOf.merge(stem, 1, Integer::sum);
    } while (!given.add(name));
    names.put(node, name);
  }

  private void give(Scalar node, String name) {
    String distinct = name;
    for (int i = 2; !given.add(distinct); i++) {
      distinct = name + "_" + i;
    }
    names.put(node, distinct);
  }

  /** Returns the name of a value with a location. */
  String of(Scalar node) {
    return names.getOrDefault(node, "");
  }
}
