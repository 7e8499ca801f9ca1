package org.mechservice.sim.equations.coordinates;

import java.util.Optional;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A coordinate of a cut joint, computed from the poses of its two bodies.
 *
 * @param frames the frames on the two bodies
 * @param term the coordinate with its derivatives
 * @param position its value, rad or m, an angle unwrapped; undefined and never used for an angular
 *     velocity in a joint with Euler parameters
 */
public record CutCoordinate(RelativeFrameMotion frames, PairTerm term, Scalar position) {
  /** Returns its rate, rad/s or m/s. */
  public Scalar velocity() {
    return term.rate(frames.omega(), frames.rate());
  }

  /** Returns its second derivative for the accelerations of the sweep, if there is one. */
  public Scalar acceleration(Optional<ForceSweep> sweep, ScalarVector none) {
    return term.acceleration(
        sweep.map(frames::alpha).orElse(none), sweep.map(frames::acceleration).orElse(none));
  }

  /** Adds a force along it to the loads of the bodies, N·m or N. */
  public void addForce(Scalar force, Loads loads) {
    frames.addWrench(term.byShift().times(force), term.byTurn().times(force), loads);
  }

  /** Adds a multiple of its derivatives by the velocities of the state to a row. */
  public void addRow(Scalar factor, VelocityRows rows, Scalar[] row) {
    frames.addRow(term.byShift().times(factor), term.byTurn().times(factor), rows, row);
  }
}
