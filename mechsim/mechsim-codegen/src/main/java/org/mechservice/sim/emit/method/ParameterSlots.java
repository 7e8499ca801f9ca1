package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.List;
import org.objectweb.asm.Opcodes;

/** Slots and types of a method's parameters, fields last. */
public final class ParameterSlots {
  /** Name of the workspace. */
  public static final String WORKSPACE = "w";

  private final List<String> names = new ArrayList<>();
  private final List<Integer> slots = new ArrayList<>();
  private final List<Object> types = new ArrayList<>();
  private int next;

  private ParameterSlots() {}

  /**
   * Returns the slots of the interface's method: the instance, the parameters, then array fields.
   */
  public static ParameterSlots ofInstance(
      MethodSignature head, String className, List<String> fields) {
    ParameterSlots parameters = new ParameterSlots();
    parameters.add("this", className, 1);
    parameters.addAll(head.arguments(), head, fields);
    return parameters;
  }

  /** Returns the slots of a part: inputs of the program, the output, fields and integers. */
  public static ParameterSlots ofPart(
      MethodSignature head,
      List<MethodSignature.Argument> arguments,
      List<String> fields,
      int numbers) {
    ParameterSlots parameters = new ParameterSlots();
    parameters.addAll(arguments, head, fields);
    for (int i = 0; i < numbers; i++) {
      parameters.add(IndexExpression.name(i), Opcodes.INTEGER, 1);
    }
    return parameters;
  }

  private void addAll(
      List<MethodSignature.Argument> arguments, MethodSignature head, List<String> fields) {
    for (MethodSignature.Argument argument : arguments) {
      if (argument.isArray()) {
        add(argument.name(), "[D", 1);
      } else {
        add(argument.name(), Opcodes.DOUBLE, 2);
      }
    }
    add(head.output(), "[D", 1);
    for (String field : fields) {
      add(field, "[D", 1);
    }
  }

  private void add(String name, Object type, int size) {
    names.add(name);
    slots.add(next);
    types.add(type);
    next += size;
  }

  /** Returns the slot of a parameter; −1 if there is none of this name. */
  public int slotOf(String name) {
    int place = names.indexOf(name);
    return place < 0 ? -1 : slots.get(place);
  }

  /** Returns the types in the form of stack map frames. */
  public List<Object> types() {
    return types;
  }

  /** Returns the first slot behind them. */
  public int end() {
    return next;
  }

  /** Returns the descriptor of a method with the given arguments, the output and what follows. */
  public static String descriptor(
      List<MethodSignature.Argument> arguments, String rest, boolean returnsResult) {
    StringBuilder descriptor = new StringBuilder("(");
    for (MethodSignature.Argument argument : arguments) {
      descriptor.append(argument.isArray() ? "[D" : "D");
    }
    return descriptor.append(rest).append(returnsResult ? ")I" : ")V").toString();
  }
}
