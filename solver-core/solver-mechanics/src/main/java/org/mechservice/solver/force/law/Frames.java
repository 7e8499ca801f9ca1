package org.mechservice.solver.force.law;

import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/** Pose and velocity of a frame on body 2 relative to a frame on body 1, in the axes of frame 1. */
public interface Frames {
  /** Returns the origin of frame 2 from that of frame 1, m. */
  ScalarVector displacement();

  /** Returns the rotation from the axes of frame 2 to those of frame 1. */
  ScalarMatrix rotation();

  /** Returns the angular velocity of frame 2 relative to body 1, rad/s. */
  ScalarVector omega();

  /** Returns the rate of the displacement relative to body 1, m/s. */
  ScalarVector rate();
}
