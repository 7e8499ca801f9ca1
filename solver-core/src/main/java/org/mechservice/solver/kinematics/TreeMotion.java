package org.mechservice.solver.kinematics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.multiply;

/**
 * Where each link is, how fast it moves and how it accelerates. Workspace of one thread; nothing
 * allocates after construction.
 *
 * <p>Quantities of a link are in its own axes at its reference point, unless their name says {@code
 * world}. Spatial vectors are [angular; linear]: the linear velocity is that of the material point
 * at the reference point, the linear acceleration its derivative as seen in the link's own axes
 * (Featherstone 2008, ch. 2: the acceleration of that point is {@code linearAcceleration + ω × u}).
 * The arrays are written by the methods here and read by everyone else.
 */
public final class TreeMotion {
  private final TreeGeometry tree;
  private final LinkPlacement placement;
  private final PrescribedCoordinates prescribed;

  /** Extended positions, velocities and accelerations of the last sweeps; rad, m, s. */
  public final double[] q;

  public final double[] v;
  public final double[] a;

  /** Rotation link axes to parent axes, 9 per link. */
  public final double[] rotation;

  /** Reference point from the parent's reference point, in parent axes, m, 3 per link. */
  public final double[] position;

  /** Angular velocity, rad/s, 3 per link. */
  public final double[] angularVelocity;

  /** Velocity of the reference point, m/s, 3 per link. */
  public final double[] linearVelocity;

  /**
   * Motion subspace: the columns S of all velocities, [angular; linear], 6 per extended velocity.
   */
  public final double[] subspace;

  /** Relative velocity S v of the link to its parent, [angular; linear], 6 per link. */
  public final double[] relativeVelocity;

  /**
   * Velocity product c: the acceleration that the link has beyond its parent's when S v does not
   * change, [angular; linear], 6 per link.
   */
  public final double[] velocityProduct;

  /** Rotation link axes to world axes, 9 per link. */
  public final double[] worldRotation;

  /** Reference point from the world's origin, in world axes, m, 3 per link. */
  public final double[] worldPosition;

  /** Angular part of the spatial acceleration, rad/s², 3 per link. Gravity is not in it. */
  public final double[] angularAcceleration;

  /** Linear part of the spatial acceleration, m/s², 3 per link. Gravity is not in it. */
  public final double[] linearAcceleration;

  /** What angles in cut joints, which forces depend on, count from. */
  public final CountedPositions counted = new CountedPositions();

  private final double[] carried = new double[3];

  /** Makes a workspace for a tree. */
  public TreeMotion(TreeGeometry tree) {
    this.tree = tree;
    int n = tree.linkCount;
    q = new double[tree.positionCount];
    v = new double[tree.velocityCount];
    a = new double[tree.velocityCount];
    rotation = new double[9 * n];
    position = new double[3 * n];
    angularVelocity = new double[3 * n];
    linearVelocity = new double[3 * n];
    subspace = new double[6 * tree.velocityCount];
    relativeVelocity = new double[6 * n];
    velocityProduct = new double[6 * n];
    worldRotation = new double[9 * n];
    worldPosition = new double[3 * n];
    angularAcceleration = new double[3 * n];
    linearAcceleration = new double[3 * n];
    placement = new LinkPlacement(tree, rotation, position, subspace);
    prescribed = new PrescribedCoordinates(tree);
  }

  /** Returns the constants of the tree this is the motion of. */
  public TreeGeometry tree() {
    return tree;
  }

  /**
   * Takes other values of the mechanism's parameters for the motions of driven joints.
   *
   * @param parameters one number per parameter, SI units; copied
   */
  public void setParameters(double[] parameters) {
    prescribed.setParameters(parameters);
  }

  /**
   * Sweeps outwards: places and velocities, relative to the parents and in the world.
   *
   * @param t time, s
   * @param q positions in state order, rad, m; not modified
   * @param v velocities in state order, rad/s, m/s; not modified
   */
  public void sweep(double t, double[] q, double[] v) {
    sweep(t, q, 0, v, 0);
    placeInWorld();
  }

  /**
   * Sweeps outwards for a state y = [q; v]: places and velocities, relative to the parents and in
   * the world.
   *
   * @param t time, s
   * @param y state; not modified
   */
  public void sweep(double t, double[] y) {
    sweepRelative(t, y);
    placeInWorld();
  }

  /**
   * As {@link #sweep(double, double[])} without the places in the world, which keep their values.
   */
  public void sweepRelative(double t, double[] y) {
    sweep(t, y, 0, y, tree.statePositionCount);
  }

