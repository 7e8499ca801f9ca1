package org.mechservice.report.reference;

/**
 * The phases of a solution, separated by known jumps of the equations and by zeros of event
 * functions, at which the state jumps or the solution ends.
 */
public interface Phases {
  /** Phases of a problem with a smooth solution. */
  Phases NONE =
      new Phases() {
        @Override
        public int count() {
          return 0;
        }

        @Override
        public boolean values(double t, double[] y, double[] g) {
          return true;
        }

        @Override
        public boolean counts(int function, boolean rising) {
          return false;
        }

        @Override
        public double longestStep() {
          return Double.POSITIVE_INFINITY;
        }

        @Override
        public double nextBreak(double t) {
          return Double.POSITIVE_INFINITY;
        }

        @Override
        public boolean change(boolean[] passed, double t, double[] y) {
          return true;
        }

        @Override
        public void continueFrom(double t) {}
      };

  /** Returns the number of functions. */
  int count();

  /**
   * Evaluates the functions.
   *
   * @param y state as a code has it; not modified
   * @param g length {@link #count()}; overwritten
   * @return false if one has no value there
   */
  boolean values(double t, double[] y, double[] g);

  /** Returns whether a function's passage through zero, upwards or downwards, ends a phase. */
  boolean counts(int function, boolean rising);

  /** Returns the largest distance of points at which the functions are checked for zeros. */
  double longestStep();

  /** Returns the first known time after {@code t} at which the equations jump, or infinity. */
  double nextBreak(double t);

  /**
   * Ends a phase.
   *
   * @param passed which functions have passed zero; not modified
   * @param y state before at entry, after at return
   * @return false if the solution ends here
   */
  boolean change(boolean[] passed, double t, double[] y);

  /** Notes that a new phase begins at {@code t}. */
  void continueFrom(double t);
}
