package org.mechservice.sim.build.dynamics;

import java.util.function.ToIntFunction;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;

/**
 * y' = f(t, y) of an open chain, totally recursive (DTR, NUMERICS §2): a sweep out gives the forces
 * that the motion needs while no joint accelerates, a sweep in the articulated inertias and what is
 * left of those forces, a second sweep out the joint accelerations.
 */
public final class ArticulatedBodyEquations {
  private ArticulatedBodyEquations() {}

  /**
   * Derives the program from the state [q; v] to its derivative [q'; v'], with no forces in the
   * joints.
   *
   * @param mechanism the open chain
   * @return a program whose guards return the index, among the joints that have states, of the
   *     joint beyond which there is no inertia
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
    Coordinates coordinates = new Coordinates(program, mechanism);
    new PositionRates(program, mechanism, coordinates).putOut();
    Wrench[] needed = new ForceSweep(program, mechanism, coordinates).sweep();
    InertiaSweep inertias =
        new InertiaSweep(
            program,
            mechanism,
            coordinates,
            needed,
            link -> given(program.expressions(), forceInput.applyAsInt(link)));
    if (inertias.sweep()) {
      new AccelerationSweep(program, mechanism, coordinates, inertias).sweep();
    }
    return program;
  }

  private static ScalarVector given(Expressions expressions, int input) {
    Scalar zero = expressions.zero();
    return new ScalarVector(zero, zero, input < 0 ? zero : expressions.input(input));
  }
}
