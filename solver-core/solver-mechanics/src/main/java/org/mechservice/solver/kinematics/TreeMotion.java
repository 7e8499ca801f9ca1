package org.mechservice.solver.kinematics;

import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.multiply;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.mechanism.FurtherState;

/**
 * Poses, velocities and accelerations of all links. Workspace of one thread; nothing allocates
 * after construction.
 *
 * <p>Quantities of a link are in its own axes at its reference point, unless their name says {@code
 * world}. Spatial vectors are [angular; linear]: the linear velocity is that of the material point
 * at the reference point, the linear acceleration its derivative as seen in the link's own axes
 * (Featherstone 2008, ch. 2: the acceleration of that point is {@code linearAcceleration + ω × u}).
 * Only the methods of this class write to the arrays.
 */
public final class TreeMotion {
  private final TreeGeometry tree;
  private final LinkPlacement placement;

  /** None without prescribed motions: their formulas take longer to load than a small model. */
  private final Optional<PrescribedCoordinates> prescribed;

  private final LinkMotion moving;

  /** Positions at which the links are placed, and how often these have changed. */
  private final double[] placedAt;

  private long placements;

  /** Whether the poses in the world belong to them. */
  private boolean inWorld;

  /** Extended positions, velocities and accelerations of the last sweeps; rad, m, s. */
  public final double[] q;

  public final double[] v;
  public final double[] a;

  /**
   * Further states of the last sweep of a state that has them, in their own units; until then their
   * start values.
   */
  public final double[] further;

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
   * Velocity product c: the link's acceleration relative to its parent at constant joint
   * velocities, [angular; linear], 6 per link.
   */
  public final double[] velocityProduct;

  /** Rotation link axes to world axes, 9 per link. */
  public final double[] worldRotation;

  /** Reference point from the world's origin, in world axes, m, 3 per link. */
  public final double[] worldPosition;

  /** Angular part of the spatial acceleration without gravity, rad/s², 3 per link. */
  public final double[] angularAcceleration;

  /** Linear part of the spatial acceleration without gravity, m/s², 3 per link. */
  public final double[] linearAcceleration;

  /** Unwrapped coordinates of cut joints on which forces depend. */
  public final CountedPositions counted = new CountedPositions();

  /** Points of the links, in the world. */
  public final PointMotion points;

  /** Wrenches on the links, and their transfer to the root. */
  public final LinkWrenches wrenches;

  /** Makes a workspace for a tree. */
  public TreeMotion(TreeGeometry tree) {
    this.tree = tree;
    int n = tree.linkCount;
    q = new double[tree.positionCount];
    placedAt = new double[tree.positionCount];
    v = new double[tree.velocityCount];
    a = new double[tree.velocityCount];
    further = tree.mechanism().furtherStates().stream().mapToDouble(FurtherState::start).toArray();
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
    prescribed =
        tree.mechanism().motions().isEmpty()
            ? Optional.empty()
            : Optional.of(new PrescribedCoordinates(tree));
    moving = new LinkMotion(this);
    points = new PointMotion(this);
    wrenches = new LinkWrenches(this);
  }

  /** Returns the constants of the tree. */
  public TreeGeometry tree() {
    return tree;
  }

  /**
   * Sets the values of the mechanism's parameters for the motions of driven joints.
   *
   * @param parameters one number per parameter, SI units; copied
   */
  public void setParameters(double[] parameters) {
    prescribed.ifPresent(motions -> motions.setParameters(parameters));
  }

  /**
   * Sweeps outwards: poses and velocities, relative to the parents and in the world.
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
   * Sweeps outwards for a state y = [q; v; s]: poses and velocities, relative to the parents and in
   * the world. An array of [q; v] alone leaves the further states s as they are.
   *
   * @param t time, s
   * @param y state; not modified
   */
  public void sweep(double t, double[] y) {
    sweepRelative(t, y);
    placeInWorld();
  }

  /**
   * As {@link #sweep(double, double[])} without the poses in the world, which keep their values.
   */
  public void sweepRelative(double t, double[] y) {
    setCoordinates(t, y);
    sweepRelative();
  }

  /**
   * Sets the coordinates of a state y = [q; v; s] and those of driven joints; poses and velocities
   * of the links keep their values until a sweep.
   *
   * @param t time, s
   * @param y state; not modified
   */
  public void setCoordinates(double t, double[] y) {
    int at = tree.statePositionCount + tree.stateVelocityCount;
    if (y.length >= at + further.length) {
      System.arraycopy(y, at, further, 0, further.length);
    }
    setCoordinates(t, y, 0, y, tree.statePositionCount);
  }

  private void setCoordinates(double t, double[] q, int qAt, double[] v, int vAt) {
    System.arraycopy(q, qAt, this.q, 0, tree.statePositionCount);
    System.arraycopy(v, vAt, this.v, 0, tree.stateVelocityCount);
    if (prescribed.isPresent()) {
      prescribed.get().evaluate(t, this.q, this.v, a);
    }
  }

  private void sweep(double t, double[] q, int qAt, double[] v, int vAt) {
    setCoordinates(t, q, qAt, v, vAt);
    sweepRelative();
  }

  /** Sweeps the links relative to their parents for the coordinates set last. */
  public void sweepRelative() {
    // as bits: positions that differ by the sign of a zero are others
    if (placements == 0 || Arrays.mismatch(q, placedAt) >= 0) {
      System.arraycopy(q, 0, placedAt, 0, q.length);
      placements++;
      inWorld = false;
      for (int link = 0; link < tree.linkCount; link++) {
        placement.place(link, q);
      }
    }
    for (int link = 0; link < tree.linkCount; link++) {
      moving.move(link);
    }
  }

  /**
   * Returns a number that changes with the positions of the links: what was computed from their
   * poses alone at the same number need not be computed again.
   */
  public long placement() {
    return placements;
  }

  private void placeInWorld() {
    if (inWorld) {
      return;
    }
    inWorld = true;
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
   * Sweeps accelerations outwards after {@link #sweep}. With all of {@code a} zero they consist of
   * velocity products and of the prescribed accelerations of driven joints.
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
      moving.accelerate(link);
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
}
