package org.mechservice.solver.kinematics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Armature;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A mechanism's constants as flat arrays for the recursions: elementary links from the root
 * outwards, each with its own axes and its own reference point. The last link of a joint is the
 * child body itself, in the body's axes, with the joint's point on it as reference point; the links
 * before it are massless.
 *
 * <p>Reference points lie on the bodies, not at the world origin, so that sums and differences keep
 * their digits at any distance from it (docs/theory/motion.md#spatial-vectors).
 *
 * <p><i>Extended</i> coordinates are those of the state, in state order, followed by those of
 * driven joints in file order.
 *
 * <p>Immutable; callers must not write to the shared arrays.
 */
public final class TreeGeometry {
  /** Parent of links whose parent is the root; equals {@link Mechanism#ROOT}. */
  public static final int ROOT = -1;

  /** Number of elementary links. */
  public final int linkCount;

  /** Parent link, or {@link #ROOT}; always smaller than the link's own index. */
  public final int[] parent;

  /** Elementary motion of each link. */
  public final LinkKind[] kind;

  /** Index of the link's joint in file order. */
  public final int[] joint;

  /** Index of the link's first position in the extended q; undefined for fixed links. */
  public final int[] positionAt;

  /** Index of the link's first velocity in the extended v; undefined for fixed links. */
  public final int[] velocityAt;

  /** The link's first velocity among those of its joint. */
  public final int[] component;

  /** Whether the link's coordinates follow prescribed motions. */
  public final boolean[] driven;

  /** Whether Euler parameters turn the parent relative to the link. */
  public final boolean[] inverse;

  /** Unit axis in link axes and in parent axes, 3 per link. */
  public final double[] axisInLink;

  public final double[] axisInParent;

  /** Pitch of screws, m/rad. */
  public final double[] pitch;

  /** Rotation at zero, link to parent axes, row by row, 9 per link. */
  public final double[] zeroRotation;

  /** Whether the rotation at zero is the identity. */
  public final boolean[] parallelAtZero;

  /**
   * The link's reference point at zero from the parent's reference point, in parent axes, m, 3 per
   * link.
   */
  public final double[] offset;

  /** Body of the link, or -1 for a link inside a joint. */
  public final int[] body;

  /** Mass, kg. */
  public final double[] mass;

  /** Centre of mass from the reference point, in link axes, m, 3 per link. */
  public final double[] centerOfMass;

  /** Inertia about the centre of mass in link axes, kg·m²: xx, yy, zz, xy, xz, yz, 6 per link. */
  public final double[] inertia;

  /** The file's body origin from the reference point, in body axes, m, 3 per link. */
  public final double[] bodyOrigin;

  /** Link of each body, in file order. */
  public final int[] linkOfBody;

  /** Number of links between each link and the root. */
  public final int[] depth;

  /** Link of each extended velocity. */
  public final int[] linkOfVelocity;

  /** Inertia of its own of each extended velocity, kg·m² or kg; 0 if there is none. */
  public final double[] armature;

  /** Lengths of the extended q and v, and of the state's part of them. */
  public final int positionCount;

  public final int velocityCount;
  public final int statePositionCount;
  public final int stateVelocityCount;

  /** Root axes to world axes, 9 numbers, and the root's origin in the world, m, 3 numbers. */
  public final double[] rootRotation;

  public final double[] rootPosition;

  /** Acceleration of free fall in world axes, and in root axes, m/s². */
  public final double[] gravity;

  public final double[] gravityInRoot;

  private final Mechanism mechanism;

  /** Decomposes a mechanism's joints into elementary links. */
  public TreeGeometry(Mechanism mechanism) {
    this.mechanism = mechanism;
    List<List<ElementaryLink>> chains = new ArrayList<>();
    int count = 0;
    for (int j : mechanism.outward()) {
      List<ElementaryLink> chain = JointChain.of(mechanism.joints().get(j));
      chains.add(chain);
      count += chain.size();
    }
    linkCount = count;
    parent = new int[count];
    kind = new LinkKind[count];
    joint = new int[count];
    positionAt = new int[count];
    velocityAt = new int[count];
    component = new int[count];
    driven = new boolean[count];
    inverse = new boolean[count];
    axisInLink = new double[3 * count];
    axisInParent = new double[3 * count];
    pitch = new double[count];
    zeroRotation = new double[9 * count];
    parallelAtZero = new boolean[count];
    offset = new double[3 * count];
    body = new int[count];
    mass = new double[count];
    centerOfMass = new double[3 * count];
    inertia = new double[6 * count];
    bodyOrigin = new double[3 * count];
    depth = new int[count];
    linkOfBody = new int[mechanism.bodies().size()];
    ExtendedOffsets offsets = new ExtendedOffsets(mechanism);
    positionCount = offsets.positionCount();
    velocityCount = offsets.velocityCount();
    statePositionCount = mechanism.positionCount();
    stateVelocityCount = mechanism.velocityCount();
    linkOfVelocity = new int[velocityCount];
    armature = new double[velocityCount];
    Root root = mechanism.root();
    rootRotation = new double[9];
    put(rootRotation, 0, root.orientation());
    rootPosition = components(root.position());
    gravity = components(mechanism.gravity());
    gravityInRoot = components(root.orientation().transposed().apply(mechanism.gravity()));
    fill(chains, offsets);
    for (Armature armed : mechanism.armatures()) {
      for (int k = 0; k < armed.inertias().size(); k++) {
        armature[offsets.velocity(armed.joint()) + k] = armed.inertias().get(k);
      }
    }
  }

  private void fill(List<List<ElementaryLink>> chains, ExtendedOffsets offsets) {
    int[] outward = mechanism.outward();
    int link = 0;
    for (int i = 0; i < outward.length; i++) {
      Attachment attachment = mechanism.joints().get(outward[i]).attachment();
      int before = attachment.parent() == Mechanism.ROOT ? ROOT : linkOfBody[attachment.parent()];
      put(offset, 3 * link, attachment.parentPoint().minus(reference(attachment.parent())));
      for (ElementaryLink step : chains.get(i)) {
        parent[link] = before;
        depth[link] = before == ROOT ? 0 : depth[before] + 1;
        body[link] = -1;
        fillStep(link, outward[i], step, offsets);
        before = link++;
      }
      fillBody(before, attachment);
    }
  }

  /** Returns the reference point of a body, from its origin in its axes. */
  private Vector3 reference(int ofBody) {
    if (ofBody == Mechanism.ROOT) {
      return Vector3.ZERO;
    }
    Joint inner = mechanism.joints().get(mechanism.jointOf(ofBody));
    return inner.attachment().childPoint();
  }

  private void fillStep(int link, int ofJoint, ElementaryLink step, ExtendedOffsets offsets) {
    kind[link] = step.kind();
    joint[link] = ofJoint;
    positionAt[link] = offsets.position(ofJoint) + step.position();
    velocityAt[link] = offsets.velocity(ofJoint) + step.velocity();
    component[link] = step.velocity();
    driven[link] = mechanism.isDriven(ofJoint);
    inverse[link] = step.inverse();
    pitch[link] = step.pitch();
    parallelAtZero[link] = step.zeroRotation().isIdentity();
    put(zeroRotation, 9 * link, step.zeroRotation());
    put(axisInParent, 3 * link, step.axis());
    put(axisInLink, 3 * link, step.zeroRotation().transposed().apply(step.axis()));
    Arrays.fill(
        linkOfVelocity, velocityAt[link], velocityAt[link] + step.kind().velocityCount(), link);
  }

  private void fillBody(int link, Attachment attachment) {
    body[link] = attachment.child();
    linkOfBody[attachment.child()] = link;
    put(bodyOrigin, 3 * link, attachment.childPoint().negated());
    Body moved = mechanism.bodies().get(attachment.child());
    mass[link] = moved.mass();
    put(centerOfMass, 3 * link, moved.centerOfMass().minus(attachment.childPoint()));
    InertiaTensor tensor = moved.inertia();
    put(inertia, 6 * link, new Vector3(tensor.xx(), tensor.yy(), tensor.zz()));
    put(inertia, 6 * link + 3, new Vector3(tensor.xy(), tensor.xz(), tensor.yz()));
  }

  /** Returns the mechanism. */
  public Mechanism mechanism() {
    return mechanism;
  }

  /** Returns the link of a body, or {@link #ROOT} for {@link Mechanism#ROOT}. */
  public int linkOf(int ofBody) {
    return ofBody == Mechanism.ROOT ? ROOT : linkOfBody[ofBody];
  }

  /**
   * Writes a point of a body from the reference point of its link, in body axes; a point of the
   * root from the root's origin, in root axes.
   *
   * @param out three numbers from {@code at}, m; overwritten
   */
  public void fromReference(BodyPoint point, double[] out, int at) {
    put(out, at, point.position().minus(reference(point.body())));
  }

  /** Returns the nearest common ancestor of two links, or {@link #ROOT}. */
  public int commonAncestor(int first, int second) {
    int a = first;
    int b = second;
    while (a != b) {
      if (a > b) {
        a = parent[a];
      } else {
        b = parent[b];
      }
    }
    return a;
  }

  private static double[] components(Vector3 v) {
    return new double[] {v.x(), v.y(), v.z()};
  }

  private static void put(double[] target, int at, Rotation r) {
    put(target, at, new Vector3(r.xx(), r.xy(), r.xz()));
    put(target, at + 3, new Vector3(r.yx(), r.yy(), r.yz()));
    put(target, at + 6, new Vector3(r.zx(), r.zy(), r.zz()));
  }

  private static void put(double[] target, int at, Vector3 v) {
    target[at] = v.x();
    target[at + 1] = v.y();
    target[at + 2] = v.z();
  }

  /** Returns whether two links are one, next to each other, or one of them is the root. */
  public boolean areNeighbours(int first, int second) {
    return first == second
        || first == ROOT
        || second == ROOT
        || parent[first] == second
        || parent[second] == first;
  }
}
