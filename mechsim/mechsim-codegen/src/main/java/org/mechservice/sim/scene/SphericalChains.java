package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.Vector3;

/**
 * Finds chains that are equivalent to a spherical joint: three revolute joints through one point
 * with two massless bodies between them.
 *
 * <pre>
 *   inner --R-- massless --R-- massless --R-- outer
 * </pre>
 */
final class SphericalChains {
  /** Distance below which points coincide, relative to their position or to 1 m. */
  private static final double SAME_POINT = 1e-9;

  /** Sine of the smallest angle between consecutive axes. */
  private static final double LEAST_ANGLE = 1e-6;

  private final Mechanism mechanism;
  private final boolean[] heldOn;

  private SphericalChains(Mechanism mechanism) {
    this.mechanism = mechanism;
    heldOn = heldOn(mechanism);
  }

  /** Returns suggestions: the gain of one joint instead of three, and the necessary changes. */
  static List<String> of(Mechanism mechanism) {
    SphericalChains chains = new SphericalChains(mechanism);
    List<String> found = new ArrayList<>();
    for (int first : mechanism.outward()) {
      chains
          .next(first)
          .flatMap(second -> chains.next(second).map(third -> List.of(first, second, third)))
          .map(chains::text)
          .ifPresent(found::add);
    }
    return found;
  }

  /** Marks the bodies to which something besides joints is attached. */
  private static boolean[] heldOn(Mechanism mechanism) {
    boolean[] held = new boolean[mechanism.bodies().size()];
    for (LoopClosure closure : mechanism.closures()) {
      LoopPaths.indices(closure).forEach(body -> mark(held, body));
    }
    for (ForceElement force : mechanism.forces()) {
      force.bodies().forEach(body -> mark(held, body));
    }
    return held;
  }

  private static void mark(boolean[] held, int body) {
    if (body != Mechanism.ROOT) {
      held[body] = true;
    }
  }

  /** Returns the next revolute joint through the same point beyond a massless body. */
  private Optional<Integer> next(int index) {
    int middle = mechanism.joints().get(index).attachment().child();
    if (!mechanism.bodies().get(middle).isMassless() || heldOn[middle]) {
      return Optional.empty();
    }
    List<Integer> beyond =
        Arrays.stream(mechanism.outward())
            .filter(j -> mechanism.joints().get(j).attachment().parent() == middle)
            .boxed()
            .toList();
    return beyond.size() == 1 && meet(index, beyond.get(0))
        ? Optional.of(beyond.get(0))
        : Optional.empty();
  }

  private boolean meet(int index, int other) {
    if (isMoreThanJoint(index) || isMoreThanJoint(other)) {
      return false;
    }
    Joint inner = mechanism.joints().get(index);
    Joint outer = mechanism.joints().get(other);
    if (!(inner instanceof Revolute first) || !(outer instanceof Revolute second)) {
      return false;
    }
    Vector3 point = inner.attachment().childPoint();
    double apart = point.minus(outer.attachment().parentPoint()).norm();
    Vector3 axis = inner.attachment().zeroRotation().transposed().apply(first.axis());
    return apart <= SAME_POINT * Math.max(1, point.norm())
        && axis.cross(second.axis()).norm() > LEAST_ANGLE;
  }

  /** Returns whether something follows or resists the angle itself. */
  private boolean isMoreThanJoint(int joint) {
    return mechanism.isDriven(joint) || mechanism.isWhollyArmed(joint);
  }

  private String text(List<Integer> chain) {
    String joints =
        chain.stream()
            .map(j -> quoted(mechanism.joints().get(j).name()))
            .collect(Collectors.joining(", "));
    String bodies =
        chain.stream()
            .limit(2)
            .map(j -> mechanism.joints().get(j).attachment().child())
            .map(b -> quoted(mechanism.bodies().get(b).name()))
            .collect(Collectors.joining(" and "));
    String text =
        "joints "
            + joints
            + " turn about one point with massless bodies "
            + bodies
            + " between them: one joint of type S moves alike, needs neither body, and has no"
            + " position in which axes coincide; four Euler parameters take the place of three"
            + " angles";
    List<String> forces = forcesOn(chain);
    if (!forces.isEmpty()) {
      text +=
          ". What acts on the angles ("
              + String.join(", ", forces)
              + ") would have to become a bushing or a torque between the bodies";
    }
    return mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance)
        ? text + "; classes that act on the angles would have to be changed"
        : text;
  }

  private List<String> forcesOn(List<Integer> chain) {
    return mechanism.forces().stream()
        .filter(force -> actsOn(force, chain))
        .map(force -> quoted(force.name()))
        .toList();
  }

  private static boolean actsOn(ForceElement force, List<Integer> chain) {
    return force
        .jointCoordinate()
        .filter(JointCoordinate.class::isInstance)
        .map(c -> chain.contains(((JointCoordinate) c).joint()))
        .orElse(false);
  }

  private static String quoted(String name) {
    return "\"" + name + "\"";
  }
}
