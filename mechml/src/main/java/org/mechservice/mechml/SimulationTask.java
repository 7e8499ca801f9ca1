package org.mechservice.mechml;

/** What a simulation block asks for. */
public sealed interface SimulationTask {

  /** Returns the element that asks for it, such as {@code dynamic}. */
  String element();

  /** Motion under forces. */
  record Dynamic() implements SimulationTask {
    @Override
    public String element() {
      return "dynamic";
    }
  }

  /** Motion of driven coordinates and what follows from it. */
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
    /** What holds where the file says nothing: nine digits, and ten times what Newton needs. */
    public static final StaticEquilibrium DEFAULT = new StaticEquilibrium(1e-9, 100);

    @Override
    public String element() {
      return "static";
    }
  }

  /** Forces that the prescribed motion needs. */
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
