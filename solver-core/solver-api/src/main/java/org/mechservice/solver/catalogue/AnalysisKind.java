package org.mechservice.solver.catalogue;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * An analysis of a mechanism that a program asks for instead of the simulation that the file
 * describes.
 */
public enum AnalysisKind {
  /** The state in which the mechanism comes to rest. */
  EQUILIBRIUM("equilibrium"),
  /** Frequencies, dampings and shapes of small motions about the start. */
  MODES("modes"),
  /** The matrices M, C and K of small motions about the start. */
  LINEARISE("linearise"),
  /** The matrices A, B, C and D from inputs to outputs about the start. */
  LINEAR_SYSTEM("linear-system"),
  /** The motion of driven coordinates and of all that depend on them. */
  KINEMATICS("kinematics"),
  /** The forces that produce the prescribed motion. */
  INVERSE_DYNAMICS("inverse-dynamics");

  /** Name of the option of a request that asks for an analysis. */
  public static final String OPTION = "analysis";

  private final String label;

  AnalysisKind(String label) {
    this.label = label;
  }

  /** Returns the name in requests. */
  public String label() {
    return label;
  }

  /** Returns whether it computes small motions, whose rows are not those of a motion in time. */
  public boolean isLinear() {
    return this == MODES || this == LINEARISE || this == LINEAR_SYSTEM;
  }

  /** Returns the analysis of a name; empty if there is none. */
  public static Optional<AnalysisKind> of(String label) {
    return Arrays.stream(values()).filter(kind -> kind.label.equals(label)).findFirst();
  }

  /** Returns all names, separated by commas. */
  public static String labels() {
    return Arrays.stream(values()).map(AnalysisKind::label).collect(Collectors.joining(", "));
  }
}
