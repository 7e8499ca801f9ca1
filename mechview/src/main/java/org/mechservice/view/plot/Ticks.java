package org.mechservice.view.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The scale of an axis: round numbers at round distances (1, 2 or 5 times a power of ten), written
 * with as many digits as tell them apart. Numbers that are large or small throughout are written as
 * multiples of a power of ten; numbers that differ in late digits only are written as differences
 * to one of them.
 */
final class Ticks {
  private static final String SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

  /** Largest number of decimal digits that labels have before they are written as differences. */
  private static final int MOST_DIGITS = 5;

  private final int exponent;
  private final double low;
  private final double high;
  private final double offset;
  private final int offsetExponent;
  private final int decimals;
  private final List<Double> places = new ArrayList<>();

  /**
   * Chooses a scale.
   *
   * @param least least value shown
   * @param greatest greatest value shown
   * @param pad part of the length that is left free at both ends
   * @param most about how many numbers there may be, at least 2
   */
  Ticks(double least, double greatest, double pad, int most) {
    double size = Math.max(Math.abs(least), Math.abs(greatest));
    int magnitude = size < 1e-300 ? 0 : (int) Math.floor(Math.log10(size));
    exponent = magnitude >= 5 || magnitude <= -4 ? Math.floorDiv(magnitude, 3) * 3 : 0;
    double from = scaled(least);
    double to = scaled(greatest);
    double biggest = Math.max(Math.abs(from), Math.abs(to));
    // Sixteen digits: below this length the curve shows rounding only.
    if (to - from <= 1e-13 * biggest || biggest < 1e-300) {
      double room = biggest < 1e-300 ? 1 : 0.1 * biggest;
      from -= room;
      to += room;
    }
    double room = pad * (to - from);
    low = from - room;
    high = to + room;
    double step = step(0.8 * (high - low) / most);
    int stepDigits = Math.max(0, (int) -Math.floor(Math.log10(step) + 1e-9));
    double first = Math.ceil(low / step - 1e-9);
    int wholeDigits = biggest < 1 ? 1 : (int) Math.floor(Math.log10(biggest)) + 1;
    boolean late = wholeDigits + stepDigits > MOST_DIGITS + 2;
    offset = late ? first * step : 0;
    offsetExponent = late ? stepExponent(step) : 0;
    decimals = late ? 0 : stepDigits;
    for (double k = first; k * step <= high + 1e-9 * step; k++) {
      places.add(k * step);
    }
  }

  private static int stepExponent(double step) {
    return (int) Math.floor(Math.log10(step) + 1e-9);
  }

  private static double step(double least) {
    double power = Math.pow(10, Math.floor(Math.log10(least)));
    for (double factor : new double[] {1, 2, 5}) {
      if (factor * power >= least * (1 - 1e-9)) {
        return factor * power;
      }
    }
    return 10 * power;
  }

  private double scaled(double value) {
    return exponent == 0 ? value : value / Math.pow(10, exponent);
  }

  /** Returns where a value is: 0 at the lower end, 1 at the upper. */
  double part(double value) {
    return (scaled(value) - low) / (high - low);
  }

  /** Returns where the numbers are, from 0 at the lower end to 1 at the upper. */
  List<Double> parts() {
    return places.stream().map(place -> (place - low) / (high - low)).toList();
  }

  /** Returns the numbers in words of the axis, one for each part. */
  List<String> labels() {
    return places.stream().map(this::label).toList();
  }

  private String label(double place) {
    double shown = (place - offset) / Math.pow(10, offsetExponent);
    if (Math.abs(shown) < 1e-9) {
      shown = 0;
    }
    return minus(String.format(Locale.ROOT, "%." + decimals + "f", shown));
  }

  private static String minus(String number) {
    return number.replace('-', '−');
  }

  /** Returns the title of the axis with what its numbers leave out. */
  String title(String quantity, String unit) {
    String name = quantity;
    if (offset != 0) {
      String subtracted =
          String.format(Locale.ROOT, "%." + Math.max(0, -offsetExponent) + "f", Math.abs(offset));
      name += (offset < 0 ? " + " : " − ") + subtracted + power(exponent, "·");
    }
    String scale = power(exponent + offsetExponent, "");
    String inUnits = scale.isEmpty() ? unit : unit.isEmpty() ? scale : scale + " " + unit;
    if (inUnits.isEmpty()) {
      return name;
    }
    return name.isEmpty() ? inUnits : name + " (" + inUnits + ")";
  }

  private static String power(int exponent, String before) {
    if (exponent == 0) {
      return "";
    }
    StringBuilder text = new StringBuilder(before).append("10").append(exponent < 0 ? "⁻" : "");
    for (char digit : Integer.toString(Math.abs(exponent)).toCharArray()) {
      text.append(SUPERSCRIPTS.charAt(digit - '0'));
    }
    return text.toString();
  }
}
