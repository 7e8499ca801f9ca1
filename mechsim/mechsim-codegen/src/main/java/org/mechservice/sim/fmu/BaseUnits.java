package org.mechservice.sim.fmu;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A unit as powers of base units of the SI.
 *
 * @param powers exponents of {@link #BASE}, in that order
 */
record BaseUnits(List<Integer> powers) {
  /** The base units that FMI names. */
  static final List<String> BASE = List.of("kg", "m", "s", "A", "K", "mol", "cd", "rad");

  private static final Map<String, BaseUnits> KNOWN = new LinkedHashMap<>();

  static {
    for (int i = 0; i < BASE.size(); i++) {
      List<Integer> powers = new ArrayList<>();
      for (int j = 0; j < BASE.size(); j++) {
        powers.add(i == j ? 1 : 0);
      }
      KNOWN.put(BASE.get(i), new BaseUnits(powers));
    }
    KNOWN.put("1", new BaseUnits(List.of(0, 0, 0, 0, 0, 0, 0, 0)));
    KNOWN.put("N", new BaseUnits(List.of(1, 1, -2, 0, 0, 0, 0, 0)));
    KNOWN.put("Pa", new BaseUnits(List.of(1, -1, -2, 0, 0, 0, 0, 0)));
    KNOWN.put("J", new BaseUnits(List.of(1, 2, -2, 0, 0, 0, 0, 0)));
    KNOWN.put("W", new BaseUnits(List.of(1, 2, -3, 0, 0, 0, 0, 0)));
    KNOWN.put("Hz", new BaseUnits(List.of(0, 0, -1, 0, 0, 0, 0, 0)));
  }

  BaseUnits {
    powers = List.copyOf(powers);
  }

  /**
   * Returns the base units of a product of powers: factors between {@code *} and {@code /}, with
   * {@code ^} and a whole number, parentheses; empty if it is none, or a factor is not of the SI.
   */
  static Optional<BaseUnits> of(String unit) {
    int[] sum = new int[BASE.size()];
    Parser parser = new Parser(unit, sum);
    if (!parser.product(1) || parser.at < unit.length()) {
      return Optional.empty();
    }
    return Optional.of(new BaseUnits(Arrays.stream(sum).boxed().toList()));
  }

  /** Reads a unit from the left and adds up powers. */
  private static final class Parser {
    private final String text;
    private final int[] sum;
    private int at;

    Parser(String text, int[] sum) {
      this.text = text;
      this.sum = sum;
    }

    /** Reads factors, each to the power of the sign; returns whether there is a product. */
    boolean product(int sign) {
      boolean good = factor(sign);
      while (good && (next('*') || next('/'))) {
        good = factor(text.charAt(at - 1) == '/' ? -sign : sign);
      }
      return good;
    }

    private boolean factor(int sign) {
      if (next('(')) {
        return product(sign) && next(')');
      }
      int from = at;
      while (at < text.length() && Character.isLetterOrDigit(text.charAt(at))) {
        at++;
      }
      BaseUnits known = KNOWN.get(text.substring(from, at));
      if (known == null) {
        return false;
      }
      int power = next('^') ? exponent() : 1;
      for (int i = 0; i < sum.length; i++) {
        sum[i] += sign * power * known.powers.get(i);
      }
      return power != 0;
    }

    /** Returns a whole number of one digit; 0 if there is none. */
    private int exponent() {
      int sign = next('-') ? -1 : 1;
      boolean digit = at < text.length() && text.charAt(at) >= '1' && text.charAt(at) <= '9';
      return digit ? sign * (text.charAt(at++) - '0') : 0;
    }

    private boolean next(char c) {
      boolean there = at < text.length() && text.charAt(at) == c;
      at += there ? 1 : 0;
      return there;
    }
  }
}
