package org.mechservice.sim.equations;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.sim.equations.force.AppliedForces;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/** Power of the forces without potential energy, and the values of all forces. */
public final class PowerEquations {
  private PowerEquations() {}

  /**
   * Derives the program from the state [q; v] to the power of dampers, friction, forces given by
   * formulas, and prescribed motions, and to the sum of their sizes (outputs 0 and 1), W.
   *
   * @return empty if this power is zero in every state
   */
  public static Optional<Program> power(Links mechanism) {
    Program program = new Program();
    ArticulatedBodyEquations tree = new ArticulatedBodyEquations(program, mechanism);
    AppliedForces forces = new AppliedForces(program, mechanism, tree.coordinates());
    Scalar power = program.expressions().zero();
    Scalar turnover = power;
    for (Scalar one : forces.powers()) {
      power = power.plus(one);
      turnover = turnover.plus(size(one));
    }
    Scalar driving = program.expressions().zero();
    for (Scalar force : drivingForces(mechanism, tree)) {
      power = power.plus(force);
      driving = driving.plus(force);
    }
    program.section("Power.", "power");
    program.output(0, power);
    program.output(1, turnover.plus(size(driving)));
    return power.isZero() ? Optional.empty() : Optional.of(program);
  }

  /**
   * Derives the same for a mechanism with loops, from the applied forces alone. The program has no
   * outputs if their power is zero in every state.
   */
  public static Program ofForces(Links mechanism) {
    Program program = new Program();
    Coordinates coordinates = new Coordinates(program, mechanism);
    Scalar power = program.expressions().zero();
    Scalar turnover = power;
    for (Scalar one : new AppliedForces(program, mechanism, coordinates).powers()) {
      power = power.plus(one);
      turnover = turnover.plus(size(one));
    }
    if (!power.isZero()) {
      program.section("Power.", "power");
      program.output(0, power);
      program.output(1, turnover);
    }
    return program;
  }

  private static Scalar size(Scalar power) {
    return power.isZero() ? power : power.expressions().function(MathFunction.ABS, power);
  }

  /** Returns the power of each driven velocity. */
  private static List<Scalar> drivingForces(Links mechanism, ArticulatedBodyEquations tree) {
    List<Scalar> powers = new ArrayList<>();
    if (mechanism.mechanism().motions().isEmpty()) {
      return powers;
    }
    ArticulatedBodyEquations.Solved solved = tree.accelerations(tree::appliedForces, false);
    for (int i = 0; i < mechanism.links().size(); i++) {
      Link link = mechanism.links().get(i);
      if (link.isDriven()) {
        List<Scalar> forces = solved.drivingForces(i);
        List<Scalar> velocities =
            link.isBall()
                ? tree.coordinates().ballVelocity(link).components()
                : List.of(tree.coordinates().velocity(link));
        for (int k = 0; k < forces.size(); k++) {
          powers.add(forces.get(k).times(velocities.get(k)));
        }
      }
    }
    return powers;
  }

  /**
   * Derives the program from the state [q; v] to the values of all forces in file order, then the
   * forces that driven joints take, in file order, N·m or N.
   */
  public static Program values(Links mechanism) {
    Program program = new Program();
    ArticulatedBodyEquations tree = new ArticulatedBodyEquations(program, mechanism);
    List<Scalar> values =
        new ArrayList<>(new AppliedForces(program, mechanism, tree.coordinates()).values());
    if (!mechanism.mechanism().motions().isEmpty()) {
      ArticulatedBodyEquations.Solved solved = tree.accelerations(tree::appliedForces, false);
      for (int link : drivenInFileOrder(mechanism)) {
        values.addAll(solved.drivingForces(link));
      }
    }
    program.section("Values of forces.", "values");
    for (int i = 0; i < values.size(); i++) {
      program.output(i, values.get(i));
    }
    return program;
  }

  /** Derives the program from the state [q; v] to the values of expressions, in their order. */
  public static Program formulas(Links mechanism, List<Expression> expressions) {
    Program program = new Program();
    Coordinates coordinates = new Coordinates(program, mechanism);
    List<Scalar> values = new AppliedForces(program, mechanism, coordinates).scalars(expressions);
    for (int i = 0; i < values.size(); i++) {
      program.output(i, values.get(i));
    }
    return program;
  }

  private static List<Integer> drivenInFileOrder(Links mechanism) {
    List<Integer> driven = new ArrayList<>();
    for (int i = 0; i < mechanism.links().size(); i++) {
      if (mechanism.links().get(i).isDriven()) {
        driven.add(i);
      }
    }
    driven.sort(
        (a, b) -> {
          Link first = mechanism.links().get(a);
          Link second = mechanism.links().get(b);
          int byJoint = Integer.compare(first.joint(), second.joint());
          return byJoint != 0 ? byJoint : Integer.compare(first.component(), second.component());
        });
    return driven;
  }
}
