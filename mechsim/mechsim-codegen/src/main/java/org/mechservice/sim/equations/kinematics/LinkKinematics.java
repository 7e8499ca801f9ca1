package org.mechservice.sim.equations.kinematics;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.links.Axes;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Positions and velocities of links, computed on first use by forces or outputs. Vectors are
 * transformed along the tree from link to link; differences of positions start at the nearest
 * common ancestor, so that they keep their digits far from the origin.
 */
public final class LinkKinematics {
  private final Program program;
  private final Expressions expressions;
  private final Links mechanism;
  private final List<Link> links;
  private final Coordinates coordinates;
  private final Optional<LinkPlaces> places;
  private final @Nullable ScalarVector[] omega;
  private final @Nullable ScalarVector[] velocity;

  public LinkKinematics(Program program, Links mechanism, Coordinates coordinates) {
    this(program, mechanism, coordinates, false);
  }

  /**
   * @param placed whether vectors are transformed by the places of links instead of from link to
   *     link: shorter for many vectors, with sections that equal links share
   */
  public LinkKinematics(Program program, Links mechanism, Coordinates coordinates, boolean placed) {
    this.program = program;
    this.expressions = program.expressions();
    this.mechanism = mechanism;
    this.links = mechanism.links();
    this.coordinates = coordinates;
    this.omega = new ScalarVector[links.size()];
    this.velocity = new ScalarVector[links.size()];
    this.places = placed ? Optional.of(new LinkPlaces(program, this)) : Optional.empty();
  }

  /** Returns the mechanism. */
  public Links mechanism() {
    return mechanism;
  }

  /** Returns a vector of zeros. */
  public ScalarVector zero() {
    return ScalarVector.zero(expressions);
  }

  /** Returns parent components of a vector given in the components of a link. */
  ScalarVector toParent(Link link, ScalarVector v) {
    ScalarVector turned = v;
    if (link.isBall()) {
      turned = coordinates.ballRotation(link).times(v);
    } else if (link.turns()) {
      turned = v.turned(2, coordinates.cosine(link), coordinates.sine(link));
    }
    return link.axes().toParent(turned);
  }

  /** Returns link components of a vector given in the components of the parent. */
  public ScalarVector toLink(Link link, ScalarVector v) {
    ScalarVector atJoint = link.axes().toChild(v);
    if (link.isBall()) {
      return coordinates.ballRotation(link).transposed().times(atJoint);
    }
    return link.turns()
        ? atJoint.turned(2, coordinates.cosine(link), coordinates.sine(link).negated())
        : atJoint;
  }

  /** Returns the link's origin from the parent's, in parent components. */
  public ScalarVector origin(Link link) {
    ScalarVector offset = ScalarVector.of(expressions, link.offset());
    if (!link.slides()) {
      return offset;
    }
    Scalar zero = expressions.zero();
    ScalarVector way = new ScalarVector(zero, zero, coordinates.way(link));
    return offset.plus(link.axes().toParent(way));
  }

  /** Returns the angular velocity of a link in its own axes, rad/s. */
  public ScalarVector omega(int index) {
    if (index == Links.ROOT) {
      return zero();
    }
    ScalarVector known = omega[index];
    if (known == null) {
      Link link = links.get(index);
      known = program.named("omega_" + link.bodyLabel(), angular(link, omega(link.parent())));
      omega[index] = known;
    }
    return known;
  }

  /**
   * Returns the angular velocity, with the operations in the order of the first sweep, so that
   * nothing is computed twice.
   */
  private ScalarVector angular(Link link, ScalarVector ofParent) {
    ScalarVector joint = link.axes().toChild(ofParent);
    if (link.isBall()) {
      ScalarMatrix toChild = coordinates.ballRotation(link).transposed();
      ScalarVector v = coordinates.ballVelocity(link);
      return link.inverse()
          ? toChild.times(joint).plus(v.map(Scalar::negated))
          : toChild.times(joint.plus(v));
    }
    if (!link.turns()) {
      return joint;
    }
    ScalarVector turned =
        joint.turned(2, coordinates.cosine(link), coordinates.sine(link).negated());
    return new ScalarVector(turned.x(), turned.y(), turned.z().plus(coordinates.velocity(link)));
  }

