package org.mechservice.sim.build.dynamics;

import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/** Sines and cosines of the turning joints of one program. */
final class JointAngles {
  private final Program program;

  JointAngles(Program program) {
    this.program = program;
  }

  /** Returns the joint's coordinate, rad or m. */
  Scalar position(Link link) {
    return program.named("q_" + link.jointLabel(), program.expressions().input(link.position()));
  }

  /** Returns the joint's velocity, rad/s or m/s. */
  Scalar velocity(Link link) {
    return program.named("v_" + link.jointLabel(), program.expressions().input(link.velocity()));
  }

  /** Returns the sine of a turning joint's angle. */
  Scalar sine(Link link) {
    return program.named("sin_" + link.jointLabel(), program.expressions().sine(position(link)));
  }

  /** Returns the cosine of a turning joint's angle. */
  Scalar cosine(Link link) {
    return program.named("cos_" + link.jointLabel(), program.expressions().cosine(position(link)));
  }
}
