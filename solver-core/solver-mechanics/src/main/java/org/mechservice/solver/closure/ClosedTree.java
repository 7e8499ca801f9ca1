package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.dynamics.SemiRecursive;
import org.mechservice.solver.dynamics.WorldMotion;
import org.mechservice.solver.dynamics.derivative.ArticulatedIteration;
import org.mechservice.solver.dynamics.derivative.FurtherDerivatives;
import org.mechservice.solver.dynamics.derivative.StepDerivatives;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.formula.FurtherRates;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The equations of a mechanism with loops, M v' + b + Jᵀ λ = τ and Φ(q, t) = 0, at one state at a
 * time. Workspace of one thread; nothing allocates after construction.
 */
public class ClosedTree {
  public final TreeGeometry tree;
  public final TreeMotion motion;
  public final LoopEquations loops;
  public final StateCoordinates coordinates;
  public final CoordinateUnits units;
  public final MassiveRods rods;
  final SemiRecursive open;
  public final ForceSet forces;
  private final FurtherRates furtherRates;
  final WorldMotion world;
  public final int nq;
  public final int nv;

  /** Length of the state [q; v; s]. */
  public final int stateCount;

  /** Index of the first further state in it. */
  public final int furtherAt;

  /** M including the rods, n × n row by row; formed on first use. */
  private double[] mass = new double[0];

  /** Applied wrenches, 6 per link, and joint forces, one per extended velocity. */
  final double[] wrench;

  final double[] tau;

  /** The applied wrenches plus those of the loops. */
  private final double[] loaded;

  private final double[] noAcceleration;

  ClosedTree(TreeGeometry tree, UserForceSource userForces) {
    this.tree = tree;
    motion = new TreeMotion(tree);
    loops = new LoopEquations(tree);
    coordinates = new StateCoordinates(tree.mechanism());
    units = new CoordinateUnits(tree.mechanism(), loops.length());
    rods = new MassiveRods(tree);
    open = new SemiRecursive(motion);
    forces = new ForceSet(motion, userForces);
    furtherRates = new FurtherRates(motion);
    world = new WorldMotion(motion);
    nq = tree.statePositionCount;
    nv = tree.stateVelocityCount;
    furtherAt = nq + nv;
    stateCount = furtherAt + furtherRates.count();
    wrench = new double[6 * tree.linkCount];
    tau = new double[tree.velocityCount];
    loaded = new double[wrench.length];
    noAcceleration = new double[nv];
  }

  /**
   * Returns the data-driven workspace of the same equations, which has the motions and forces of
   * links.
   */
  public ClosedTree ofData() {
    return this;
  }

  /** Places a state and evaluates Φ and J. */
  public void placeLoops(double t, double[] y) {
    motion.sweep(t, y);
    loops.place(motion, t);
    loops.differentiate(motion);
  }

  /** Places a state and evaluates Φ and Φ'. */
  public void placeRates(double t, double[] y) {
    motion.sweep(t, y);
    loops.place(motion, t);
    loops.move(motion, t);
  }

  /** Places a state and evaluates Φ, J and Φ'. */
  public void place(double t, double[] y) {
    placeData(t, y);
  }

  /** As {@link #place}, always evaluated from the data. */
  public final void placeData(double t, double[] y) {
    motion.sweep(t, y);
    loops.place(motion, t);
    loops.differentiate(motion);
    loops.move(motion, t);
  }

  /** Places a state before its equations of motion are formed, and evaluates Φ, J and Φ'. */
  public void placeEquations(double t, double[] y) {
    place(t, y);
  }

  /**
   * Places the links alone, always from the data: {@link #motion} then belongs to this state, which
   * after {@link #place} it need not if code evaluates the equations.
   */
  public final void placeLinks(double t, double[] y) {
    motion.sweep(t, y);
  }

  /**
   * Writes the accelerations at a state that closes the loops, if generated code evaluates them
   * there. The equations must all be independent. Nothing is placed.
   *
   * @param a one number per velocity from {@code at}; overwritten
   * @return whether there are such code and values
   */
  public boolean accelerations(double t, double[] y, double[] a, int at) {
    return false;
  }

  /** Forms M at the state last placed. */
  public void formMass() {
    open.formMassMatrix();
    open.massMatrix().toDense(mass());
  }

  /** Returns M including the rods as last formed, n × n row by row. */
  public final double[] mass() {
    if (mass.length < nv * nv) {
      mass = new double[nv * nv];
    }
    return mass;
  }

  /** Returns whether accelerations are solved for with sparse matrices. */
  public boolean isLarge() {
    return loops.isLarge() && rods.areLight();
  }

  /**
   * Returns whether the derivatives of all forces and loops are by the nearest links and
   * coordinates alone.
   */
  public boolean isLocal() {
    return rods.isEmpty() && forces.isLocal() && loops.isLocal();
  }

  /** Returns whether the equations of an implicit step are best kept by links. */
  public boolean isEliminatedByLinks() {
    return isLarge()
        && rods.isEmpty()
        && (hasFewLocalLoops()
            ? ArticulatedIteration.pays(tree)
            : ArticulatedIteration.paysFarCouplings(tree));
  }

  /** Returns whether they can be eliminated from link to link, with the loops beside them. */
  public boolean hasFewLocalLoops() {
    return isLocal() && loops.count() <= LoopEquations.FEW;
  }

