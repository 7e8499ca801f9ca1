package org.mechservice.solver.closure.model;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.LoopProjection;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * DSR with closed loops by penalty: all of [q; v] is state, the augmented Lagrangian of index 1
 * gives the accelerations,
 *
 * <pre>
 * (M + Jᵀ α J) a = τ − b − Jᵀ (α c + λ),   c = γ + 2 Ω μ Φ' + Ω² Φ,   λ ← λ + α (J a + c)
 * </pre>
 *
 * <p>iterated until J a + c is round-off. Every step ends with a projection of positions and
 * velocities onto the loops in the metric of M (docs/theory/loops.md#penalty). Redundant equations
 * are permitted, and no choice of coordinates is needed.
 */
public class PenaltyModel extends LoopModel implements ProjectedStates, ModelState {
  final PenaltySettings settings;
  final LoopProjection projection;
  private final SingularityMonitor watch;
  private final Partition partition;

  /**
   * Whether drives alone move the mechanism: the determinant of the equations then keeps its sign,
   * which is that at the last accepted state.
   */
  private final boolean determined;

  private int orientation;
  private final double[] right;
  private final double[] offset;

  /**
   * Makes a model of a mechanism whose loops are closed.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the loops are not closed at the start
   */
  public PenaltyModel(
      ClosedMechanism closed, UserForceSource userForces, PenaltySettings settings) {
    super(closed, userForces);
    this.settings = settings;
    projection = new LoopProjection(work, settings);
    partition =
        Partition.of(work.loops.jacobian, work.nv, closed.start().rank(), work.loops.isLarge());
    String formulation = closed.description().formulation();
    SingularityMonitor.Method method = new SingularityMonitor.Method(formulation, true);
    watch = new SingularityMonitor(work.loops, partition, method, this::note);
    determined = movedByTime && closed.freedom() == 0 && work.loops.isHolonomic();
    right = new double[work.nv];
    offset = new double[work.loops.count()];
    note(new Note(MessageCode.PENALTY_SETTINGS, closed.start().time(), false, settings.text()));
    beginWatch(closed.start().time(), closed.start().state());
  }

  private void beginWatch(double t, double[] y) {
    work.place(t, y);
    double[] rows = new double[work.loops.count()];
    Arrays.setAll(rows, row -> 1 / work.loops.size(row));
    partition.scale(rows, work.units.velocities);
    partition.choose(work.loops.jacobian);
    watch.begin(t);
    orient();
  }

  @Override
  public final int derivative(double t, double[] y, double[] yDot) {
    work.placeEquations(t, y);
    if (!work.formBias(t)) {
      return fail(work.forces.defect());
    }
    int singular = projection.factor();
    if (singular >= 0) {
      return closed.jointOfVelocity(singular);
    }
    for (int j = 0; j < right.length; j++) {
      right[j] = -work.bias()[j];
    }
    double omega = settings.frequency();
    for (int row = 0; row < offset.length; row++) {
      double residual =
          work.loops.acceleration[row]
              + 2 * omega * settings.damping() * work.loops.rate[row]
              + omega * omega * work.loops.value[row];
      offset[row] = residual / work.loops.size(row);
    }
    work.coordinates.rates(y, 0, y, work.nq, yDot, 0);
    projection.equations().solve(right, offset, yDot, work.nq);
    work.furtherRates(t, yDot, work.furtherAt);
    return REGULAR;
  }

  @Override
  public final boolean project(double t, double[] y) {
    boolean done = !watch.stallsAtSingularity() && moveOntoLoops(t, y) && isSameAssembly(t, y);
    watch.tried(done);
    return done;
  }

  private boolean moveOntoLoops(double t, double[] y) {
    boolean far = movedByTime && !watch.isNearSingular();
    return far ? projection.projectFarFromSingular(t, y) : projection.project(t, y);
  }

  private void orient() {
    if (determined && partition.factor(work.loops.jacobian)) {
      orientation = partition.orientation();
    }
  }

  private boolean isSameAssembly(double t, double[] y) {
    if (!determined) {
      return true;
    }
    work.place(t, y);
    return partition.factor(work.loops.jacobian) && partition.orientation() == orientation;
  }

  @Override
  public final boolean projectError(double t, double[] y, double[] error) {
    return projection.projectChange(t, y, error);
  }

  @Override
  public final void accepted(double t, double[] y) {
    work.place(t, y);
    partition.choose(work.loops.jacobian);
    orient();
    watch.accepted(t);
    work.accepted(t);
  }

  @Override
  final void jumped(double t, double[] y, boolean closed) {
    partition.choose(work.loops.jacobian);
    orient();
    watch.jumped(t, closed);
  }

  @Override
  public final Optional<Defect> obstacle() {
    return watch.obstacle();
  }

  @Override
  public final int stateLength() {
    return work.stateLength() + watch.stateLength() + 1;
  }

  @Override
  public final void saveState(double[] state) {
    work.save(state, 0);
    watch.save(state, work.stateLength());
    state[stateLength() - 1] = orientation;
  }

  @Override
  public final void restoreState(double[] state) {
    work.restore(state, 0);
    watch.restore(state, work.stateLength());
    orientation = (int) state[stateLength() - 1];
  }
}
