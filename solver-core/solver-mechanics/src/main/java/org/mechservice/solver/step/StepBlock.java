package org.mechservice.solver.step;

import org.mechservice.solver.links.AxesChange;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The layout of the numbers of one step in the array that a tree's steps share, from the step's
 * place on; the link's own, {@link LinkNumbers#COUNT}, come first. All quantities are in the link's
 * computing frame, in SI units. Numbers that one sweep needs are beside each other; what only balls
 * have is at the end.
 */
public final class StepBlock {
  /** The coordinate, its cosine and its sine. */
  public static final int POSITION = LinkNumbers.COUNT;

  public static final int COSINE = POSITION + 1;
  public static final int SINE = COSINE + 1;

  /** Velocity, known acceleration and applied force of the coordinate. */
  public static final int VELOCITY = SINE + 1;

  public static final int KNOWN = VELOCITY + 1;
  public static final int TAU = KNOWN + 1;

  /** Angular velocity, angular acceleration, acceleration of the origin: 9. */
  public static final int MOTION = TAU + 1;

  /** Wrench that the motion takes, then the bias wrench: moment, force. */
  public static final int WRENCH = MOTION + 9;

  /** Applied wrench: moment, force. */
  public static final int LOAD = WRENCH + 6;

  /**
   * Articulated inertia of the links beyond: J as xx, yy, zz, xy, xz, yz (6), H row by row (9), M
   * as J (6); kg·m², kg·m, kg. Zero before each inward sweep, which leaves it so.
   */
  public static final int INERTIA = LOAD + 6;

  /** How many numbers an inertia has. */
  public static final int INERTIA_COUNT = 21;

  /** D, u / D and U / D (6) of the degree of freedom. */
  public static final int FREEDOM = INERTIA + INERTIA_COUNT;

  /** Angular acceleration and acceleration of the origin that joint accelerations add: 6. */
  public static final int ADDED = FREEDOM + 8;

  /** Acceleration, or joint force that the motion takes. */
  public static final int RESULT = ADDED + 6;

  /** Inertia of its own of each velocity. */
  public static final int ARMATURE = RESULT + 1;

  /** Length of a block without what only balls have. */
  public static final int SIZE = ARMATURE + 1;

  /** Velocities of a ball in the axes of the file's body 1, 3. */
  public static final int BALL_VELOCITY = SIZE;

  /** Known accelerations in the same axes, 3. */
  public static final int BALL_KNOWN = BALL_VELOCITY + 3;

  /** Applied moments in link axes, 3. */
  public static final int BALL_TAU = BALL_KNOWN + 3;

  /** Rotation of a ball from link to parent axes, row by row, 9. */
  public static final int ROTATION = BALL_TAU + 3;

  /** D, u / D and U / D of the second and the third degree of freedom. */
  public static final int BALL_FREEDOMS = ROTATION + 9;

  /** Accelerations, or moments that the motion takes, in the order of the state: 3. */
  public static final int BALL_RESULT = BALL_FREEDOMS + 16;

  /** Length of a ball's block. */
  public static final int BALL_SIZE = BALL_RESULT + 6;

  private StepBlock() {}

  /** Returns where D, u / D and U / D of a degree of freedom are. */
  public static int freedom(int k) {
    return k == 0 ? FREEDOM : BALL_FREEDOMS + 8 * (k - 1);
  }

  /** Writes the {@link LinkNumbers#COUNT} numbers of a link without those of its constant turn. */
  public static void put(double[] w, int at, Link link) {
    Rotation axes = link.axes().matrix();
    put(w, at + LinkNumbers.AXES, axes.xx(), axes.xy(), axes.xz());
    put(w, at + LinkNumbers.AXES + 3, axes.yx(), axes.yy(), axes.yz());
    put(w, at + LinkNumbers.AXES + 6, axes.zx(), axes.zy(), axes.zz());
    put(w, at + LinkNumbers.OFFSET, link.offset());
    w[at + LinkNumbers.WAY] = link.way();
    w[at + LinkNumbers.MASS] = link.mass();
    put(w, at + LinkNumbers.CENTER, link.centerOfMass());
    put(w, at + LinkNumbers.FIRST, link.centerOfMass().times(link.mass()));
    put(w, at + LinkNumbers.SECOND, link.inertiaAtOrigin());
    put(w, at + LinkNumbers.MOMENTS, link.inertia());
  }

  /** Writes the numbers of a link's constant turn, a step between the link and its parent. */
  public static void putTurn(double[] w, int at, Link link) {
    AxesChange.Turn turn = link.axes().turn().orElseThrow();
    w[at + LinkNumbers.COSINE] = turn.cosine();
    w[at + LinkNumbers.SINE] = turn.sine();
    put(w, at + LinkNumbers.OFFSET, link.offset());
  }

  private static void put(double[] w, int at, InertiaTensor i) {
    put(w, at, i.xx(), i.yy(), i.zz());
    put(w, at + 3, i.xy(), i.xz(), i.yz());
  }

  private static void put(double[] w, int at, Vector3 v) {
    put(w, at, v.x(), v.y(), v.z());
  }

  private static void put(double[] w, int at, double x, double y, double z) {
    w[at] = x;
    w[at + 1] = y;
    w[at + 2] = z;
  }
}
