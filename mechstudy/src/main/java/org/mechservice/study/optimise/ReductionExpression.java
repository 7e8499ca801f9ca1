package org.mechservice.study.optimise;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.solver.expression.Function;
import org.mechservice.study.Reduction;

/**
 * A formula of reductions of outputs and of parameters, such as {@code rms(seat.a) + 0.1*max(x)} or
 * {@code max(x)/c}: {@code + - * / ^}, brackets, {@code sqrt abs exp log sin cos}.
 */
final class ReductionExpression {
  /** The value of a part of the formula. */
  @FunctionalInterface
  private interface Term {
    /**
     * @param reduced values of the reductions
     * @param parameters values of parameters by name
     */
    double value(double[] reduced, Map<String, Double> parameters);
  }

  /** Functions of one argument, with the values that they have in constants of model files. */
  private static final Map<String, Function> FUNCTIONS =
      Stream.of(Function.SQRT, Function.ABS, Function.EXP, Function.LOG, Function.SIN, Function.COS)
          .collect(Collectors.toUnmodifiableMap(Function::symbol, function -> function));

  private final String text;
  private final Term term;
  private final boolean constant;

  private ReductionExpression(String text, Term term, boolean constant) {
    this.text = text;
    this.term = term;
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
    Parser parser = new Parser(text, reductions, parameters);
    Term term = parser.whole();
    return new ReductionExpression(text, term, parser.constant);
  }

  /** Returns whether neither an output nor a parameter is in it. */
  boolean isConstant() {
    return constant;
  }

  double value(double[] reduced, Map<String, Double> parameters) {
    return term.value(reduced, parameters);
  }

  @Override
  public String toString() {
    return text.strip();
  }

  /** Recursive descent: sum, product, power, sign, atom. */
  private static final class Parser {
    private final String text;
    private final List<Reduction> reductions;
    private final Set<String> parameters;
    private int at;
    private boolean constant = true;

    Parser(String text, List<Reduction> reductions, Set<String> parameters) {
      this.text = text;
      this.reductions = reductions;
      this.parameters = parameters;
    }

    Term whole() {
      Term sum = sum();
      if (!rest().isEmpty()) {
        throw wrong("\"" + rest() + "\" cannot follow here");
      }
      return sum;
    }

    private Term sum() {
      Term left = product();
      while (true) {
        Term a = left;
        if (take('+')) {
          Term b = product();
          left = (r, p) -> a.value(r, p) + b.value(r, p);
        } else if (take('-')) {
          Term b = product();
          left = (r, p) -> a.value(r, p) - b.value(r, p);
        } else {
          return left;
        }
      }
    }

    private Term product() {
      Term left = sign();
      while (true) {
        Term a = left;
        if (take('*')) {
          Term b = sign();
          left = (r, p) -> a.value(r, p) * b.value(r, p);
        } else if (take('/')) {
          Term b = sign();
          left = (r, p) -> a.value(r, p) / b.value(r, p);
        } else {
          return left;
        }
      }
    }

    private Term sign() {
      if (take('-')) {
        Term a = sign();
        return (r, p) -> -a.value(r, p);
      }
      return take('+') ? sign() : power();
    }

    private Term power() {
      Term a = atom();
      if (take('^')) {
        Term b = sign();
        return (r, p) -> Function.POW.at(new double[] {a.value(r, p), b.value(r, p)});
      }
      return a;
    }

    private Term atom() {
      if (take('(')) {
        Term inside = sum();
        if (!take(')')) {
          throw wrong("a closing bracket is missing");
        }
        return inside;
      }
      String rest = rest();
      if (rest.isEmpty()) {
        throw wrong("it ends where a value is expected");
      }
      char first = rest.charAt(0);
      if (Character.isDigit(first) || first == '.') {
        return number();
      } else if (Character.isLetter(first) || first == '_') {
        return named();
      }
      throw wrong("\"" + first + "\" is no value");
    }

    private Term number() {
      int from = at;
      while (at < text.length() && (Character.isDigit(text.charAt(at)) || text.charAt(at) == '.')) {
        at++;
      }
      int mantissa = at;
      if (at < text.length() && Character.toLowerCase(text.charAt(at)) == 'e') {
        at++;
        if (at < text.length() && (text.charAt(at) == '-' || text.charAt(at) == '+')) {
          at++;
        }
        int digits = at;
        while (at < text.length() && Character.isDigit(text.charAt(at))) {
          at++;
        }
        at = at == digits ? mantissa : at;
      }
      try {
        double value = Double.parseDouble(text.substring(from, at));
        return (r, p) -> value;
      } catch (NumberFormatException e) {
        throw wrong("\"" + text.substring(from, at) + "\" is no number");
      }
    }

    private Term named() {
      int from = at;
      while (at < text.length()
          && (Character.isLetterOrDigit(text.charAt(at)) || "_.[]".indexOf(text.charAt(at)) >= 0)) {
        at++;
      }
      String name = text.substring(from, at);
      if (!rest().startsWith("(")) {
        if (!parameters.contains(name)) {
          throw wrong(
              "\""
                  + name
                  + "\" is no parameter; of an output write what is taken, such as last("
                  + name
                  + "), max("
                  + name
                  + ") or rms("
                  + name
                  + ")");
        }
        constant = false;
        return (r, p) -> p.getOrDefault(name, Double.NaN);
      }
      Function function = FUNCTIONS.get(name);
      if (function != null) {
        take('(');
        Term inside = sum();
        if (!take(')')) {
          throw wrong("a closing bracket is missing");
        }
        return (r, p) -> function.at(new double[] {inside.value(r, p)});
      }
      return reduction(from);
    }

    private Term reduction(int from) {
      int depth = 0;
      do {
        if (at >= text.length()) {
          throw wrong("a closing bracket is missing");
        }
        char c = text.charAt(at++);
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      } while (depth > 0 || text.charAt(at - 1) != ')');
      Reduction reduction;
      try {
        reduction = Reduction.parse(text.substring(from, at));
      } catch (IllegalArgumentException e) {
        throw wrong(String.valueOf(e.getMessage()));
      }
      if (reduction.kind() == Reduction.Kind.SERIES) {
        throw wrong("a series is not one number; write at(" + reduction.column() + ", TIME)");
      }
      constant = false;
      if (!reductions.contains(reduction)) {
        reductions.add(reduction);
      }
      int index = reductions.indexOf(reduction);
      return (r, p) -> r[index];
    }

    private boolean take(char wanted) {
      String rest = rest();
      if (!rest.isEmpty() && rest.charAt(0) == wanted) {
        at++;
        return true;
      }
      return false;
    }

    /** Returns the text that is left, from its first character that is no space. */
    private String rest() {
      while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
        at++;
      }
      return text.substring(at);
    }

    private IllegalArgumentException wrong(String why) {
      return new IllegalArgumentException("\"" + text.strip() + "\": " + why);
    }
  }
}
