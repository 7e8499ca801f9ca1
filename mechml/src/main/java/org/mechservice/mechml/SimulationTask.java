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
   * @param modes whether frequencies, dampings and shapes are wanted
   */
  record Linearization(boolean atEquilibrium, boolean modes) implements SimulationTask {
    @Override
    public String element() {
      return "linearize";
    }
  }
}
