package org.mechservice.library;

import java.util.Optional;

/** A simulation of a {@link MechanismBuilder}: {@code dynamic}, {@code kinematic} and so on. */
public final class SimulationElement extends BuiltElement<SimulationElement> {
  private final OtherElement simulation;

  SimulationElement(String task, OtherElement simulation) {
    super(task, Optional.of(simulation));
    this.simulation = simulation;
  }

  @Override
  SimulationElement self() {
    return this;
  }

  /** Gives it a name, by which {@link MechModel#simulation} chooses it. */
  public SimulationElement named(String name) {
    simulation.set("name", name);
    return this;
  }

  /** Sets start, end and distance of the rows, s. */
  public SimulationElement time(double tStart, double tEnd, double tStep) {
    section("timeSet").set("tini", tStart).set("tend", tEnd).set("tstep", tStep);
    return this;
  }

  /**
   * Chooses an integrator, such as {@code ode113} or {@code auto}.
   *
   * @param relative tolerance of each step, relative to the state
   * @param absolute one tolerance, SI, or four: of displacements, angles, velocities, angular
   *     velocities
   */
  public SimulationElement integrator(String name, double relative, double... absolute) {
    section("integrator").set("name", name).set("relTol", relative).set("absTol", absolute);
    return this;
  }

  /** Chooses a formulation: {@code auto}, {@code DTR}, {@code RR} etc. */
  public SimulationElement formulation(String name) {
    section("formulation").set("name", name);
    return this;
  }

  /** Chooses groups of columns, such as {@code energy}. */
  public SimulationElement columns(String... groups) {
    section("output").set("columns", String.join(";", groups));
    return this;
  }

  /**
   * Adds an event at the zeros of an expression.
   *
   * @param action {@code stop}, {@code record} or {@code set}; the last has elements {@code set}
   */
  public OtherElement event(String name, String expression, String action) {
    return element("event", "name", name, "expression", expression, "action", action);
  }
}
