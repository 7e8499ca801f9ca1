package org.mechservice.sim.equations.loop;

import java.util.List;
import java.util.Optional;
import org.mechservice.sim.equations.force.AppliedForces;
import org.mechservice.sim.equations.force.MassiveRodTerms;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.JointOutputs;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.kinematics.PositionRates;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.JointSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.StateMass;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The terms of the equations of a mechanism with loops as programs, in the layout of {@link
 * LoopTerms}; unwrapped angles follow [q; v]. Elements that are zero in every state are not output.
 */
public final class LoopCode {
  private final Program program = new Program();
  private final Expressions expressions = program.expressions();
  private final Links mechanism;
  private final Coordinates coordinates;
  private final LinkKinematics kinematics;
  private final VelocityRows rows;
  private final int m;
  private final int n;

  /**
   * @param equations number of equations of the loops
   * @param derivative first input of the accelerations; −1 for zero accelerations
   */
  private LoopCode(Links mechanism, int equations, int derivative) {
    this.mechanism = MassiveRodTerms.withEnds(mechanism);
    this.coordinates = new Coordinates(program, this.mechanism, derivative);
    this.kinematics = new LinkKinematics(program, this.mechanism, coordinates);
    this.rows = new VelocityRows(expressions, this.mechanism, coordinates);
    this.m = equations;
    this.n = mechanism.velocityCount();
  }

  private static LoopCode atRest(Links mechanism, int equations) {
    return new LoopCode(mechanism, equations, -1);
  }

  /** Derives the program from [q; v] to Φ, Φ' and J. */
  public static Program loops(Links mechanism, int equations) {
    LoopCode code = atRest(mechanism, equations);
    code.putOutLoops(Optional.empty());
    return code.program;
  }

  /** Derives the program from [q; v] to all terms; guards return results of forces. */
  public static Program equations(Links mechanism, int equations) {
    LoopCode code = atRest(mechanism, equations);
    ForceSweep sweep = code.putOutBias(LoopTerms.biasAt(equations, code.n));
    code.putOutLoops(Optional.of(sweep));
    code.putOutMass();
    return code.program;
  }

  /** Derives the program from [q; v] to M, which no force enters, at its place among all terms. */
  public static Program mass(Links mechanism, int equations) {
    LoopCode code = atRest(mechanism, equations);
    code.putOutMass();
    return code.program;
  }

  /** Derives the program from [q; v] to γ. */
  public static Program offset(Links mechanism, int equations) {
    LoopCode code = atRest(mechanism, equations);
    ForceSweep sweep = new ForceSweep(code.program, code.mechanism, code.coordinates);
    sweep.sweep();
    code.rows(Optional.of(sweep)).each((row, equation) -> code.putOutOffset(row, equation));
    return code.program;
  }

  /**
   * Derives the program from [q; v], followed by v', to M v' + b − τ; guards as {@link #equations}.
   */
  public static Program residual(Links mechanism) {
    // accelerations count like velocities, which come after the positions
    int derivative =
        mechanism.velocityCount()
            + mechanism.mechanism().furtherStates().size()
            + UnwrappedAngles.of(mechanism.mechanism()).size();
    LoopCode code = new LoopCode(mechanism, 0, derivative);
    code.putOutBias(0);
    return code.program;
  }

  /** Derives the program from [q; v; s] to the derivatives of the further states. */
  public static Program further(Links mechanism) {
    LoopCode code = atRest(mechanism, 0);
    List<Scalar> rates =
        new AppliedForces(code.program, code.mechanism, code.coordinates).furtherRates();
    for (int i = 0; i < rates.size(); i++) {
      code.program.output(i, rates.get(i));
    }
    return code.program;
  }

  /** Derives the program from [q; v; s] to [q'; 0; s']: the rates that need no accelerations. */
  public static Program rates(Links mechanism) {
    LoopCode code = atRest(mechanism, 0);
    new PositionRates(code.program, mechanism, code.coordinates).putOut();
    List<Scalar> rates =
        new AppliedForces(code.program, code.mechanism, code.coordinates).furtherRates();
    for (int i = 0; i < rates.size(); i++) {
      code.program.output(mechanism.mechanism().furtherOffset() + i, rates.get(i));
    }
    return code.program;
  }

  private LoopRows rows(Optional<ForceSweep> sweep) {
    return new LoopRows(program, mechanism, coordinates, kinematics, rows, sweep);
  }

  private void put(int index, Scalar value) {
    if (!value.isZero()) {
      program.output(index, value);
    }
  }

  private void putOutLoops(Optional<ForceSweep> sweep) {
    rows(sweep)
        .each(
            (row, equation) -> {
              put(row, equation.value());
              put(m + row, equation.rate());
              for (int j = 0; j < n; j++) {
                put(LoopTerms.jacobianAt(m) + row * n + j, equation.jacobian()[j]);
              }
              equation.size().ifPresent(size -> put(LoopTerms.sizeAt(m, n) + row, size));
              if (sweep.isPresent()) {
                putOutOffset(row, equation);
              }
            });
  }

  private void putOutOffset(int row, LoopRow equation) {
    put(LoopTerms.offsetAt(m, n) + row, equation.offset());
  }

  /** Outputs the joint forces of the bias; returns the sweep of the links' motion. */
  private ForceSweep putOutBias(int at) {
    ForceSweep sweep = new ForceSweep(program, mechanism, coordinates);
    Wrench[] needed = sweep.sweep();
    program.section("Rods.", "rods");
    new MassiveRodTerms(expressions, mechanism, kinematics, rows).addNeeded(sweep, needed);
    Loads loads = new AppliedForces(program, mechanism, coordinates).loads(true);
    for (int i = 0; i < needed.length; i++) {
      needed[i] = needed[i].minus(loads.on(i));
    }
    ScalarVector[] borne = new JointSweep(program, mechanism, coordinates).sweep(needed, loads);
    program.section("b - tau in the order of the state.", "bias");
    new JointOutputs(mechanism, coordinates).putOut(borne, program, at - mechanism.positionCount());
    return sweep;
  }

  private void putOutMass() {
    Scalar[][] mass = new Scalar[n][];
    for (int i = 0; i < n; i++) {
      mass[i] = rows.zeros();
    }
    new StateMass(program, mechanism, coordinates, rows)
        .each(
            (row, column, element) -> mass[Math.max(row, column)][Math.min(row, column)] = element);
    program.section("Mass matrix, lower triangle.", "mass");
    new MassiveRodTerms(expressions, mechanism, kinematics, rows).addMass(mass);
    for (int i = 0; i < n; i++) {
      for (int j = 0; j <= i; j++) {
        put(LoopTerms.massAt(m, n) + i * n + j, mass[i][j]);
      }
    }
  }
}
