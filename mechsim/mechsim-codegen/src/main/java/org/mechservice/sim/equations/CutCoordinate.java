package org.mechservice.sim.equations;

import java.util.Optional;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;

/**
 * A coordinate of a cut joint, which follows from the pose of the two bodies it joins.
 *
 * @param frames the frames of the bodies between which it is measured
 * @param term the coordinate with its derivatives
 * @param position its value, an angle with its whole turns, rad or m; of an angular velocity in a
 *     joint with Euler parameters there is none, and nobody asks for it
 */
record CutCoordinate(FrameMotion frames, PairTerm term, Scalar position) {
  /** Returns its rate, rad/s or m/s. */
  Scalar velocity() {
    return term.rate(frames.omega(), frames.rate());
  }

  /** Returns its second derivative, while the joints accelerate as swept, if they do. */
  Scalar acceleration(Optional<ForceSweep> sweep, ScalarVector none) {
    return term.acceleration(
        sweep.map(frames::alpha).orElse(none), sweep.map(frames::acceleration).orElse(none));
  }

  /** Adds a force along it to the loads of the bodies, N·m or N. */
  void addForce(Scalar force, Loads loads) {
    frames.addWrench(term.byShift().times(force), term.byTurn().times(force), loads);
  }

  /** Adds a multiple of its derivatives by the velocities of the state to a row. */
  void addRow(Scalar factor, VelocityRows rows, Scalar[] row) {
    frames.addRow(term.byShift().times(factor), term.byTurn().times(factor), rows, row);
  }
}
