package org.mechservice.solver.force.applied;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.multiply;

import java.util.Arrays;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.spatial.Rotation;

/**
 * Pose and velocity of frame 2, on body 2, relative to frame 1, on body 1, in the axes of frame 1.
 * Every force between two bodies that depends only on their relative motion is a function of these
 * quantities.
 *
 * <p>Legend: A1, A2 rotations from the axes of links 1 and 2 to those of frame 1; r1, r2 the
 * frames' origins from the links' reference points in link axes; s the origin of frame 2 from the
 * reference point of link 1 in its axes.
 */
public final class FrameMotion {
  private final TreeMotion motion;
  private final int link1;
  private final int link2;
  private final int ancestor;

  /** A1, constant, and frame 2's axes to link 2's axes. */
  private final double[] a1 = new double[9];

  private final double[] axes2 = new double[9];
  private final double[] a2 = new double[9];
  private final double[] r1 = new double[3];
  private final double[] r2 = new double[3];
  private final double[] s = new double[3];

  /**
   * All components, in the order of {@link Expression.RelativeMotion}: the origin of frame 2 from
   * that of frame 1, m; the axes of frame 2 to axes of frame 1; angular velocity of frame 2, rad/s;
   * the rate of its origin, m/s.
   */
  final double[] x = new double[RelativeMotion.COUNT];

  /**
   * Angular velocity of link 1 in frame 1; of link 2; velocity of frame 2's origin; scratch in
   * world axes.
   */
  private final double[] omega1 = new double[3];

  private final double[] omega2 = new double[3];
  private final double[] velocity2 = new double[3];

  private final double[] work = new double[9];
  private final double[] moved = new double[3];

  /** Prepares the relative motion of two frames in a motion that the caller sweeps. */
  public FrameMotion(TreeMotion motion, BodyFrame frame1, BodyFrame frame2) {
    this.motion = motion;
    TreeGeometry tree = motion.tree();
    link1 = tree.linkOf(frame1.body());
    link2 = tree.linkOf(frame2.body());
    ancestor = tree.commonAncestor(link1, link2);
    put(a1, frame1.axes().transposed());
    put(axes2, frame2.axes());
    tree.fromReference(frame1.origin(), r1, 0);
    tree.fromReference(frame2.origin(), r2, 0);
  }

  public int link1() {
    return link1;
  }

  public int link2() {
    return link2;
  }

  /** Returns whether the links are one, next to each other, or one of them is the root. */
  boolean isOfNeighbours() {
    return motion.tree().areNeighbours(link1, link2);
  }

  private static void put(double[] m, Rotation r) {
    m[0] = r.xx();
    m[1] = r.xy();
    m[2] = r.xz();
    m[3] = r.yx();
    m[4] = r.yy();
    m[5] = r.yz();
    m[6] = r.zx();
    m[7] = r.zy();
    m[8] = r.zz();
  }

  /** Computes pose and velocities from the swept motion. */
  public void read() {
    motion.points.difference(ancestor, link1, r1, 0, link2, r2, 0, moved, 0);
    motion.fromWorld(link1, moved, 0, work, 0);
    apply(a1, 0, work, 0, x, 0);
    for (int i = 0; i < 3; i++) {
      s[i] = r1[i] + work[i];
    }
    // rows of A2 = A1 (R1ᵀ R2): R1ᵀ R2 column by column
    for (int j = 0; j < 3; j++) {
      for (int i = 0; i < 3; i++) {
        moved[i] = i == j ? 1 : 0;
      }
      motion.toWorld(link2, moved, 0, work, 0);
      motion.fromWorld(link1, work, 0, work, 3);
      apply(a1, 0, work, 3, moved, 0);
      for (int i = 0; i < 3; i++) {
        a2[3 * i + j] = moved[i];
      }
    }
    multiply(a2, 0, axes2, 0, x, RelativeMotion.ROTATION);
    readVelocities();
  }

  /** Returns a component in the order of {@link Expression.RelativeMotion}. */
  public double component(int component) {
    return x[component];
  }

  /** Returns a component of the twist: of the angular velocity, rad/s, then of the rate, m/s. */
  public double twist(int component) {
    return x[RelativeMotion.ANGULAR_VELOCITY + component];
  }

  /**
   * Returns the change of a component of the pose for a small motion of frame 2, with the twist
   * held.
   *
   * @param place [rotation; displacement] of frame 2 in the axes of frame 1; not modified
   */
  public double changeOf(int component, double[] place) {
    if (component < RelativeMotion.ROTATION) {
      return place[3 + component];
    } else if (component >= RelativeMotion.ANGULAR_VELOCITY) {
      return 0;
    }
    // row i of δθ × (column j)
    int i = (component - RelativeMotion.ROTATION) / 3;
    int j = (component - RelativeMotion.ROTATION) % 3;
    int next = (i + 1) % 3;
    int last = (i + 2) % 3;
    return place[next] * x[RelativeMotion.ROTATION + 3 * last + j]
        - place[last] * x[RelativeMotion.ROTATION + 3 * next + j];
  }

  private void readVelocities() {
    velocity(link2, r2, a2, omega2, velocity2);
    velocity(link1, s, a1, omega1, moved);
    for (int i = 0; i < 3; i++) {
      x[RelativeMotion.ANGULAR_VELOCITY + i] = omega2[i] - omega1[i];
      x[RelativeMotion.RATE + i] = velocity2[i] - moved[i];
    }
  }

