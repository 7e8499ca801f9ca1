package org.mechservice.solver.ode;

/**
 * A system some of whose components follow from the others, as the coordinates of a closed loop do
 * (docs/theory/loops.md#projection). Implemented beside {@link OdeSystem} or {@link
 * ResidualSystem}.
 *
 * <p>The integrator keeps a history of all components. The iteration sees the independent ones
 * alone, and so do the error test and its norm unless {@link #tested} names others; the passive
 * ones are predicted like the others and then overwritten by {@link #complete}, so that others may
 * become independent from one step to the next without a restart. A residual system writes the
 * equations of independent components into their own places of the residual; the places of passive
 * ones are not read.
 */
public interface CompletedSystem {
  /** A system whose components are all independent. */
  CompletedSystem NOTHING_PASSIVE =
      new CompletedSystem() {
        @Override
        public boolean independent(int component) {
          return true;
        }

        @Override
        public boolean complete(double t, double[] y) {
          return true;
        }

        @Override
        public boolean accepted(double t, double[] y) {
          return false;
        }
      };

  /** Returns whether a component is independent at present; changes only in {@link #accepted}. */
  boolean independent(int component);

  /**
   * Returns whether a component is tested for error. A passive component is not, unless something
   * beside the independent ones moves it, such as a drive as a function of time: steps would then
   * pass over its motion.
   */
  default boolean tested(int component) {
    return independent(component);
  }

  /**
   * Enlarges the sizes of passive components, to which their allowed errors are relative. A passive
   * component carries the rounding errors of the others from which it is computed; one that passes
   * through zero cannot be more accurate than these, however short a step is.
   *
   * @param sizes absolute value of each component, a group's norm, or the largest size that counts;
   *     those of passive components may be enlarged
   */
  default void enlarge(double[] sizes) {}

  /**
   * Overwrites the passive components so that they fit the independent ones.
   *
   * @param t where
   * @param y independent components, and starting values for the passive ones; the latter are
   *     overwritten
   * @return false if nothing fits; the step is then tried shorter
   */
  boolean complete(double t, double[] y);

  /**
   * Takes note of an accepted step and may choose other components as independent.
   *
   * @param t its end
   * @param y completed state there; not modified
   * @return whether the choice has changed
   */
  boolean accepted(double t, double[] y);
}
