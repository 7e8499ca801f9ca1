package org.mechservice.sim.emit.method;

import java.util.List;
import org.mechservice.solver.symbol.Program;

/**
 * The method of a model that runs a program.
 *
 * @param name its name, and the prefix of the names of its parts
 * @param arguments parameters that hold the program's inputs, in order
 * @param output name of the last parameter, the array of outputs
 * @param returnsResult whether the method returns the result of the guard that failed
 * @param isPublic whether it is a method of the model's interfaces
 */
public record MethodSignature(
    String name, List<Argument> arguments, String output, boolean returnsResult, boolean isPublic) {
  /**
   * A parameter.
   *
   * @param name its name
   * @param isArray whether it is an array of numbers, otherwise a number
   * @param first index of the program's input that it, or its first element, holds
   */
  public record Argument(String name, boolean isArray, int first) {}

  /** The parameters of the model: a field that is passed to every method. */
  public static final Argument MODEL_PARAMETERS = new Argument("p", true, Program.PARAMETER);

  /** Returns the name of a method of its own that computes angles. */
  public String anglesName(int part) {
    return name + "Angles" + (part + 1);
  }

  /** Returns whether an input is a parameter of the model. */
  public static boolean isModelParameter(int input) {
    return input >= Program.PARAMETER && input < Program.PLACEHOLDER;
  }

  /** Returns the parameter that holds an input: the last one that begins at or before it. */
  public Argument argumentOf(int input) {
    if (isModelParameter(input)) {
      return MODEL_PARAMETERS;
    }
    Argument found = arguments.get(0);
    for (Argument argument : arguments) {
      boolean later = found.first() > input || argument.first() > found.first();
      found = argument.first() <= input && later ? argument : found;
    }
    return found;
  }
}
