package org.mechservice.study.gradient;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** The methods of computing derivatives. */
public enum GradientMethod {
  /** The cheaper one. */
  AUTO,
  /** Tangents along with the state: one more system for each parameter. */
  FORWARD,
  /** Backwards in time: one more system for each number that is differentiated. */
  ADJOINT;

  /** Returns the word of the options. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the method of a word, if there is one. */
  public static Optional<GradientMethod> named(String label) {
    return Stream.of(values()).filter(method -> method.label().equals(label)).findFirst();
  }
}
