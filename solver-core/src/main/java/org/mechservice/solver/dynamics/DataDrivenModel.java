package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.BodyPoses;
import org.mechservice.solver.api.Energies;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A mechanism as a model without generated code, by articulated bodies (DTR): the reference that
 * generated classes are tested against. Open chains.
 */
public final class DataDrivenModel implements ExplicitModel, Energies, BodyPoses {
  private static final double[] NO_WRENCHES = {};

  private final Mechanism mechanism;
  private final ModelDescription description;
  private final StateCoordinates coordinates;
  private final TreeMotion motion;
  private final ArticulatedBody dynamics;
  private final ArticulatedBody.Workspace workspace;
  private final WorldMotion world;
  private final double[] tau;

  /** For each velocity the index of its joint among the joints that have states. */
  private final int[] jointOfVelocity;

  /**
   * @param mechanism an open chain
   * @param defaults settings the model carries
   */
  public DataDrivenModel(Mechanism mechanism, RunSettings defaults) {
    this.mechanism = mechanism;
    List<JointVariables> joints = new ArrayList<>();
    jointOfVelocity = new int[mechanism.velocityCount()];
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (!mechanism.isDriven(j)) {
        Joint joint = mechanism.joints().get(j);
        int at = mechanism.velocityOffset(j);
        Arrays.fill(jointOfVelocity, at, at + joint.type().velocityCount(), joints.size());
        joints.add(new JointVariables(joint.name(), joint.type()));
      }
    }
    description = new ModelDescription(mechanism.name(), "DTR", joints, defaults);
    TreeGeometry tree = new TreeGeometry(mechanism);
    coordinates = new StateCoordinates(mechanism);
    motion = new TreeMotion(tree);
    dynamics = new ArticulatedBody(tree);
    workspace = dynamics.newWorkspace(motion);
    world = new WorldMotion(motion);
    tau = new double[tree.velocityCount];
  }

  @Override
  public ModelDescription description() {
    return description;
  }

  @Override
  public void initialState(double[] y) {
    mechanism.initialState(y);
  }

  @Override
  public int derivative(double t, double[] y, double[] yDot) {
    int n = coordinates.positionCount();
    coordinates.rates(y, 0, y, n, yDot, 0);
    motion.sweepRelative(t, y);
    int singular = dynamics.accelerations(workspace, NO_WRENCHES, tau, yDot, n);
    return singular == REGULAR ? REGULAR : jointOfVelocity[singular];
  }

  @Override
  public void energy(double t, double[] y, double[] energy) {
    motion.sweep(t, y);
    energy[0] = world.kineticEnergy();
    energy[1] = world.potentialEnergy();
  }

  @Override
  public List<String> bodies() {
    return mechanism.bodies().stream().map(Body::name).toList();
  }

  @Override
  public void poses(double t, double[] y, double[] poses) {
    motion.sweep(t, y);
    world.poses(poses);
  }
}
