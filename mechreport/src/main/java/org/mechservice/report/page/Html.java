package org.mechservice.report.page;

import java.util.Locale;

/** Text and numbers for pages. */
final class Html {
  private Html() {}

  /** Returns a text with the characters of HTML markup escaped. */
  static String escape(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  /** Returns a time with a unit that suits it. */
  static String seconds(double seconds) {
    if (!(seconds >= 0)) {
      return "–";
    } else if (seconds < 1e-3) {
      return digits(seconds * 1e6) + " µs";
    } else if (seconds < 1) {
      return digits(seconds * 1e3) + " ms";
    }
    return digits(seconds) + " s";
  }

  /** Returns a number of bytes with a unit that suits it. */
  static String bytes(double bytes) {
    if (bytes < 1e3) {
      return digits(bytes) + " B";
    } else if (bytes < 1e6) {
      return digits(bytes / 1e3) + " kB";
    }
    return digits(bytes / 1e6) + " MB";
  }

  /** Returns a number with three digits, or all of them before the point. */
  static String digits(double value) {
    double size = Math.abs(value);
    if (size >= 99.95 || size == 0) {
      return String.format(Locale.ROOT, "%.0f", value);
    }
    return String.format(Locale.ROOT, size >= 9.995 ? "%.1f" : "%.2f", value);
  }

  /** Returns an error with two digits. */
  static String error(double error) {
    if (Double.isNaN(error)) {
      return "–";
    }
    if (Double.isInfinite(error)) {
      return "∞";
    }
    return error == 0 ? "0" : power(String.format(Locale.ROOT, "%.1e", error));
  }

  /** Returns a tolerance as a power of ten. */
  static String tolerance(double tolerance) {
    return power(String.format(Locale.ROOT, "%.0e", tolerance));
  }

  /** Returns a number of any size with three digits. */
  static String number(double value) {
    double size = Math.abs(value);
    return size != 0 && (size >= 1e5 || size < 1e-2)
        ? power(String.format(Locale.ROOT, "%.2e", value))
        : digits(value);
  }

  private static String power(String text) {
    return text.replace("e-0", "e-").replace("e+0", "e").replace("e+", "e");
  }

  /** Returns a factor between two costs. */
  static String factor(double factor) {
    return digits(factor) + "×";
  }
}
