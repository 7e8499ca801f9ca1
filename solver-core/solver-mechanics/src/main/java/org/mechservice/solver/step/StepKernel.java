package org.mechservice.solver.step;

/**
 * The methods of one kind of step, printed from its equations. Each reads and writes the blocks of
 * a link and of its parent in one array, laid out by {@link StepBlock}.
 *
 * <p>Parameters of all methods: {@code w} the array, {@code i} where the link's block begins,
 * {@code p} where its parent's begins.
 */
public interface StepKernel {
  /** Writes motion and inertia wrench, less the applied one: first sweep, outwards. */
  void motion(double[] w, int i, int p);

  /**
   * Eliminates the joint and adds articulated inertia and bias wrench to the parent: second sweep,
   * inwards.
   */
  void inertia(double[] w, int i, int p);

  /** Eliminates the joint of a link on the root. */
  void inertiaOnRoot(double[] w, int i, int p);

  /** Adds articulated inertia and bias wrench to the parent with the joint as it is. */
  void pass(double[] w, int i, int p);

  /** Writes joint accelerations and what they add to the link: third sweep, outwards. */
  void acceleration(double[] w, int i, int p);

  /** Writes what the accelerations of joints nearer the root add to the link. */
  void carry(double[] w, int i, int p);

  /**
   * Writes the forces that a driven joint's motion takes, after the third sweep; in link axes for a
   * ball.
   */
  void driving(double[] w, int i, int p);

  /** Writes the joint forces that the motion takes and adds the wrench to the parent's. */
  void force(double[] w, int i, int p);

  /** Writes the joint forces that the motion of a link on the root takes. */
  void forceOnRoot(double[] w, int i, int p);

  /**
   * Writes what a joint force and the wrench of the links beyond do to an eliminated joint, and
   * adds the rest of the wrench to the parent's: the second sweep once more for other forces.
   */
  void push(double[] w, int i, int p);

  /** Writes what they do to an eliminated joint of a link on the root. */
  void pushOnRoot(double[] w, int i, int p);

  /**
   * Carries the wrench of a multiplier over an eliminated joint.
   *
   * @param p where the wrench is, laid out by {@link CarriedWrench}
   */
  void couple(double[] w, int i, int p);

  /** Writes what the wrench of a multiplier does to an eliminated joint of a link on the root. */
  void coupleOnRoot(double[] w, int i, int p);

  /** Carries the wrench of a multiplier over a joint as it is. */
  void transfer(double[] w, int i, int p);
}
