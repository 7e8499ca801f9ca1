package org.mechservice.solver.kinematics;

/** The coordinates of driven joints as functions of time. */
final class PrescribedCoordinates {
  PrescribedCoordinates(TreeGeometry tree) {}

  /** Writes the driven part of extended positions, velocities and accelerations. */
  void evaluate(double t, double[] q, double[] v, double[] a) {}
}
