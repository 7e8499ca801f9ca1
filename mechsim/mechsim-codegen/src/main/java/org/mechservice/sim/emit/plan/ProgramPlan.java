package org.mechservice.sim.emit.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.ToIntFunction;
import org.mechservice.sim.emit.method.AngleGroup;
import org.mechservice.sim.emit.method.CallSequence;
import org.mechservice.sim.emit.method.CodeSize;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.ParameterSlots;
import org.mechservice.sim.emit.method.ValueLocation;
import org.mechservice.sim.emit.method.ValueUsage;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * The code of a program, planned.
 *
 * @param program the program
 * @param usage uses of its values
 * @param methods methods that the steps call
 * @param steps steps after the sines and cosines, in order
 * @param slots required length of the workspace
 * @param constants the numbers of the class, which holds the rows that the program reads
 * @param remark reason for the layout; empty if it needs none
 */
public record ProgramPlan(
    Program program,
    ValueUsage usage,
    List<MethodPlan> methods,
    List<CallSequence> steps,
    int slots,
    ConstantTable constants,
    String remark) {

  /** Returns the same with a remark. */
  ProgramPlan because(String why) {
    return new ProgramPlan(program, usage, methods, steps, slots, constants, why);
  }

  /** Returns whether parts of the program share methods. */
  public boolean isShared() {
    for (MethodPlan method : methods) {
      if (method.parameters() > 0) {
        return true;
      }
    }
    return false;
  }

  /** Returns the number of calls of methods in one run of the program. */
  int callCount() {
    return steps.stream().mapToInt(step -> step.count() * step.calls().size()).sum();
  }

  /** Returns an estimate of the bytes of code of all methods and of the calls. */
  int codeBytes() {
    return methods.stream().mapToInt(CodeSize::of).sum()
        + steps.stream().mapToInt(CodeSize::of).sum();
  }

  /** Returns a description of the layout. */
  public String summary(String name) {
    String operations = name + " " + program.operationCount() + " operations";
    String in = methods.size() > 1 ? " in " + methods.size() + " methods" : "";
    String calls = isShared() ? " called " + callCount() + " times" : "";
    return operations + in + calls + (remark.isEmpty() ? "" : " (" + remark + ")");
  }

  /**
   * Returns the angles whose sines and cosines the program needs, computed first: sine of angle i
   * in slot 2 i of the workspace, cosine in slot 2 i + 1.
   */
  public List<Scalar> angles() {
    return usage.angles();
  }

  /**
   * Returns the angles of each separate method for angles; empty if the main method has room for
   * all of them.
   */
  public List<List<AngleGroup>> angleParts() {
    List<AngleGroup> runs = AngleGroup.of(angles());
    int bytes = ownBytes();
    for (AngleGroup run : runs) {
      bytes += CodeSize.of(run);
    }
    return bytes > StraightLinePlanner.TOO_LONG ? grouped(runs, CodeSize::of) : List.of();
  }

  /** Returns an estimate of the main method without its angles. */
  private int ownBytes() {
    if (isOneMethod()) {
      return CodeSize.of(methods.get(0));
    }
    int bytes = 0;
    for (CallSequence step : steps) {
      bytes += CodeSize.of(step);
    }
    return bytes <= StraightLinePlanner.METHOD_BYTES ? bytes : parts().size() * CodeSize.STEP;
  }

  /** Returns whether parameters of the model are read. */
  public boolean readsModelParameters() {
    return reads(MethodSignature::isModelParameter);
  }

  /** Returns whether an input is read, by a section or as an angle. */
  private boolean reads(IntPredicate input) {
    for (List<Scalar> nodes : List.of(usage.given(), angles())) {
      for (Scalar node : nodes) {
        if (node.operation() == ScalarOperation.INPUT && input.test(node.index())) {
          return true;
        }
      }
    }
    return false;
  }

  /** Returns whether constants are read from the table of the class. */
  private boolean readsConstants() {
    for (MethodPlan method : methods) {
      for (ValueLocation place : method.places().values()) {
        if (place instanceof ValueLocation.Element element
            && element.array().equals(ConstantTable.NAME)) {
          return true;
        }
      }
    }
    return false;
  }

  /** Returns whether the whole program is written into the method that runs it. */
  public boolean isOneMethod() {
    return methods.size() == 1 && steps.size() == 1 && methods.get(0).parameters() == 0;
  }

  /** Returns the steps, divided into several methods if they are too long for one. */
  public List<List<CallSequence>> parts() {
    int bytes = 0;
    for (CallSequence step : steps) {
      bytes += CodeSize.of(step);
    }
    return bytes <= StraightLinePlanner.METHOD_BYTES
        ? List.of(steps)
        : grouped(steps, CodeSize::of);
  }

  /** Returns consecutive elements in as few groups as the size of methods permits. */
  private static <T> List<List<T>> grouped(List<T> all, ToIntFunction<T> size) {
    List<List<T>> groups = new ArrayList<>();
    int bytes = 0;
    for (T one : all) {
      int more = size.applyAsInt(one);
      if (groups.isEmpty() || bytes + more > StraightLinePlanner.METHOD_BYTES) {
        groups.add(new ArrayList<>());
        bytes = 0;
      }
      bytes += more;
      groups.get(groups.size() - 1).add(one);
    }
    return groups;
  }

  /** Returns whether a call can end the program. */
  public boolean checks(CallSequence.Call call) {
    return methods.get(call.method()).checks();
  }

  /** Returns whether any of these steps can end the program. */
  public boolean checks(List<CallSequence> some) {
    for (CallSequence step : some) {
      for (CallSequence.Call call : step.calls()) {
        if (checks(call)) {
          return true;
        }
      }
    }
    return false;
  }

  /**
   * Returns the fields that are passed to every method of the program: workspace and parameters.
   */
  public List<String> fields() {
    List<String> fields = new ArrayList<>();
    if (slots > 0) {
      fields.add(ParameterSlots.WORKSPACE);
    }
    if (readsModelParameters()) {
      fields.add(MethodSignature.MODEL_PARAMETERS.name());
    }
    if (readsConstants()) {
      fields.add(ConstantTable.NAME);
    }
    return fields;
  }

  /** Returns the parameters of a method that the program reads: all arrays, and numbers it uses. */
  public List<MethodSignature.Argument> arguments(MethodSignature head) {
    List<MethodSignature.Argument> read = new ArrayList<>();
    for (MethodSignature.Argument argument : head.arguments()) {
      if (argument.isArray() || reads(input -> input == argument.first())) {
        read.add(argument);
      }
    }
    return read;
  }
}
