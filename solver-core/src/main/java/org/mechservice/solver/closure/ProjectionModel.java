package org.mechservice.solver.closure;

import org.mechservice.solver.api.DependentStates;
import org.mechservice.solver.force.UserForceSource;

/**
 * DSR with closed loops by the second velocity transformation: the state [q; v] of the open tree,
 * of which as many coordinates are independent as there are degrees of freedom (NUMERICS §3).
 */
public final class ProjectionModel extends LoopModel implements DependentStates {
  private final Completion completion;
  private final ProjectedMotion projected;

  /**
   * Makes a model of a mechanism whose loops are closed.
   *
   * @param userForces makes the forces that users have written
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  public ProjectionModel(ClosedMechanism closed, UserForceSource userForces) {
    super(closed, userForces);
    completion =
        new Completion(work.motion, work.loops, work.coordinates, work.units, closed.rank());
    projected = new ProjectedMotion(work.nv, completion.ofVelocities());
    if (!completion.begin(closed.startTime(), closed.start())) {
      throw new IllegalStateException("the loops have fewer independent equations than counted");
    }
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
    boolean other = completion.accepted(t, y);
    work.accepted(t);
    return other;
  }

  @Override
  public int derivative(double t, double[] y, double[] yDot) {
    work.place(t, y);
    Partition partition = completion.ofVelocities();
    if (!partition.factor(work.loops.jacobian, work.loops.width())) {
      return closed.jointOfVelocity(partition.dependent[0]);
    }
    projected.formTransformation(work.loops.jacobian, work.loops.width());
    work.formMass();
    if (!work.formBias(t)) {
      return fail(work.forces.defect());
    }
    int singular = projected.reduce(work.mass);
    if (singular != ProjectedMotion.REGULAR) {
      return closed.jointOfVelocity(singular);
    }
    work.coordinates.rates(y, 0, y, work.nq, yDot, 0);
    projected.accelerations(work.mass, work.open.bias(), work.loops.acceleration, yDot, work.nq);
    return REGULAR;
  }
}
