package org.mechservice.solver.analysis;

import java.util.List;
import java.util.Locale;

/**
 * The result of a linearisation.
 *
 * @param kind the table
 * @param from lowest frequency of a response, Hz
 * @param to highest frequency, Hz
 * @param points number of frequencies, at equal ratios
 */
record LinearResult(Kind kind, double from, double to, int points) {
  /** Tables. */
  enum Kind {
    /** Eigenvalues and shapes. */
    MODES,
    /** M, C and K. */
    EQUATIONS,
    /** A, B, C and D. */
    SYSTEM,
    /** The frequency response. */
    RESPONSE,
    /** The transmission zeros. */
    ZEROS
  }

  /** Returns the result of words: the kind, and for a response its frequencies. */
  static LinearResult of(List<String> words) {
    Kind kind = Kind.valueOf(words.get(0).toUpperCase(Locale.ROOT));
    return kind == Kind.RESPONSE
        ? new LinearResult(
            kind,
            Double.parseDouble(words.get(1)),
            Double.parseDouble(words.get(2)),
            Integer.parseInt(words.get(3)))
        : new LinearResult(kind, 0, 0, 0);
  }

  /** Returns the number of words after the kind. */
  int frequencies() {
    return kind == Kind.RESPONSE ? 3 : 0;
  }

  /** Returns whether it is computed from A, B, C and D. */
  boolean isOfSystem() {
    return kind == Kind.SYSTEM || kind == Kind.RESPONSE || kind == Kind.ZEROS;
  }

  /** Returns a frequency, Hz. */
  double frequency(int point) {
    return point == points - 1
        ? to
        : from * StrictMath.pow(to / from, point / (double) Math.max(1, points - 1));
  }
}