  private void sweep(double t, double[] q, int qAt, double[] v, int vAt) {
    System.arraycopy(q, qAt, this.q, 0, tree.statePositionCount);
    System.arraycopy(v, vAt, this.v, 0, tree.stateVelocityCount);
    prescribed.evaluate(t, this.q, this.v, a);
    for (int link = 0; link < tree.linkCount; link++) {
      placement.place(link, this.q);
      move(link);
    }
  }

  /** V = X V_p + S v: ω = Rᵀ ω_p + S_ω v, u = Rᵀ (u_p + ω_p × p) + S_u v; c = X V_p × S v. */
  private void move(int link) {
    carryVelocity(link);
    switch (tree.kind[link]) {
      case TURN -> turn(link);
      case SLIDE -> slide(link);
      case SCREW, BALL -> moveAlongColumns(link);
      case FIXED -> {
        // relative velocity and velocity product stay zero
      }
    }
  }

  /** Writes the velocity of the parent, seen at the link, as if it were the link's. */
  private void carryVelocity(int link) {
    int at = 3 * link;
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      setZero(angularVelocity, at);
      setZero(linearVelocity, at);
      return;
    }
    applyTransposed(rotation, 9 * link, angularVelocity, 3 * parent, angularVelocity, at);
    System.arraycopy(linearVelocity, 3 * parent, carried, 0, 3);
    addCross(angularVelocity, 3 * parent, position, at, carried, 0);
    applyTransposed(rotation, 9 * link, carried, 0, linearVelocity, at);
  }

  private void turn(int link) {
    int at = 3 * link;
    double rate = v[tree.velocityAt[link]];
    for (int i = 0; i < 3; i++) {
      relativeVelocity[2 * at + i] = rate * tree.axisInLink[at + i];
    }
    cross(angularVelocity, at, relativeVelocity, 2 * at, velocityProduct, 2 * at);
    cross(linearVelocity, at, relativeVelocity, 2 * at, velocityProduct, 2 * at + 3);
    for (int i = 0; i < 3; i++) {
      angularVelocity[at + i] += relativeVelocity[2 * at + i];
    }
  }

  private void slide(int link) {
    int at = 3 * link;
    double rate = v[tree.velocityAt[link]];
    for (int i = 0; i < 3; i++) {
      relativeVelocity[2 * at + 3 + i] = rate * tree.axisInLink[at + i];
    }
    cross(angularVelocity, at, relativeVelocity, 2 * at + 3, velocityProduct, 2 * at + 3);
    for (int i = 0; i < 3; i++) {
      linearVelocity[at + i] += relativeVelocity[2 * at + 3 + i];
    }
  }

  private void moveAlongColumns(int link) {
    int at = 3 * link;
    int first = tree.velocityAt[link];
    int end = first + tree.kind[link].velocityCount();
    for (int i = 0; i < 6; i++) {
      double sum = 0;
      for (int k = first; k < end; k++) {
        sum += v[k] * subspace[6 * k + i];
      }
      relativeVelocity[2 * at + i] = sum;
    }
    cross(angularVelocity, at, relativeVelocity, 2 * at, velocityProduct, 2 * at);
    cross(linearVelocity, at, relativeVelocity, 2 * at, velocityProduct, 2 * at + 3);
    addCross(angularVelocity, at, relativeVelocity, 2 * at + 3, velocityProduct, 2 * at + 3);
    for (int i = 0; i < 3; i++) {
      angularVelocity[at + i] += relativeVelocity[2 * at + i];
      linearVelocity[at + i] += relativeVelocity[2 * at + 3 + i];
    }
  }

  private void placeInWorld() {
    for (int link = 0; link < tree.linkCount; link++) {
      int parent = tree.parent[link];
      boolean onRoot = parent == TreeGeometry.ROOT;
      double[] parentRotation = onRoot ? tree.rootRotation : worldRotation;
      int parentAt = onRoot ? 0 : 9 * parent;
      multiply(parentRotation, parentAt, rotation, 9 * link, worldRotation, 9 * link);
      apply(parentRotation, parentAt, position, 3 * link, worldPosition, 3 * link);
      for (int i = 0; i < 3; i++) {
        worldPosition[3 * link + i] +=
            onRoot ? tree.rootPosition[i] : worldPosition[3 * parent + i];
      }
    }
  }

  /**
   * Sweeps accelerations outwards after {@link #sweep}. With all of {@code a} zero they are the
   * velocity products, and what the motions of driven joints add.
   *
   * @param a joint accelerations in state order, rad/s², m/s²; not modified
   */
  public void accelerationSweep(double[] a) {
    accelerationSweep(a, 0);
  }

  /**
   * As {@link #accelerationSweep(double[])}, with accelerations that begin at an offset.
   *
   * @param aAt where they begin
   */
  public void accelerationSweep(double[] a, int aAt) {
    System.arraycopy(a, aAt, this.a, 0, tree.stateVelocityCount);
    for (int link = 0; link < tree.linkCount; link++) {
      accelerate(link);
    }
  }

  /** A = X A_p + S a + c. */
  private void accelerate(int link) {
    int at = 3 * link;
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      setZero(angularAcceleration, at);
      setZero(linearAcceleration, at);
    } else {
      applyTransposed(rotation, 9 * link, angularAcceleration, 3 * parent, angularAcceleration, at);
      System.arraycopy(linearAcceleration, 3 * parent, carried, 0, 3);
      addCross(angularAcceleration, 3 * parent, position, at, carried, 0);
      applyTransposed(rotation, 9 * link, carried, 0, linearAcceleration, at);
    }
    for (int i = 0; i < 3; i++) {
      angularAcceleration[at + i] += velocityProduct[2 * at + i];
      linearAcceleration[at + i] += velocityProduct[2 * at + 3 + i];
    }
    int end = tree.velocityAt[link] + tree.kind[link].velocityCount();
    for (int k = tree.velocityAt[link]; k < end; k++) {
      for (int i = 0; i < 3; i++) {
        angularAcceleration[at + i] += a[k] * subspace[6 * k + i];
        linearAcceleration[at + i] += a[k] * subspace[6 * k + 3 + i];
      }
    }
  }

  /**
   * Writes the place of a point in the world.
   *
   * @param link the point's link, or {@link TreeGeometry#ROOT}
   * @param r from the link's reference point (the root's origin), in link (root) axes, m
   * @param out from the world's origin, world axes, m; overwritten
   */
  public void pointPosition(int link, double[] r, int rAt, double[] out, int at) {
    boolean onRoot = link == TreeGeometry.ROOT;
    toWorld(link, r, rAt, out, at);
    for (int i = 0; i < 3; i++) {
      out[at + i] += onRoot ? tree.rootPosition[i] : worldPosition[3 * link + i];
    }
  }

  /**
   * Writes the velocity of a point, world axes, m/s; arguments as for {@link #pointPosition}.
   *
   * @param out overwritten
   */
  public void pointVelocity(int link, double[] r, int rAt, double[] out, int at) {
    if (link == TreeGeometry.ROOT) {
      setZero(out, at);
      return;
    }
    // u + ω × r
    System.arraycopy(linearVelocity, 3 * link, carried, 0, 3);
    addCross(angularVelocity, 3 * link, r, rAt, carried, 0);
    apply(worldRotation, 9 * link, carried, 0, out, at);
  }

  /**
   * Writes the acceleration of a point after {@link #accelerationSweep}, world axes, m/s²;
   * arguments as for {@link #pointPosition}.
   *
   * @param out overwritten
   */
  public void pointAcceleration(int link, double[] r, int rAt, double[] out, int at) {
    if (link == TreeGeometry.ROOT) {
      setZero(out, at);
      return;
    }
    // u' + α × r + ω × (u + ω × r)
    System.arraycopy(linearVelocity, 3 * link, carried, 0, 3);
    addCross(angularVelocity, 3 * link, r, rAt, carried, 0);
    double x = carried[0];
    double y = carried[1];
    double z = carried[2];
    System.arraycopy(linearAcceleration, 3 * link, carried, 0, 3);
    addCross(angularAcceleration, 3 * link, r, rAt, carried, 0);
    double wx = angularVelocity[3 * link];
    double wy = angularVelocity[3 * link + 1];
    double wz = angularVelocity[3 * link + 2];
    carried[0] += wy * z - wz * y;
    carried[1] += wz * x - wx * z;
    carried[2] += wx * y - wy * x;
    apply(worldRotation, 9 * link, carried, 0, out, at);
  }

  /**
   * Writes the way from one point to another, summed along the tree from their nearest common
   * ancestor: it keeps its digits however far both are from the world's origin.
   *
   * @param ancestor {@link TreeGeometry#commonAncestor} of the two links
   * @param out second point minus first, world axes, m; overwritten
   */
  public void pointDifference(
      int ancestor,
      int first,
      double[] r1,
      int r1At,
      int second,
      double[] r2,
      int r2At,
      double[] out,
      int at) {
    fromAncestor(ancestor, first, r1, r1At);
    double x = carried[0];
    double y = carried[1];
    double z = carried[2];
    fromAncestor(ancestor, second, r2, r2At);
    carried[0] -= x;
    carried[1] -= y;
    carried[2] -= z;
    toWorld(ancestor, carried, 0, out, at);
  }

  /** Leaves the place of a point in {@code carried}, from the ancestor's point in its axes. */
  private void fromAncestor(int ancestor, int link, double[] r, int rAt) {
    System.arraycopy(r, rAt, carried, 0, 3);
    for (int i = link; i != ancestor; i = tree.parent[i]) {
      double x = carried[0];
      double y = carried[1];
      double z = carried[2];
      for (int k = 0; k < 3; k++) {
        int row = 9 * i + 3 * k;
        carried[k] =
            position[3 * i + k]
                + (rotation[row] * x + rotation[row + 1] * y + rotation[row + 2] * z);
      }
    }
  }

  /**
   * Turns a vector from link axes to world axes.
   *
   * @param link the vector's link, or {@link TreeGeometry#ROOT}
   * @param out overwritten
   */
  public void toWorld(int link, double[] vector, int vectorAt, double[] out, int at) {
    if (link == TreeGeometry.ROOT) {
      apply(tree.rootRotation, 0, vector, vectorAt, out, at);
    } else {
      apply(worldRotation, 9 * link, vector, vectorAt, out, at);
    }
  }

  /**
   * Turns a vector from world axes to link axes.
   *
   * @param link the link, or {@link TreeGeometry#ROOT}
   * @param out overwritten
   */
  public void fromWorld(int link, double[] vector, int vectorAt, double[] out, int at) {
    if (link == TreeGeometry.ROOT) {
      applyTransposed(tree.rootRotation, 0, vector, vectorAt, out, at);
    } else {
      applyTransposed(worldRotation, 9 * link, vector, vectorAt, out, at);
    }
  }

  /**
   * Adds a force at a point to the wrench of its link; one on the root is without effect.
   *
   * @param link the point's link, or {@link TreeGeometry#ROOT}
   * @param r from the link's reference point, in link axes, m
   * @param force in world axes, N
   * @param wrench [moment; force] in link axes at the reference point, 6 per link, N·m, N; added to
   */
  public void addForceAtPoint(
      int link, double[] r, int rAt, double[] force, int forceAt, double[] wrench) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    applyTransposed(worldRotation, 9 * link, force, forceAt, carried, 0);
    addCross(r, rAt, carried, 0, wrench, 6 * link);
    for (int i = 0; i < 3; i++) {
      wrench[6 * link + 3 + i] += carried[i];
    }
  }

  /**
   * Adds factor · wᵀ J to a row, with J the derivative of the link's velocity by the extended
   * velocities: what a wrench on the link does on every joint on the way to the root.
   *
   * @param link the link, or {@link TreeGeometry#ROOT} for no effect
   * @param wrench [moment; force] in link axes at its reference point; overwritten
   * @param row one number per extended velocity; added to
   */
  public void addRow(int link, double[] wrench, int wrenchAt, double factor, double[] row) {
    for (int i = link; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      int end = tree.velocityAt[i] + tree.kind[i].velocityCount();
      for (int k = tree.velocityAt[i]; k < end; k++) {
        double sum = 0;
        for (int m = 0; m < 6; m++) {
          sum += wrench[wrenchAt + m] * subspace[6 * k + m];
        }
        row[k] += factor * sum;
      }
      wrenchToParent(i, wrench, wrenchAt);
    }
  }

  /**
   * Refers a wrench to the parent of a link: f_p = R f, n_p = R n + p × f_p.
   *
   * @param wrench [moment; force] in link axes; overwritten with that in parent axes
   */
  public void wrenchToParent(int link, double[] wrench, int at) {
    apply(rotation, 9 * link, wrench, at + 3, carried, 0);
    double x = wrench[at];
    double y = wrench[at + 1];
    double z = wrench[at + 2];
    System.arraycopy(carried, 0, wrench, at + 3, 3);
    cross(position, 3 * link, carried, 0, wrench, at);
    for (int k = 0; k < 3; k++) {
      int row = 9 * link + 3 * k;
      wrench[at + k] += rotation[row] * x + rotation[row + 1] * y + rotation[row + 2] * z;
    }
  }

  private static void setZero(double[] out, int at) {
    out[at] = 0;
    out[at + 1] = 0;
    out[at + 2] = 0;
  }
}