  /** Returns the velocity of a link's origin in its own axes, m/s. */
  public ScalarVector velocity(int index) {
    if (index == Links.ROOT) {
      return zero();
    }
    ScalarVector known = velocity[index];
    if (known == null) {
      Link link = links.get(index);
      known = program.named("u_" + link.bodyLabel(), linear(link));
      velocity[index] = known;
    }
    return known;
  }

  private ScalarVector linear(Link link) {
    ScalarVector carried = velocity(link.parent()).plus(omega(link.parent()).cross(origin(link)));
    if (link.slides()) {
      Scalar zero = expressions.zero();
      ScalarVector rate = new ScalarVector(zero, zero, coordinates.wayRate(link));
      carried = carried.plus(link.axes().toParent(rate));
    }
    return toLink(link, carried);
  }

  /** Returns the velocity of a link's point at {@code r}, in the link's axes. */
  public ScalarVector velocityAt(int index, ScalarVector r) {
    return index == Links.ROOT ? zero() : velocity(index).plus(omega(index).cross(r));
  }

  /** Returns the nearest common ancestor of two links, which may be one of them or the root. */
  public int commonAncestor(int first, int second) {
    int a = first;
    int b = second;
    while (a != b) {
      if (a > b) {
        a = links.get(a).parent();
      } else {
        b = links.get(b).parent();
      }
    }
    return a;
  }

  /**
   * Returns the place of a link from an ancestor's origin, in the ancestor's axes.
   *
   * @throws java.util.NoSuchElementException if vectors are transformed from link to link
   */
  public LinkPlaces.Place place(int ancestor, int index) {
    return places.orElseThrow().of(ancestor, index);
  }

  /** Returns a link's point at {@code r} from the ancestor's origin, in the ancestor's axes. */
  public ScalarVector pointFrom(int ancestor, int index, ScalarVector r) {
    if (places.isPresent()) {
      LinkPlaces.Place place = places.get().of(ancestor, index);
      return place.origin().plus(place.axes().times(r));
    }
    ScalarVector point = r;
    for (int i = index; i != ancestor; i = links.get(i).parent()) {
      point = origin(links.get(i)).plus(toParent(links.get(i), point));
    }
    return point;
  }

  /** Returns ancestor components of a vector given in link components. */
  public ScalarVector toAncestor(int ancestor, int index, ScalarVector v) {
    if (places.isPresent()) {
      return places.get().of(ancestor, index).axes().times(v);
    }
    ScalarVector vector = v;
    for (int i = index; i != ancestor; i = links.get(i).parent()) {
      vector = toParent(links.get(i), vector);
    }
    return vector;
  }

  /** Returns link components of a vector given in ancestor components. */
  public ScalarVector fromAncestor(int ancestor, int index, ScalarVector v) {
    if (places.isPresent()) {
      return places.get().of(ancestor, index).axes().transposed().times(v);
    }
    if (index == ancestor) {
      return v;
    }
    Link link = links.get(index);
    return toLink(link, fromAncestor(ancestor, link.parent(), v));
  }

  private ScalarMatrix rootAxes() {
    Rotation orientation = mechanism.mechanism().root().orientation();
    double[][] elements = Axes.elements(orientation);
    return ScalarMatrix.of((i, j) -> expressions.constant(elements[i][j]));
  }

  /** Returns world components of a vector given in link (root) components. */
  public ScalarVector toWorld(int index, ScalarVector v) {
    return rootAxes().times(toAncestor(Links.ROOT, index, v));
  }

  /** Returns link (root) components of a vector given in world components. */
  public ScalarVector fromWorld(int index, ScalarVector v) {
    return fromAncestor(Links.ROOT, index, rootAxes().transposed().times(v));
  }

  /** Returns the position of a link's (the root's) point in the world. */
  public ScalarVector placeInWorld(int index, ScalarVector r) {
    ScalarVector inRoot = pointFrom(Links.ROOT, index, r);
    ScalarVector root = ScalarVector.of(expressions, mechanism.mechanism().root().position());
    return root.plus(rootAxes().times(inRoot));
  }
}
