package org.mechservice.sim.equations;

import java.util.List;
import org.mechservice.sim.equations.force.AppliedForces;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.JointOutputs;
import org.mechservice.sim.equations.kinematics.PositionRates;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.JointSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * F(t, y, y') = [q' − N(q) v; M(q) v' + b(q, v) − τ] of an open chain, recursive residual (RR,
 * docs/theory/formulations.md#rr-the-residual). An outward sweep computes the motion and its
 * inertia forces; an inward sweep computes the joint forces.
 */
public final class RecursiveResidualEquations {
  private final Program program = new Program();
  private final Expressions expressions = program.expressions();
  private final Links mechanism;
  private final Coordinates coordinates;
  private final int stateCount;

  private RecursiveResidualEquations(Links mechanism) {
    this.mechanism = mechanism;
    this.stateCount = mechanism.mechanism().stateCount();
    this.coordinates = new Coordinates(program, mechanism, stateCount).inSharedForms(mechanism);
  }

  /**
   * Derives the program from the state [q; v], followed by its derivative [q'; v'], to the
   * residual, in the units of q' and of joint forces.
   */
  public static Program derive(Links mechanism) {
    return new RecursiveResidualEquations(mechanism).derive();
  }

  private Program derive() {
    new PositionRates(program, mechanism, coordinates)
        .each((at, rate) -> program.output(at, expressions.input(stateCount + at).minus(rate)));
    Wrench[] needed = new ForceSweep(program, mechanism, coordinates).sweep();
    AppliedForces forces = new AppliedForces(program, mechanism, coordinates);
    int further = mechanism.positionCount() + mechanism.velocityCount();
    List<Scalar> rates = forces.furtherRates();
    for (int i = 0; i < rates.size(); i++) {
      Scalar given = expressions.input(stateCount + further + i);
      program.output(further + i, given.minus(rates.get(i)));
    }
    Loads loads = forces.loads(true);
    for (int i = 0; i < needed.length; i++) {
      needed[i] = needed[i].minus(loads.on(i));
    }
    ScalarVector[] borne = new JointSweep(program, mechanism, coordinates).sweep(needed, loads);
    program.section("F = tau needed - tau applied.", "residual");
    new JointOutputs(mechanism, coordinates).putOut(borne, program);
    return program;
  }
}
