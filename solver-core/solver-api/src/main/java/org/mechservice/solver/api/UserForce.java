package org.mechservice.solver.api;

/**
 * A force written by a user; {@code <force name="…" fileName="….class">} in the model file names
 * its class.
 *
 * <p>The class needs a public constructor without arguments. {@link #declare} is called once,
 * before the run: it declares points, coordinates and parameters by name and stores the numbers
 * returned. {@link #apply} is called at every evaluation, with states that the run may never reach.
 * It must be a pure function of the declared quantities: no clock, no files, no memory of earlier
 * calls. One instance belongs to one thread, so it may keep scratch arrays.
 *
 * <p>A force with analytic derivatives implements {@link Derivatives} as well; for others, implicit
 * integrators use differences over the declared quantities. A result that is not finite ends the
 * run with a message that names the force.
 *
 * <pre>{@code
 * public final class Strut implements UserForce {
 *   private int top;
 *   private int bottom;
 *   private final double[] a = new double[3];
 *   private final double[] b = new double[3];
 *
 *   public void declare(ForceDeclaration model) {
 *     top = model.point("Frame", "top", ForceDeclaration.Reads.POSITION);
 *     bottom = model.point("Carrier", "bottom", ForceDeclaration.Reads.POSITION);
 *   }
 *
 *   public void apply(ForceState state, ForceLoads loads) {
 *     state.position(top, a);
 *     state.position(bottom, b);
 *     double push = 3e4 * (0.5 - (a[2] - b[2]));
 *     loads.addForce(top, 0, 0, push);
 *     loads.addForce(bottom, 0, 0, -push);
 *   }
 * }
 * }</pre>
 */
public interface UserForce {
  /**
   * Declares everything that the force reads and acts on.
   *
   * @param model resolves names
   */
  void declare(ForceDeclaration model);

  /**
   * Evaluates the force.
   *
   * @param state declared quantities; world axes, SI units
   * @param loads receives forces, torques and values
   */
  void apply(ForceState state, ForceLoads loads);

  /** A force with analytic derivatives. */
  interface Derivatives extends UserForce {
    /**
     * Adds the derivatives of all loads of {@link #apply} by all quantities read; derivatives not
     * added count as zero.
     *
     * @param state the state, as for {@link #apply}
     * @param blocks receives the derivatives
     */
    void differentiate(ForceState state, ForceBlocks blocks);
  }
}
