package org.mechservice.study.optimise;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.mechml.expression.ConstantEvaluation;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ExpressionParser;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.mechml.expression.References;
import org.mechservice.mechml.expression.Scope;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.study.Reduction;

/**
 * A formula of reductions of outputs and of parameters, such as {@code rms(seat.a) + 0.1*max(x)} or
 * {@code max(x)/c}: a formula of model files, whose names are parameters, and in which a call that
 * is none of its functions is a reduction. {@code min} and {@code max} of one output are
 * reductions, of two numbers the functions.
 */
final class ReductionExpression {
  /** A name with the bracket behind it. */
  private static final Pattern CALL =
      Pattern.compile("(?<![A-Za-z0-9_.\\]])([A-Za-z_][A-Za-z0-9_]*)\\s*\\(");

  private final String text;
  private final ParsedExpression formula;

  /** Index of the reduction that each name stands for. */
  private final Map<String, Integer> taken;

  private final boolean constant;

  private ReductionExpression(
      String text, ParsedExpression formula, Map<String, Integer> taken, boolean constant) {
    this.text = text;
    this.formula = formula;
    this.taken = taken;
    this.constant = constant;
  }

  /**
   * Reads a formula.
   *
   * @param text the formula
   * @param reductions those of all formulas so far; new ones are added
   * @param parameters names that may stand for themselves
   * @throws IllegalArgumentException if it cannot be read; says where
   */
  static ReductionExpression parse(
      String text, List<Reduction> reductions, Set<String> parameters) {
    Map<String, Integer> taken = new HashMap<>();
    String plain = named(text, reductions, taken);
    ParsedExpression formula;
    try {
      formula = ExpressionParser.parse(plain);
    } catch (ExpressionException e) {
      String reason = e.reason();
      for (Map.Entry<String, Integer> name : taken.entrySet()) {
        reason = reason.replace(name.getKey(), reductions.get(name.getValue()).toString());
      }
      throw wrong(text, reason + ", at character " + (e.offset() + 1));
    }
    boolean constant = true;
    for (ParsedExpression.Reference name : References.in(formula)) {
      String known = name.text();
      boolean varies = taken.containsKey(known) || parameters.contains(known);
      constant &= !varies;
      if (!varies && !isConstant(name)) {
        throw wrong(
            text,
            "\"%s\" is no parameter; of an output write what is taken, such as last(%s), max(%s) or"
                    .formatted(known, known, known)
                + " rms(%s)".formatted(known));
      }
    }
    return new ReductionExpression(text, formula, taken, constant);
  }

  /** Returns whether a name means a number in every formula. */
  private static boolean isConstant(ParsedExpression.Reference name) {
    try {
      Scope.CONSTANTS.value(name);
      return true;
    } catch (ExpressionException e) {
      return false;
    }
  }

  /** Returns a formula with a name, of the same length, for each reduction in it. */
  private static String named(String text, List<Reduction> reductions, Map<String, Integer> taken) {
    StringBuilder plain = new StringBuilder(text);
    Matcher call = CALL.matcher(text);
    for (int at = 0; call.find(at); ) {
      int from = call.start(1);
      int bracket = call.end() - 1;
      if (isFunction(call.group(1), text, bracket)) {
        at = bracket;
        continue;
      }
      int to = end(text, bracket);
      Reduction reduction = reduction(text, text.substring(from, to));
      if (!reductions.contains(reduction)) {
        reductions.add(reduction);
      }
      String name = "_" + taken.size();
      name = name + "_".repeat(Math.max(0, to - from - name.length()));
      taken.put(name, reductions.indexOf(reduction));
      plain.replace(from, to, name);
      at = to;
    }
    return plain.toString();
  }

  private static boolean isFunction(String name, String text, int bracket) {
    boolean both = name.equals(MathFunction.MIN.symbol()) || name.equals(MathFunction.MAX.symbol());
    return both ? hasComma(text, bracket) : MathFunction.named(name).isPresent();
  }

  private static boolean hasComma(String text, int bracket) {
    int depth = 0;
    for (int i = bracket; i < text.length(); i++) {
      char c = text.charAt(i);
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (depth == 0 || (depth == 1 && c == ',')) {
        return depth == 1;
      }
    }
    return false;
  }

  private static int end(String text, int bracket) {
    int depth = 0;
    for (int i = bracket; i < text.length(); i++) {
      char c = text.charAt(i);
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (depth == 0) {
        return i + 1;
      }
    }
    throw wrong(text, "a closing bracket is missing");
  }

  private static Reduction reduction(String text, String call) {
    Reduction reduction;
    try {
      reduction = Reduction.parse(call);
    } catch (IllegalArgumentException e) {
      throw wrong(text, String.valueOf(e.getMessage()));
    }
    if (reduction.kind() == Reduction.Kind.SERIES) {
      throw wrong(text, "a series is not one number; write at(" + reduction.column() + ", TIME)");
    }
    return reduction;
  }

  private static IllegalArgumentException wrong(String text, String why) {
    return new IllegalArgumentException("\"" + text.strip() + "\": " + why);
  }

  /** Returns whether neither an output nor a parameter is in it. */
  boolean isConstant() {
    return constant;
  }

  /**
   * Returns the value.
   *
   * @param reduced values of the reductions
   * @param parameters values of parameters by name
   * @return NaN where a part of the formula has no finite value
   */
  double value(double[] reduced, Map<String, Double> parameters) {
    try {
      return ConstantEvaluation.of(formula, name -> valueOf(name, reduced, parameters));
    } catch (ExpressionException e) {
      return Double.NaN;
    }
  }

  private double valueOf(
      ParsedExpression.Reference name, double[] reduced, Map<String, Double> parameters)
      throws ExpressionException {
    Integer index = taken.get(name.text());
    if (index != null) {
      return reduced[index];
    }
    Double parameter = parameters.get(name.text());
    return parameter == null ? Scope.CONSTANTS.value(name) : parameter;
  }

  @Override
  public String toString() {
    return text.strip();
  }
}
