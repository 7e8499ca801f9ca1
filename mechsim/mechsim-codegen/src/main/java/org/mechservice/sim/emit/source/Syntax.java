package org.mechservice.sim.emit.source;

import java.util.List;
import java.util.Set;
import org.mechservice.solver.symbol.MathFunction;

/** The differences between the languages that planned programs are printed in. */
public interface Syntax {
  /** Java, as a method of the model's class. */
  Syntax JAVA = new JavaSyntax();

  /** Returns a parameter that is an array of numbers. */
  String array(String name, boolean isWritten);

  /**
   * Returns the line that opens the method or function that runs a program.
   *
   * @param modifiers {@code public} or {@code private}, for languages that say so
   */
  String head(String modifiers, String result, String name, List<String> parameters);

  /** Returns the line that opens a part of it. */
  String part(String result, String name, List<String> parameters);

  /** Returns the name of the model inside {@link #head}. */
  String receiver();

  /** Returns the statement that makes a field of the model a local variable. */
  String field(String name);

  /** Returns the call that writes sine and cosine of an angle to two slots of the workspace. */
  String sinCos(String angle, String slot);

  /** Returns the statement that copies elements of an array. */
  String copy(String from, int fromAt, String to, int toAt, int count);

  String squareRoot(String value);

  /** Returns the arguments that tell a function where the numbers of a row are. */
  String row(int first, int count);

  /** Returns the name by which a function is called. */
  String function(MathFunction function);

  /** Returns words that cannot be names of values, besides those of the parameters. */
  Set<String> reserved();

  /**
   * Returns the statements that a function body needs for parameters that it does not read.
   *
   * @param names names of the parameters
   * @param body text of the body
   */
  List<String> unused(List<String> names, String body);
}
