package org.mechservice.solver.api;

/**
 * A force written by a user, as {@code <force name="…" fileName="….class">} names it.
 *
 * <p>The class needs a public constructor without arguments. {@link #declare} is called once,
 * before the run: it asks for points, coordinates and parameters by name and keeps the numbers it
 * gets. {@link #apply} is called at every evaluation, with states the run may never reach; it is a
 * pure function of what it reads: no clock, no files, no memory of earlier calls. One instance
 * belongs to one thread, so it may keep scratch arrays.
 *
 * <p>A force that knows its derivatives implements {@link Derivatives} as well; for others,
 * implicit integrators take differences over what was declared. A result that is not finite ends
 * the run with a message that names the force.
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
   * Asks for everything the force reads and acts on.
   *
   * @param model answers by name
   */
  void declare(ForceDeclaration model);

  /**
   * Evaluates the force.
   *
   * @param state what may be read; world axes, SI units
   * @param loads takes forces, torques and values
   */
  void apply(ForceState state, ForceLoads loads);

  /** A force that gives its own derivatives. */
  interface Derivatives extends UserForce {
    /**
     * Gives the derivatives of everything {@link #apply} adds by everything it reads; what is not
     * given counts as zero.
     *
     * @param state the state, as for {@link #apply}
     * @param blocks takes the derivatives
     */
    void differentiate(ForceState state, ForceBlocks blocks);
  }
}
