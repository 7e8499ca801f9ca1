package org.mechservice.sim.equations;

import java.util.List;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import org.mechservice.sim.equations.force.AppliedForces;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.PositionRates;
import org.mechservice.sim.equations.recursion.AccelerationSweep;
import org.mechservice.sim.equations.recursion.CarriedEquations;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.InertiaSweep;
import org.mechservice.sim.equations.recursion.JointForces;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.DegreeOfFreedom;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * y' = f(t, y) of an open chain, totally recursive (DTR,
 * docs/theory/formulations.md#dtr-articulated-bodies), in three sweeps. The first goes outwards and
 * computes the forces of the motion with zero joint accelerations. The second goes inwards and
 * computes articulated inertias and bias forces. The third goes outwards and computes the joint
 * accelerations.
 */
public final class ArticulatedBodyEquations {
  private final Program program;
  private final Links mechanism;
  private final Coordinates coordinates;

  ArticulatedBodyEquations(Program program, Links mechanism) {
    this.program = program;
    this.mechanism = mechanism;
    this.coordinates = new Coordinates(program, mechanism).inSharedForms(mechanism);
  }

  /**
   * Derives the program from the state [q; v] to its derivative [q'; v'].
   *
   * @param mechanism the open chain
   * @return a program whose guards return the index, among the joints that have states, of the
   *     joint beyond which there is no inertia
   */
  public static Program derive(Links mechanism) {
    Program program = new Program();
    ArticulatedBodyEquations equations = new ArticulatedBodyEquations(program, mechanism);
    new PositionRates(program, mechanism, equations.coordinates).putOut();
    putOutFurtherRates(program, mechanism, equations.coordinates);
    equations.accelerations(needed -> equations.appliedForces(needed, true), true);
    return program;
  }

  /** Outputs the derivatives of the further states behind those of positions and velocities. */
  static void putOutFurtherRates(Program program, Links mechanism, Coordinates coordinates) {
    if (!mechanism.mechanism().furtherStates().isEmpty()) {
      int at = mechanism.positionCount() + mechanism.velocityCount();
      List<Scalar> rates = new AppliedForces(program, mechanism, coordinates).furtherRates();
      for (int i = 0; i < rates.size(); i++) {
        program.output(at + i, rates.get(i));
      }
    }
  }

  /**
   * Derives the same with given joint forces and no others.
   *
   * @param forceInput index of the input that holds a joint's force, N·m or N; −1: there is none
   */
  static Program derive(Links mechanism, ToIntFunction<Link> forceInput) {
    Program program = new Program();
    ArticulatedBodyEquations equations = new ArticulatedBodyEquations(program, mechanism);
    new PositionRates(program, mechanism, equations.coordinates).putOut();
    equations.accelerations(
        needed ->
            i -> given(program.expressions(), forceInput.applyAsInt(mechanism.links().get(i))),
        true);
    return program;
  }

  private static ScalarVector given(Expressions expressions, int input) {
    Scalar zero = expressions.zero();
    return new ScalarVector(zero, zero, input < 0 ? zero : expressions.input(input));
  }

  Coordinates coordinates() {
    return coordinates;
  }

  /**
   * Subtracts the applied wrenches from the wrenches that the links need; returns the applied joint
   * forces.
   */
  JointForces appliedForces(Wrench[] needed) {
    return appliedForces(needed, false);
  }

  private JointForces appliedForces(Wrench[] needed, boolean checked) {
    Loads loads = new AppliedForces(program, mechanism, coordinates).loads(checked);
    for (int i = 0; i < needed.length; i++) {
      needed[i] = needed[i].minus(loads.on(i));
    }
    return loads;
  }

  /**
   * Derives the accelerations.
   *
   * @param forces subtracts the applied wrenches from the wrenches that the links need, and returns
   *     the applied joint forces
   * @param putOut whether accelerations are outputs and singular joints end the program
   * @return the solved equations
   */
  Solved accelerations(Function<Wrench[], JointForces> forces, boolean putOut) {
    Wrench[] needed = new ForceSweep(program, mechanism, coordinates).sweep();
    JointForces inJoints = forces.apply(needed);
    InertiaSweep inertias =
        new InertiaSweep(
            program, mechanism, coordinates, needed, inJoints, CarriedEquations.NONE, putOut);
    AccelerationSweep accelerations =
        new AccelerationSweep(program, mechanism, coordinates, inertias, putOut);
    if (inertias.sweep()) {
      accelerations.sweep();
    }
    return new Solved(mechanism, coordinates, inertias, accelerations, inJoints);
  }

  /**
   * Solved equations.
   *
   * @param mechanism the mechanism in computing frames
   * @param coordinates its coordinates
   * @param inertias second sweep
   * @param accelerations third sweep
   * @param inJoints applied joint forces
   */
  record Solved(
      Links mechanism,
      Coordinates coordinates,
      InertiaSweep inertias,
      AccelerationSweep accelerations,
      JointForces inJoints) {

    /**
     * Returns the forces that the motion of a driven link takes beyond those applied, N·m or N:
     * one, or the torque of a ball in the axes of the file's body 1.
     */
    List<Scalar> drivingForces(int i) {
      Link link = mechanism.links().get(i);
      List<Scalar> forces =
          coordinates.step(link).freedoms().stream()
              .map(freedom -> drivingForce(i, freedom))
              .toList();
      return link.isBall()
          ? coordinates
              .ballToState(link, new ScalarVector(forces.get(0), forces.get(1), forces.get(2)))
              .components()
          : forces;
    }

    private Scalar drivingForce(int i, DegreeOfFreedom freedom) {
      Wrench column = inertias.inertia(i).along(freedom);
      Scalar taken =
          column
              .moment()
              .dot(accelerations.alpha(i))
              .plus(column.force().dot(accelerations.acceleration(i)));
      Scalar force =
          taken.plus(freedom.along(inertias.wrench(i))).minus(inJoints.of(i).at(freedom.axis()));
      return force.plus(coordinates.step(mechanism.links().get(i)).armatureForce(freedom));
    }
  }
}
