package org.mechservice.solver.force.law;

import org.mechservice.solver.symbol.Expressions;
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

  /**
   * Returns a motion whose components are inputs from 0 on: displacement, rotation row by row,
   * angular velocity, rate.
   */
  static Frames ofInputs(Expressions e) {
    return new Frames() {
      private ScalarVector vector(int first) {
        return new ScalarVector(e.input(first), e.input(first + 1), e.input(first + 2));
      }

      @Override
      public ScalarVector displacement() {
        return vector(0);
      }

      @Override
      public ScalarMatrix rotation() {
        return ScalarMatrix.of((i, j) -> e.input(3 + 3 * i + j));
      }

      @Override
      public ScalarVector omega() {
        return vector(12);
      }

      @Override
      public ScalarVector rate() {
        return vector(15);
      }
    };
  }
}
