package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.BodyPoses;
import org.mechservice.solver.api.Energies;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A mechanism as a model without generated code, by articulated bodies (DTR): the reference that
 * generated classes are tested against. Open chains of R and P joints.
 */
public final class DataDrivenModel implements ExplicitModel, Energies, BodyPoses {
  private final Mechanism mechanism;
  private final ModelDescription description;
  private final ArticulatedBody dynamics;
  private final ArticulatedBody.Workspace workspace;
  private final WorldMotion world;
  private final double[] tau;

  /**
   * @param mechanism an open chain of R and P joints
   * @param defaults settings the model carries
   */
  public DataDrivenModel(Mechanism mechanism, RunSettings defaults) {
    this.mechanism = mechanism;
    List<JointVariables> joints = new ArrayList<>();
    for (Joint joint : mechanism.joints()) {
      joints.add(new JointVariables(joint.name(), joint.type()));
    }
    description = new ModelDescription(mechanism.name(), "DTR", joints, defaults);
    dynamics = new ArticulatedBody(mechanism);
    workspace = dynamics.newWorkspace();
    world = new WorldMotion(mechanism);
    tau = new double[mechanism.velocityCount()];
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
    int n = mechanism.velocityCount();
    System.arraycopy(y, n, yDot, 0, n);
    return dynamics.accelerations(workspace, y, tau, yDot, n);
  }

  @Override
  public void energy(double t, double[] y, double[] energy) {
    world.sweep(y);
    energy[0] = world.kineticEnergy();
    energy[1] = world.potentialEnergy();
  }

  @Override
  public List<String> bodies() {
    return mechanism.bodies().stream().map(Body::name).toList();
  }

  @Override
  public void poses(double t, double[] y, double[] poses) {
    world.sweep(y);
    world.poses(poses);
  }
}
