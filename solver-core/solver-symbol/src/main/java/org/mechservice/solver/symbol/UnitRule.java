package org.mechservice.solver.symbol;

/** What the unit of a function's value has to do with the units of its arguments. */
public enum UnitRule {
  /** A number, of an argument of any unit. */
  NUMBER,
  /** An angle, rad, of a number. */
  ANGLE,
  /** An angle, rad, of two arguments of one unit. */
  ANGLE_OF_TWO,
  /** The unit of the argument. */
  SAME,
  /** The unit that all arguments have. */
  COMMON,
  /** The root of the argument's unit. */
  ROOT,
  /** A power of the first argument's unit. */
  POWER,
  /** The unit that the user takes it for: whole turns, metres or periods. */
  COUNT
}