  /**
   * Computes the angular velocity of a link and the velocity u + ω × r of a point of it, in frame
   * 1.
   */
  private void velocity(int link, double[] r, double[] a, double[] omega, double[] u) {
    if (link == TreeGeometry.ROOT) {
      clear(omega);
      clear(u);
      return;
    }
    apply(a, 0, motion.angularVelocity, 3 * link, omega, 0);
    System.arraycopy(motion.linearVelocity, 3 * link, work, 0, 3);
    addCross(motion.angularVelocity, 3 * link, r, 0, work, 0);
    apply(a, 0, work, 0, u, 0);
  }

  private static void clear(double[] x) {
    x[0] = 0;
    x[1] = 0;
    x[2] = 0;
  }

  /**
   * Adds a wrench that acts on body 2, and its opposite on body 1.
   *
   * @param w [moment; force] at frame 2's origin, in the axes of frame 1, N·m, N; not modified
   * @param wrench external wrenches of all links; added to
   */
  void addWrench(double[] w, double[] wrench) {
    if (link2 != TreeGeometry.ROOT) {
      add(w, a2, r2, 1, wrench, 6 * link2);
    }
    if (link1 != TreeGeometry.ROOT) {
      add(w, a1, s, -1, wrench, 6 * link1);
    }
  }

  /**
   * Transfers a wrench on body 2, and its opposite on body 1, to the links' reference points.
   *
   * @param w as for {@link #addWrench}; not modified
   * @param on1 [moment; force] in link 1's axes; overwritten
   * @param on2 in link 2's axes; overwritten
   */
  public void wrenches(double[] w, double[] on1, double[] on2) {
    Arrays.fill(on1, 0);
    Arrays.fill(on2, 0);
    add(w, a1, s, -1, on1, 0);
    add(w, a2, r2, 1, on2, 0);
  }

  /** Adds sign [Aᵀ m + r × Aᵀ f; Aᵀ f]. */
  private void add(double[] w, double[] a, double[] r, double sign, double[] wrench, int at) {
    applyTransposed(a, 0, w, 0, work, 0);
    applyTransposed(a, 0, w, 3, work, 3);
    addCross(r, 0, work, 3, work, 0);
    for (int i = 0; i < 6; i++) {
      wrench[at + i] += sign * work[i];
    }
  }

  /**
   * Writes the change of the relative motion for a small twist of a body, with the components of
   * its velocity held constant.
   *
   * @param first whether body 1 moves
   * @param xi [rotation; displacement] in link axes; not modified
   * @param place change of [rotation; displacement] of frame 2 in frame 1; overwritten
   * @param velocity change of the twist; overwritten
   */
  public void changeByPlace(boolean first, double[] xi, double[] place, double[] velocity) {
    changeByVelocity(first, xi, place);
    double sign = first ? -1 : 1;
    // rotation with body 2 or against body 1, and the motion of s in the rotating body 1
    for (int i = 0; i < 6; i++) {
      velocity[i] = 0;
    }
    apply(first ? a1 : a2, 0, xi, 0, moved, 0);
    for (int i = 0; i < 3; i++) {
      moved[i] *= sign;
    }
    addCross(moved, 0, omega2, 0, velocity, 0);
    addCross(moved, 0, velocity2, 0, velocity, 3);
    addCross(place, 3, omega1, 0, velocity, 3);
  }

  /** As {@link #changeByPlace} for a change of the body's velocity: that of the twist. */
  public void changeByVelocity(boolean first, double[] xi, double[] change) {
    double[] a = first ? a1 : a2;
    double sign = first ? -1 : 1;
    apply(a, 0, xi, 0, change, 0);
    System.arraycopy(xi, 3, work, 0, 3);
    addCross(xi, 0, first ? s : r2, 0, work, 0);
    apply(a, 0, work, 0, change, 3);
    for (int i = 0; i < 6; i++) {
      change[i] *= sign;
    }
  }

  /**
   * Writes the change of the wrench on body 2 in link axes.
   *
   * @param w the wrench as given to {@link #addWrench}
   * @param dw its change, likewise
   * @param firstTurns whether it is body 1 that was moved
   * @param xi the small twist it was moved by; zero for a change of velocity
   * @param out change of the components in link 2's axes; overwritten
   */
  void wrenchChange2(double[] w, double[] dw, boolean firstTurns, double[] xi, double[] out) {
    for (int i = 0; i < 6; i++) {
      work[i] = dw[i];
    }
    // A2ᵀ x changes by A2ᵀ ((A1 θ1) × x), or by −A2ᵀ ((A2 θ2) × x)
    apply(firstTurns ? a1 : a2, 0, xi, 0, moved, 0);
    if (!firstTurns) {
      for (int i = 0; i < 3; i++) {
        moved[i] = -moved[i];
      }
    }
    addCross(moved, 0, w, 0, work, 0);
    addCross(moved, 0, w, 3, work, 3);
    applyTransposed(a2, 0, work, 0, out, 0);
    applyTransposed(a2, 0, work, 3, out, 3);
    addCross(r2, 0, out, 3, out, 0);
  }

  /**
   * Writes the change of the wrench on body 1 in link axes.
   *
   * @param place change of the relative pose; zero for a change of velocity
   */
  void wrenchChange1(double[] w, double[] dw, double[] place, double[] out) {
    for (int i = 0; i < 6; i++) {
      work[i] = -dw[i];
    }
    // the moment arm s moves by A1ᵀ δr: −δr × f
    addCross(w, 3, place, 3, work, 0);
    applyTransposed(a1, 0, work, 0, out, 0);
    applyTransposed(a1, 0, work, 3, out, 3);
    addCross(s, 0, out, 3, out, 0);
  }
}
