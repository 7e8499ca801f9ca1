package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.AlgebraicModel;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.dynamics.WorldMotion;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;

/** Common base of the models that compute each state without integration. Workspace of one run. */
abstract class AnalysisModel implements AlgebraicModel, Energies, BodyPoses, RunNotes {
  final Mechanism mechanism;
  final EquationsOfMotion equations;

  /** v' of the state found last. */
  final double[] acceleration;

  private final ModelDescription description;
  private final WorldMotion world;
  private final MassiveRods rods;
  private Optional<Defect> defect = Optional.empty();

  /**
   * @param data the model; its formulation is the name of the task
   */
  AnalysisModel(CompactModel data, UserForceSource userForces) {
    mechanism = data.mechanism();
    equations = new EquationsOfMotion(mechanism, userForces);
    acceleration = new double[equations.nv];
    description = description(data);
    world = new WorldMotion(equations.motion);
    rods = new MassiveRods(equations.tree);
  }

  /** Describes a model by its data. */
  static ModelDescription description(CompactModel data) {
    List<JointVariables> joints = new ArrayList<>();
    Mechanism mechanism = data.mechanism();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (!mechanism.isDriven(j)) {
        joints.add(
            new JointVariables(mechanism.joints().get(j).name(), mechanism.joints().get(j).type()));
      }
    }
    return new ModelDescription(
        mechanism.name(), data.formulation(), joints, mechanism.stateVariables(), data.settings());
  }

  @Override
  public final ModelDescription description() {
    return description;
  }

  @Override
  public final void initialState(double[] y) {
    mechanism.initialState(y);
  }

  @Override
  public final int derivative(double t, double[] y, double[] yDot) {
    equations.coordinates.rates(y, 0, y, equations.nq, yDot, 0);
    System.arraycopy(acceleration, 0, yDot, equations.nq, acceleration.length);
    return REGULAR;
  }

  /** Stores why no state was found; returns the result of {@link #find}. */
  final int fail(Defect why) {
    defect = Optional.of(why);
    return DEFECT;
  }

  @Override
  public final Defect lastDefect() {
    return defect.orElseThrow(() -> new IllegalStateException("all states were found"));
  }

  @Override
  public final void energy(double t, double[] y, double[] energy) {
    equations.place(t, y);
    double ofForces = equations.applyForces(t) ? equations.forces.potentialEnergy() : Double.NaN;
    energy[0] = world.kineticEnergy() + rods.kineticEnergy(equations.motion);
    energy[1] = world.potentialEnergy() + rods.potentialEnergy(equations.motion) + ofForces;
  }

  @Override
  public final List<String> bodies() {
    return mechanism.bodies().stream().map(Body::name).toList();
  }

  @Override
  public final void poses(double t, double[] y, double[] poses) {
    equations.place(t, y);
    world.poses(poses);
  }
}
