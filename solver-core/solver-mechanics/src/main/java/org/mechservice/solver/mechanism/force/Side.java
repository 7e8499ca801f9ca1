package org.mechservice.solver.mechanism.force;

/** On which side of its rest position a spring acts. */
public enum Side {
  /** On both. */
  BOTH,
  /** Only when its length or coordinate is above the rest value: a rope, an upper stop. */
  ABOVE,
  /** Only when it is below: a buffer, a lower stop. */
  BELOW
}
