package org.mechservice.mechml;

import java.util.List;
import java.util.Map;
import java.util.Optional;

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
   * @param trim what is sought instead of rest; empty for rest
   */
  record StaticEquilibrium(double tolerance, int maxIterations, Optional<TrimProblem> trim)
      implements SimulationTask {
    /**
     * Defaults: nine digits, and ten times as many corrections as Newton's method usually needs.
     */
    public static final StaticEquilibrium DEFAULT =
        new StaticEquilibrium(1e-9, 100, Optional.empty());

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
   * @param trim the state about which it linearises; empty for start or equilibrium
   */
  record Linearization(
      boolean atEquilibrium,
      Result gives,
      double from,
      double to,
      int points,
      Optional<TrimProblem> trim)
      implements SimulationTask {
    /** Creates a linearisation without frequencies. */
    public Linearization(boolean atEquilibrium, Result gives) {
      this(atEquilibrium, gives, 0, 0, 0, Optional.empty());
    }

    /** Returns the same linearisation about a trimmed state. */
    public Linearization about(Optional<TrimProblem> state) {
      return new Linearization(atEquilibrium, gives, from, to, points, state);
    }

    /** The result of a linearisation. */
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

  /**
   * A trim problem: values of unknowns for which quantities have given values.
   *
   * @param unknowns coordinates such as {@code hinge.q}, velocities such as {@code car.v[0]},
   *     states and inputs
   * @param conditions accelerations such as {@code hinge.a}, rates of states such as {@code
   *     filter.rate}, and outputs, with their values in SI or in the unit of the state or output
   */
  record TrimProblem(List<String> unknowns, Map<String, Double> conditions) {
    public TrimProblem {
      unknowns = List.copyOf(unknowns);
    }
  }
}
