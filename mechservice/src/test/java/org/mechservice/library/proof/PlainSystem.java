package org.mechservice.library.proof;

/** Equations of a scene, written down a second time, with the places where they are not smooth. */
interface PlainSystem {
  /** Number of states. */
  int states();

  /**
   * Writes y' on one branch, which goes on smoothly beyond the zeros of the margins.
   *
   * @param above for each margin, whether the branch is that of a positive one
   */
  void rates(double t, double[] y, boolean[] above, double[] rates);

  /** Number of functions at whose zeros y' is not smooth. */
  int margins();

  /** Value of one of them. */
  double margin(int i, double t, double[] y);

  /** Returns a time, s, within which no margin can become zero, and 0 if it can at once. */
  double clear(double t, double[] y);

  /** Returns a step, s, that is short beside everything that happens. */
  double fine();
}
