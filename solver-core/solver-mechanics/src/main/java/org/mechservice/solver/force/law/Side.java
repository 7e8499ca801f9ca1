package org.mechservice.solver.force.law;

/** The side of its rest position on which a spring acts. */
public enum Side {
  /** Both sides. */
  BOTH,
  /** Only above the rest value of length or coordinate: a rope, an upper stop. */
  ABOVE,
  /** Only below the rest value: a buffer, a lower stop. */
  BELOW
}
