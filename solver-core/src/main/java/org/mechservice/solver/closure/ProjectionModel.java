package org.mechservice.solver.closure;

import org.mechservice.solver.api.DependentStates;
import org.mechservice.solver.force.UserForceSource;

/**
 * DSR with closed loops by the second velocity transformation: the state [q; v] of the open tree,
 * of which as many coordinates are independent as there are degrees of freedom (NUMERICS §3).
 */
public class ProjectionModel extends LoopModel implements DependentStates {
  final Completion completion;
  final ProjectedMotion projected;

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
  public final boolean independent(int component) {
    return completion.independent(component);
  }

  @Override
  public final boolean complete(double t, double[] y) {
    return completion.complete(t, y);
  }

  @Override
  public final boolean accepted(double t, double[] y) {
    boolean other = completion.accepted(t, y);
    work.accepted(t);
    return other;
  }

  /** Places a state, forms R and evaluates the forces. */
  final int begin(double t, double[] y) {
    work.place(t, y);
    Partition partition = completion.ofVelocities();
    if (!partition.factor(work.loops.jacobian, work.loops.width())) {
      return closed.jointOfVelocity(partition.dependent[0]);
    }
    projected.formTransformation(work.loops.jacobian, work.loops.width());
    return work.applyForces(t) ? REGULAR : fail(work.forces.defect());
  }

  @Override
  public final int derivative(double t, double[] y, double[] yDot) {
    int begun = begin(t, y);
    if (begun != REGULAR) {
      return begun;
    }
    work.formMass();
    work.formBias(t);
    int singular = projected.reduce(work.mass);
    if (singular != ProjectedMotion.REGULAR) {
      return closed.jointOfVelocity(singular);
    }
    work.coordinates.rates(y, 0, y, work.nq, yDot, 0);
    projected.accelerations(work.mass, work.open.bias(), work.loops.acceleration, yDot, work.nq);
    return REGULAR;
  }
}