  /** Evaluates the applied forces at the last sweep; returns whether all have values. */
  final boolean applyForces(double t) {
    Arrays.fill(wrench, 0);
    Arrays.fill(tau, 0);
    return forces.apply(t, wrench, tau) == ForceSet.REGULAR;
  }

  /**
   * Records that the step to the last placed state was accepted: angles of cut joints are unwrapped
   * from here.
   */
  public void accepted(double t) {
    loops.accepted();
    if (applyForces(t)) {
      forces.accepted();
    }
    if (furtherCount() > 0) {
      furtherRates.accepted(t);
    }
  }

  /**
   * Returns the links that forces, loops and rods couple, two by two, for the pattern of matrices.
   */
  public int[] coupledLinks() {
    List<Integer> links = new ArrayList<>();
    forces.couplings(
        (on, by) -> {
          links.add(on);
          links.add(by);
        });
    loops.couplings(
        (on, by) -> {
          links.add(on);
          links.add(by);
        });
    for (int link : rods.pairs()) {
      links.add(link);
    }
    return links.stream().mapToInt(Integer::intValue).toArray();
  }

  /** Returns the length of what {@link #save} writes. */
  public int stateLength() {
    return motion.counted.count() + loops.counted.count();
  }

  /** Writes the unwrapped angles of cut joints at the last accepted step. */
  public void save(double[] state, int at) {
    motion.counted.save(state, at);
    loops.counted.save(state, at + motion.counted.count());
  }

  /** Restores what {@link #save} wrote. */
  public void restore(double[] state, int at) {
    motion.counted.restore(state, at);
    loops.counted.restore(state, at + motion.counted.count());
  }

  /** Forms b − τ and γ after {@link #placeEquations}; returns whether all forces have values. */
  public boolean formBias(double t) {
    if (!applyForces(t)) {
      return false;
    }
    open.formBias(wrench, tau);
    loops.accelerate(motion, t);
    return true;
  }

  /** Returns b − τ as formed last. */
  public double[] bias() {
    return open.bias();
  }

  /** Evaluates γ alone after {@link #place}. */
  public void formGamma(double t) {
    formDataGamma(t);
  }

  /** As {@link #formGamma}, from the data, after {@link #placeData}. */
  final void formDataGamma(double t) {
    motion.accelerationSweep(noAcceleration);
    loops.accelerate(motion, t);
  }

  /**
   * Evaluates M v' + b − τ for accelerations that begin at {@code aAt}, after {@link #place}.
   *
   * @param residual one number per extended velocity; overwritten; entries of driven joints are the
   *     driving forces
   * @return whether all forces have values
   */
  public boolean formResidual(double t, double[] a, int aAt, double[] residual) {
    if (!applyForces(t)) {
      return false;
    }
    open.formResidual(wrench, tau, a, aAt, residual);
    return true;
  }

  /** Returns the number of further states. */
  public final int furtherCount() {
    return stateCount - furtherAt;
  }

  /**
   * Writes the derivatives of the further states at the state last placed.
   *
   * @param rates one number per further state from {@code at}; overwritten
   */
  public void furtherRates(double t, double[] rates, int at) {
    furtherRates.evaluate(t, rates, at);
  }

  /**
   * Evaluates what the further states add to the derivatives, after {@link #linearise} at the same
   * state or on its own. The state is placed afterwards.
   */
  public void lineariseFurther(double t, double[] y, FurtherDerivatives further) {
    if (further.count() > 0) {
      placeData(t, y);
      applyForces(t);
      further.evaluate(motion, forces, furtherRates, coordinates, t, y);
      place(t, y);
    }
  }

  /** Writes kinetic and potential energy at a state, J. */
  public void energy(double t, double[] y, double[] energy) {
    motion.sweep(t, y);
    applyForces(t);
    energy[0] = world.kineticEnergy() + rods.kineticEnergy(motion);
    energy[1] = world.potentialEnergy() + rods.potentialEnergy(motion) + forces.potentialEnergy();
  }

  /** Writes poses and velocities of the bodies at a state ({@code BodyPoses}). */
  public void poses(double t, double[] y, double[] poses) {
    motion.sweep(t, y);
    world.poses(poses);
  }

  /**
   * Writes the power of all forces without potential energy at a state, and the sum of the absolute
   * values, W.
   */
  public void power(double t, double[] y, double[] power) {
    motion.sweep(t, y);
    applyForces(t);
    power[0] = forces.power();
    power[1] = forces.turnover();
  }

  /**
   * Evaluates the derivatives of M v' + b − τ + Jᵀ λ by v', v and q at the state of the last {@link
   * #formResidual}, for the same accelerations.
   *
   * @param a accelerations that begin at {@code aAt}; not modified
   * @param lambda multipliers, one per equation; not modified
   * @param jacobian of this tree; overwritten
   * @return whether all forces have values
   */
  public boolean linearise(
      double t, double[] a, int aAt, double[] lambda, StepDerivatives jacobian) {
    System.arraycopy(wrench, 0, loaded, 0, loaded.length);
    loops.addForces(lambda, -1, loaded, tau);
    jacobian.evaluate(loaded);
    if (forces.linearise(t, jacobian.forces()) != ForceSet.REGULAR) {
      return false;
    }
    loops.linearise(lambda, -1, jacobian.forces());
    jacobian.finish();
    return true;
  }
}
