package org.mechservice.sim.build.dynamics;

import java.util.List;
import org.mechservice.sim.symbolic.Scalar;

/** An applied force as equations. */
interface ForceTerm {
  /** Adds what it does to links and joints. */
  void apply(Loads loads);

  /** Returns its potential energy, J; zero if it has none. */
  Scalar potential();

  /** Returns the power of what has no potential energy, W, positive into the mechanism. */
  Scalar power();

  /** Returns the values it can put out, in the order in which the description names them. */
  List<Scalar> values();
}
