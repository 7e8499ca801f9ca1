package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * The structure of a mechanism: its tree, its degrees of freedom, the layout of its state, and
 * suspicious data.
 *
 * @param mechanism the mechanism
 * @param roadmap joints in state order
 * @param massless names of the bodies without mass and inertia
 * @param findings suspicious data, outwards from the root
 */
public record SceneAnalysis(
    Mechanism mechanism,
    List<RoadmapEntry> roadmap,
    List<String> massless,
    List<Finding> findings) {

  public SceneAnalysis {
    roadmap = List.copyOf(roadmap);
    massless = List.copyOf(massless);
    findings = List.copyOf(findings);
  }

  /** Analyses a mechanism. */
  public static SceneAnalysis of(Mechanism mechanism) {
    List<RoadmapEntry> roadmap = new ArrayList<>();
    for (int i = 0; i < mechanism.joints().size(); i++) {
      roadmap.add(entry(mechanism, i));
    }
    List<String> massless =
        mechanism.bodies().stream().filter(Body::isMassless).map(Body::name).toList();
    return new SceneAnalysis(mechanism, roadmap, massless, MasslessJointCheck.of(mechanism));
  }

  private static RoadmapEntry entry(Mechanism mechanism, int index) {
    Joint joint = mechanism.joints().get(index);
    JointType type = joint.type();
    return new RoadmapEntry(
        joint.name(),
        type,
        axisOf(joint),
        units(type.positionCount(), type::positionUnit),
        units(type.velocityCount(), type::velocityUnit),
        mechanism.isDriven(index),
        mechanism.positionOffset(index),
        mechanism.velocityOffset(index));
  }

  /** Returns name and kind of every force, such as {@code strut (spring between points)}. */
  public List<String> forces() {
    return mechanism.forces().stream()
        .map(force -> force.name() + " (" + force.kind() + ")")
        .toList();
  }

  /** Returns the components of a joint's first axis; empty if it has none. */
  private static String axisOf(Joint joint) {
    return joint.axes().isEmpty() ? "" : text(joint.axes().get(0));
  }

  private static String text(Vector3 axis) {
    return ShortestDecimal.format(axis.x())
        + " "
        + ShortestDecimal.format(axis.y())
        + " "
        + ShortestDecimal.format(axis.z());
  }

  private static String units(int count, IntFunction<String> unit) {
    return IntStream.range(0, count).mapToObj(unit).collect(Collectors.joining(" "));
  }

  /** Returns suggestions of simpler models, as sentences. */
  public List<String> offers() {
    return SphericalChains.of(mechanism);
  }

  /** Returns the number of degrees of freedom; a tree has one for each velocity. */
  public int degreesOfFreedom() {
    return mechanism.velocityCount();
  }

  /** Returns the mass of all moving bodies, kg. */
  public double mass() {
    return mechanism.bodies().stream().mapToDouble(Body::mass).sum();
  }

  /** Returns the mass of all rods between points, kg. */
  public double rodMass() {
    return mechanism.closures().stream()
        .filter(DistanceClosure.class::isInstance)
        .mapToDouble(closure -> ((DistanceClosure) closure).rodMass())
        .sum();
  }
}
