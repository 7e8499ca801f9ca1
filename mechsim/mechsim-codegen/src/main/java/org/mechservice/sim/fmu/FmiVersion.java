package org.mechservice.sim.fmu;

import java.util.Arrays;

/** Version of the Functional Mock-up Interface. */
public enum FmiVersion {
  FMI_2("2.0", "mech_fmi2.c"),
  FMI_3("3.0", "mech_fmi3.c");

  private final String text;
  private final String source;

  FmiVersion(String text, String source) {
    this.text = text;
    this.source = source;
  }

  /** Returns the version as a description states it. */
  String text() {
    return text;
  }

  /** Returns the name of the C file with the interface's functions. */
  String source() {
    return source;
  }

  /**
   * Returns the version with a number.
   *
   * @param number {@code 2} or {@code 3}, or either followed by {@code .0}
   * @throws IllegalArgumentException if there is none; the message names those there are
   */
  public static FmiVersion of(String number) {
    return Arrays.stream(values())
        .filter(version -> version.text.equals(number) || version.text.equals(number + ".0"))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "FMI " + number + " is not written here: write 2 or 3"));
  }
}
