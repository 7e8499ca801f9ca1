package org.mechservice.solver.api;

/** Takes what a {@link UserForce} does. Components are in world axes; SI units. */
public interface ForceLoads {
  /** Adds a force on a point's body at the point, N. */
  void addForce(int point, double x, double y, double z);

  /** Adds a torque on a point's body, N·m. */
  void addTorque(int point, double x, double y, double z);

  /** Adds a force in a joint, N·m or N; positive drives the coordinate upwards. */
  void addJointForce(int coordinate, double force);

  /** Sets a declared value. */
  void setValue(int value, double x);
}
