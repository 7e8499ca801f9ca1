package org.mechservice.solver.links;

import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Groups of bodies welded together, each as one rigid body. The carrier of an elementary link is
 * the link itself if it moves, otherwise the link to which it is welded, or the root.
 */
public final class RigidGroups {
  /** Carrier of bodies welded to the root. */
  static final int ROOT = TreeGeometry.ROOT;

  /** Mass, its centre, and inertia about the centre, in the carrier's axes at its point. */
  public record MassProperties(double mass, Vector3 center, InertiaTensor inertia) {
    public static final MassProperties NONE =
        new MassProperties(0, Vector3.ZERO, InertiaTensor.ZERO);

    public MassProperties plus(MassProperties other) {
      double sum = mass + other.mass;
      if (other.mass == 0) {
        return new MassProperties(mass, center, sum(inertia, other.inertia));
      }
      if (mass == 0) {
        return new MassProperties(other.mass, other.center, sum(inertia, other.inertia));
      }
      Vector3 both = center.times(mass / sum).plus(other.center.times(other.mass / sum));
      InertiaTensor own = about(mass, center.minus(both), inertia);
      InertiaTensor others = about(other.mass, other.center.minus(both), other.inertia);
      return new MassProperties(sum, both, sum(own, others));
    }

    private static InertiaTensor sum(InertiaTensor a, InertiaTensor b) {
      return new InertiaTensor(
          a.xx() + b.xx(),
          a.yy() + b.yy(),
          a.zz() + b.zz(),
          a.xy() + b.xy(),
          a.xz() + b.xz(),
          a.yz() + b.yz());
    }
  }

  private final TreeGeometry tree;
  private final int[] carrier;
  private final Rotation[] toCarrier;
  private final Vector3[] origin;
  private final MassProperties[] massOf;
  private MassProperties massOfRoot = MassProperties.NONE;

  RigidGroups(TreeGeometry tree) {
    this.tree = tree;
    int count = tree.linkCount;
    carrier = new int[count];
    toCarrier = new Rotation[count];
    origin = new Vector3[count];
    massOf = new MassProperties[count];
    for (int link = 0; link < count; link++) {
      place(link);
      massOf[link] = MassProperties.NONE;
      MassProperties seen = seenByCarrier(link);
      if (carrier[link] == ROOT) {
        massOfRoot = massOfRoot.plus(seen);
      } else {
        massOf[carrier[link]] = massOf[carrier[link]].plus(seen);
      }
    }
  }

  private void place(int link) {
    if (tree.kind[link] != LinkKind.FIXED) {
      carrier[link] = link;
      toCarrier[link] = Rotation.IDENTITY;
      origin[link] = Vector3.ZERO;
      return;
    }
    int parent = tree.parent[link];
    carrier[link] = parent == ROOT ? ROOT : carrier[parent];
    toCarrier[link] = toCarrier(parent).times(rotation(tree.zeroRotation, 9 * link));
    origin[link] = origin(parent).plus(toCarrier(parent).apply(offset(link)));
  }

  private MassProperties seenByCarrier(int link) {
    double[] i = tree.inertia;
    int at = 6 * link;
    InertiaTensor own =
        new InertiaTensor(i[at], i[at + 1], i[at + 2], i[at + 3], i[at + 4], i[at + 5]);
    boolean moves = carrier[link] == link;
    Vector3 center = toCarrier[link].apply(vector(tree.centerOfMass, 3 * link));
    return new MassProperties(
        tree.mass[link], center.plus(origin[link]), moves ? own : own.in(toCarrier[link]));
  }

  /** Returns the link that carries a link, or {@link #ROOT}. */
  int carrier(int link) {
    return link == ROOT ? ROOT : carrier[link];
  }

  /** Returns the rotation from a link's axes to its carrier's. */
  Rotation toCarrier(int link) {
    return link == ROOT ? Rotation.IDENTITY : toCarrier[link];
  }

  /** Returns a link's reference point from its carrier's, in the carrier's axes, m. */
  Vector3 origin(int link) {
    return link == ROOT ? Vector3.ZERO : origin[link];
  }

  /** Returns the mass that a link carries. */
  MassProperties massOf(int link) {
    return massOf[link];
  }

  /** Returns the mass that is welded to the root, in root axes. */
  MassProperties massOfRoot() {
    return massOfRoot;
  }

  /** Returns the point of a link's joint from its parent's carrier, in that one's axes, m. */
  Vector3 offsetFromCarrier(int link) {
    int parent = tree.parent[link];
    return origin(parent).plus(toCarrier(parent).apply(offset(link)));
  }

  private Vector3 offset(int link) {
    return vector(tree.offset, 3 * link);
  }

  static Vector3 vector(double[] numbers, int at) {
    return new Vector3(numbers[at], numbers[at + 1], numbers[at + 2]);
  }

  static Rotation rotation(double[] numbers, int at) {
    return Rotation.ofColumns(
        new Vector3(numbers[at], numbers[at + 3], numbers[at + 6]),
        new Vector3(numbers[at + 1], numbers[at + 4], numbers[at + 7]),
        new Vector3(numbers[at + 2], numbers[at + 5], numbers[at + 8]));
  }

  /** Returns the tensor of inertia about a point from that about the centre of mass. */
  static InertiaTensor about(double mass, Vector3 c, InertiaTensor inertia) {
    return new InertiaTensor(
        inertia.xx() + mass * (c.y() * c.y() + c.z() * c.z()),
        inertia.yy() + mass * (c.x() * c.x() + c.z() * c.z()),
        inertia.zz() + mass * (c.x() * c.x() + c.y() * c.y()),
        inertia.xy() - mass * c.x() * c.y(),
        inertia.xz() - mass * c.x() * c.z(),
        inertia.yz() - mass * c.y() * c.z());
  }
}
