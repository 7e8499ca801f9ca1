package org.mechservice.benchmarks.suite;

import java.util.List;
import java.util.Locale;
import java.util.function.ToIntFunction;

/**
 * An expression of the suite's problem file: numbers, + - * / **, brackets, the functions sin cos
 * exp sqrt log asin, pi, and names.
 *
 * <p>The parser of model files is not used: {@code peers.py} evaluates the same texts as Python, so
 * powers are written {@code **}; names stand for places of one array, where the parser of model
 * files knows joints and parameters; and functions are those of {@link Math}, so another evaluation
 * would change the last bits of the recorded tables.
 */
final class Formula {
  private static final List<String> FUNCTIONS = List.of("sin", "cos", "exp", "sqrt", "log", "asin");

  private final String text;
  private final ToIntFunction<String> slots;
  private int at;

  private Formula(String text, ToIntFunction<String> slots) {
    this.text = text.replace(" ", "");
    this.slots = slots;
  }

  /** Evaluates with the values of all names. */
  interface Node {
    /** Returns the value, given those of the names by slot. */
    double at(double[] values);
  }

  /**
   * Reads an expression.
   *
   * @param slots place of each name among the values
   * @throws IllegalArgumentException if it cannot be read
   */
  static Node of(String text, ToIntFunction<String> slots) {
    Formula formula = new Formula(text, slots);
    Node node = formula.sum();
    if (formula.at < formula.text.length()) {
      throw formula.unreadable();
    }
    return node;
  }

  private IllegalArgumentException unreadable() {
    return new IllegalArgumentException("cannot read " + text + " at " + at);
  }

  private boolean next(String symbol) {
    boolean found = text.startsWith(symbol, at);
    at += found ? symbol.length() : 0;
    return found;
  }

  private Node sum() {
    Node left = product();
    while (true) {
      Node first = left;
      if (next("+")) {
        Node second = product();
        left = values -> first.at(values) + second.at(values);
      } else if (next("-")) {
        Node second = product();
        left = values -> first.at(values) - second.at(values);
      } else {
        return left;
      }
    }
  }

  private Node product() {
    Node left = sign();
    while (true) {
      Node first = left;
      if (!text.startsWith("**", at) && next("*")) {
        Node second = sign();
        left = values -> first.at(values) * second.at(values);
      } else if (next("/")) {
        Node second = sign();
        left = values -> first.at(values) / second.at(values);
      } else {
        return left;
      }
    }
  }

  private Node sign() {
    if (next("-")) {
      Node positive = sign();
      return values -> -positive.at(values);
    }
    return next("+") ? sign() : power();
  }

  private Node power() {
    Node base = atom();
    if (!next("**")) {
      return base;
    }
    Node exponent = sign();
    return values -> {
      double power = exponent.at(values);
      double x = base.at(values);
      return power == 2 ? x * x : power == 3 ? x * x * x : Math.pow(x, power);
    };
  }

  private Node atom() {
    if (next("(")) {
      Node inner = sum();
      if (!next(")")) {
        throw unreadable();
      }
      return inner;
    }
    int from = at;
    if (at < text.length() && Character.isLetter(text.charAt(at))) {
      while (at < text.length() && isNamePart(text.charAt(at))) {
        at++;
      }
      return named(text.substring(from, at));
    }
    return number();
  }

  private static boolean isNamePart(char c) {
    return Character.isLetterOrDigit(c) || c == '_';
  }

  private Node named(String name) {
    if (name.equals("pi")) {
      return values -> Math.PI;
    }
    if (!FUNCTIONS.contains(name)) {
      int slot = slots.applyAsInt(name);
      if (slot < 0) {
        throw unreadable();
      }
      return values -> values[slot];
    }
    Node argument = atom();
    return switch (name.toLowerCase(Locale.ROOT)) {
      case "sin" -> values -> Math.sin(argument.at(values));
      case "cos" -> values -> Math.cos(argument.at(values));
      case "exp" -> values -> Math.exp(argument.at(values));
      case "sqrt" -> values -> Math.sqrt(argument.at(values));
      case "log" -> values -> Math.log(argument.at(values));
      default -> values -> Math.asin(argument.at(values));
    };
  }

  private Node number() {
    int from = at;
    while (at < text.length() && isNumberPart(from)) {
      at++;
    }
    if (from == at) {
      throw unreadable();
    }
    double value = Double.parseDouble(text.substring(from, at));
    return values -> value;
  }

  private boolean isNumberPart(int from) {
    char c = text.charAt(at);
    boolean exponentSign = (c == '-' || c == '+') && at > from && text.charAt(at - 1) == 'e';
    return Character.isDigit(c) || c == '.' || c == 'e' || exponentSign;
  }
}
