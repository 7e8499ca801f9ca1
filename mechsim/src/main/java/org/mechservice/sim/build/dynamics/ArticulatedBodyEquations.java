package org.mechservice.sim.build.dynamics;

import java.util.function.ToIntFunction;
import org.mechservice.sim.symbolic.Program;

/**
 * y' = f(t, y) of an open chain of turning and sliding joints, totally recursive (DTR, NUMERICS
 * §2): a sweep out gives the forces that the motion needs while no joint accelerates, a sweep in
 * the articulated inertias and what is left of those forces, a second sweep out the joint
 * accelerations.
 */
public final class ArticulatedBodyEquations {
  private ArticulatedBodyEquations() {}

  /**
   * Derives the program from the state [q; v] to its derivative [q'; v'], with no forces in the
   * joints.
   *
   * @param mechanism the open chain
   * @return a program whose guards return the index, in the mechanism, of the joint beyond which
   *     there is no inertia
   */
  public static Program derive(Links mechanism) {
    return derive(mechanism, link -> -1);
  }

  /**
   * Derives the same with joint forces.
   *
   * @param forceInput index of the input that holds a joint's force, N·m or N; −1: there is none
   */
  static Program derive(Links mechanism, ToIntFunction<Link> forceInput) {
    Program program = new Program();
    JointAngles angles = new JointAngles(program);
    program.section("q' = v", "q");
    for (Link link : mechanism.links()) {
      program.output(link.position(), angles.velocity(link));
    }
    Wrench[] needed = new ForceSweep(program, mechanism, angles).sweep();
    InertiaSweep inertias =
        new InertiaSweep(
            program,
            mechanism,
            angles,
            needed,
            link -> {
              int input = forceInput.applyAsInt(link);
              return input < 0 ? program.expressions().zero() : program.expressions().input(input);
            });
    if (inertias.sweep()) {
      new AccelerationSweep(program, mechanism, angles, inertias).sweep();
    }
    return program;
  }
}
