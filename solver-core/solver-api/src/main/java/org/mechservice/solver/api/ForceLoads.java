package org.mechservice.solver.api;

/** Receives the loads of a {@link UserForce}. Components are in world axes; SI units. */
public interface ForceLoads {
  /** Adds a force on a point's body at the point, N. */
  void addForce(int point, double x, double y, double z);

  /** Adds a torque on a point's body, N·m. */
  void addTorque(int point, double x, double y, double z);

  /** Adds a force in a joint, N·m or N; a positive force increases the coordinate. */
  void addJointForce(int coordinate, double force);

  /** Sets a declared value. */
  void setValue(int value, double x);
}
