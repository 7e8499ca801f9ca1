package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Prismatic;
import org.mechservice.solver.mechanism.Revolute;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.standalone.ShortestDecimal;

/**
 * What a mechanism is: its tree, its degrees of freedom, the roadmap of its state, and what looks
 * odd in it.
 *
 * @param mechanism the mechanism
 * @param roadmap joints in state order
 * @param massless names of the bodies without mass and inertia
 * @param findings what looks odd, outwards from the root
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
    return new SceneAnalysis(mechanism, roadmap, massless, Findings.of(mechanism));
  }

  private static RoadmapEntry entry(Mechanism mechanism, int index) {
    Joint joint = mechanism.joints().get(index);
    Vector3 axis = axisOf(joint);
    return new RoadmapEntry(
        joint.name(),
        joint.type(),
        ShortestDecimal.format(axis.x())
            + " "
            + ShortestDecimal.format(axis.y())
            + " "
            + ShortestDecimal.format(axis.z()),
        joint.type().positionUnit(0),
        joint.type().velocityUnit(0),
        mechanism.positionOffset(index),
        mechanism.velocityOffset(index));
  }

  private static Vector3 axisOf(Joint joint) {
    if (joint instanceof Revolute revolute) {
      return revolute.axis();
    }
    return ((Prismatic) joint).axis();
  }

  /** Returns the number of degrees of freedom; a tree has one for each velocity. */
  public int degreesOfFreedom() {
    return mechanism.velocityCount();
  }

  /** Returns the mass of all moving bodies, kg. */
  public double mass() {
    return mechanism.bodies().stream().mapToDouble(Body::mass).sum();
  }
}
