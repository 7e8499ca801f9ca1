package org.mechservice.solver.closure;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.BodyPoses;
import org.mechservice.solver.api.DependentStates;
import org.mechservice.solver.api.Energies;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.dynamics.WorldMotion;
import org.mechservice.solver.mechanism.Body;

/**
 * DSR with closed loops by the second velocity transformation: the state [q; v] of the open tree,
 * of which as many coordinates are independent as there are degrees of freedom (NUMERICS §3).
 */
public final class ProjectionModel implements ExplicitModel, DependentStates, Energies, BodyPoses {
  private final ClosedMechanism closed;
  private final ClosedTree work;
  private final Completion completion;
  private final ProjectedMotion projected;
  private final WorldMotion world;

  /** Makes a model. */
  public ProjectionModel(ClosedMechanism closed) {
    this.closed = closed;
    work = new ClosedTree(closed.tree());
    completion =
        new Completion(work.motion, work.loops, work.coordinates, work.units, closed.rank());
    projected = new ProjectedMotion(work.nv, completion.ofVelocities());
    world = new WorldMotion(work.motion);
    if (!completion.begin(closed.startTime(), closed.start())) {
      throw new IllegalStateException("the loops have fewer independent equations than counted");
    }
  }

  @Override
  public ModelDescription description() {
    return closed.description();
  }

  @Override
  public void initialState(double[] y) {
    System.arraycopy(closed.start(), 0, y, 0, y.length);
  }

  @Override
  public boolean independent(int component) {
    return completion.independent(component);
  }

  @Override
  public boolean complete(double t, double[] y) {
    return completion.complete(t, y);
  }

  @Override
  public boolean accepted(double t, double[] y) {
    return completion.accepted(t, y);
  }

  @Override
  public int derivative(double t, double[] y, double[] yDot) {
    work.place(t, y);
    if (!completion.ofVelocities().factor(work.loops.jacobian, work.loops.width())) {
      Arrays.fill(yDot, Double.NaN);
      return REGULAR;
    }
    projected.formTransformation(work.loops.jacobian, work.loops.width());
    work.formMass();
    double[] bias = work.formBias(t);
    int singular = projected.reduce(work.mass);
    if (singular != ProjectedMotion.REGULAR) {
      return closed.jointOfVelocity(singular);
    }
    work.coordinates.rates(y, 0, y, work.nq, yDot, 0);
    projected.accelerations(work.mass, bias, work.loops.acceleration, yDot, work.nq);
    return REGULAR;
  }

  @Override
  public void energy(double t, double[] y, double[] energy) {
    work.motion.sweep(t, y);
    energy[0] = world.kineticEnergy() + work.rods.kineticEnergy(work.motion);
    energy[1] = world.potentialEnergy() + work.rods.potentialEnergy(work.motion);
  }

  @Override
  public List<String> bodies() {
    return work.tree.mechanism().bodies().stream().map(Body::name).toList();
  }

  @Override
  public void poses(double t, double[] y, double[] poses) {
    work.motion.sweep(t, y);
    world.poses(poses);
  }
}
