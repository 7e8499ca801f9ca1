package org.mechservice.mechml;

/** Kind of computation that a simulation block requests. */
public sealed interface SimulationTask {

  /** Returns the name of its MechML element, such as {@code dynamic}. */
  String element();

  /** Motion under forces. */
  record Dynamic() implements SimulationTask {
    @Override
    public String element() {
      return "dynamic";
    }
  }

  /** Kinematics: the motion of driven coordinates and of all coordinates that depend on them. */
  record Kinematic() implements SimulationTask {
    @Override
    public String element() {
      return "kinematic";
    }
  }

  /**
   * Equilibrium at rest.
   *
   * @param tolerance largest joint force left over, N or N·m, relative to the largest in play
   * @param maxIterations corrections allowed
   */
  record StaticEquilibrium(double tolerance, int maxIterations) implements SimulationTask {
    /**
     * Defaults: nine digits, and ten times as many corrections as Newton's method usually needs.
     */
    public static final StaticEquilibrium DEFAULT = new StaticEquilibrium(1e-9, 100);

    @Override
    public String element() {
      return "static";
    }
  }

  /** Inverse dynamics: the forces that produce the prescribed motion. */
  record InverseDynamic() implements SimulationTask {
    @Override
    public String element() {
      return "inverseDynamic";
    }
  }

  /**
   * Linear equations of small motions.
   *
   * @param atEquilibrium whether about the equilibrium, else about the start
   * @param gives what is wanted
   * @param from lowest frequency of a response, Hz
   * @param to highest frequency of a response, Hz
   * @param points number of frequencies of a response
   */
  record Linearization(boolean atEquilibrium, Result gives, double from, double to, int points)
      implements SimulationTask {
    /** Creates a linearisation without frequencies. */
    public Linearization(boolean atEquilibrium, Result gives) {
      this(atEquilibrium, gives, 0, 0, 0);
    }

    /** What a linearisation gives. */
    public enum Result {
      /** Frequencies, dampings and shapes. */
      MODES,
      /** M, C and K. */
      EQUATIONS,
      /** A, B, C and D from inputs to outputs. */
      SYSTEM,
      /** The frequency response from inputs to outputs. */
      RESPONSE,
      /** The transmission zeros from inputs to outputs. */
      ZEROS
    }

    @Override
    public String element() {
      return "linearize";
    }
  }
}
