package org.mechservice.solver.force;

import java.util.Random;
import java.util.function.Supplier;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;

/** A mechanism with forces in a seeded state, and differences of what it does. */
public final class ForcedTree {
  private static final double STEP = 1e-3;

  final Mechanism mechanism;
  public final TreeGeometry geometry;
  final TreeMotion motion;
  public final ForceSet forces;
  public final double[] q;
  final double[] v;
  private final StateCoordinates coordinates;

  public ForcedTree(Mechanism mechanism, long seed) {
    this.mechanism = mechanism;
    geometry = new TreeGeometry(mechanism);
    motion = new TreeMotion(geometry);
    forces = new ForceSet(motion, RandomUserForces::create);
    coordinates = new StateCoordinates(mechanism);
    q = new double[mechanism.positionCount()];
    v = new double[mechanism.velocityCount()];
    double[] y = new double[q.length + v.length];
    mechanism.initialState(y);
    System.arraycopy(y, 0, q, 0, q.length);
    Random random = new Random(seed);
    for (int i = 0; i < v.length; i++) {
      v[i] = random.nextGaussian();
    }
  }

  /** Returns all wrenches, 6 per link, then all joint forces. */
  public double[] evaluate(double t) {
    motion.sweep(t, q, v);
    double[] wrench = new double[6 * geometry.linkCount];
    double[] tau = new double[geometry.velocityCount];
    int failed = forces.apply(t, wrench, tau);
    if (failed != ForceSet.REGULAR) {
      throw new AssertionError(forces.defect().toString());
    }
    double[] all = new double[wrench.length + tau.length];
    System.arraycopy(wrench, 0, all, 0, wrench.length);
    System.arraycopy(tau, 0, all, wrench.length, tau.length);
    return all;
  }

  DenseForceJacobian jacobian(double t) {
    DenseForceJacobian jacobian = new DenseForceJacobian(geometry);
    if (forces.linearise(t, jacobian) != ForceSet.REGULAR) {
      throw new AssertionError(forces.defect().toString());
    }
    return jacobian;
  }

  /** Returns all velocity twists, 6 per link, then all velocities. */
  private double[] twists(double t) {
    motion.sweep(t, q, v);
    double[] all = new double[6 * geometry.linkCount + geometry.velocityCount];
    for (int link = 0; link < geometry.linkCount; link++) {
      System.arraycopy(motion.angularVelocity, 3 * link, all, 6 * link, 3);
      System.arraycopy(motion.linearVelocity, 3 * link, all, 6 * link + 3, 3);
    }
    System.arraycopy(motion.v, 0, all, 6 * geometry.linkCount, geometry.velocityCount);
    return all;
  }

  /** Returns the change of all forces with a coordinate or its rate, by the Jacobian. */
  public double[] forceChange(double t, int k, boolean ofVelocity) {
    double[] unit = new double[v.length];
    unit[k] = 1;
    double[] kept = v.clone();
    System.arraycopy(unit, 0, v, 0, v.length);
    double[] alongUnit = twists(t);
    System.arraycopy(kept, 0, v, 0, v.length);
    double[] nothing = new double[alongUnit.length];
    if (ofVelocity) {
      evaluate(t);
      return jacobian(t).change(nothing, alongUnit);
    }
    double[] velocities = difference(() -> twists(t), k, false);
    evaluate(t);
    return jacobian(t).change(alongUnit, velocities);
  }

  public double[] forceDifference(double t, int k, boolean ofVelocity) {
    return difference(() -> evaluate(t), k, ofVelocity);
  }

  /** Central differences of two steps, extrapolated. */
  private double[] difference(Supplier<double[]> function, int k, boolean ofVelocity) {
    double[] coarse = central(function, k, ofVelocity, 2 * STEP);
    double[] fine = central(function, k, ofVelocity, STEP);
    for (int i = 0; i < fine.length; i++) {
      fine[i] += (fine[i] - coarse[i]) / 3;
    }
    double[] finer = central(function, k, ofVelocity, STEP / 2);
    double[] fineCentral = central(function, k, ofVelocity, STEP);
    for (int i = 0; i < fine.length; i++) {
      double next = finer[i] + (finer[i] - fineCentral[i]) / 3;
      fine[i] = next + (next - fine[i]) / 15;
    }
    return fine;
  }

  private double[] central(Supplier<double[]> function, int k, boolean ofVelocity, double h) {
    double[] plus = shifted(function, k, ofVelocity, h);
    double[] minus = shifted(function, k, ofVelocity, -h);
    for (int i = 0; i < plus.length; i++) {
      plus[i] = (plus[i] - minus[i]) / (2 * h);
    }
    return plus;
  }

  private double[] shifted(Supplier<double[]> function, int k, boolean ofVelocity, double h) {
    double[] kept = (ofVelocity ? v : q).clone();
    if (ofVelocity) {
      v[k] += h;
    } else {
      double[] unit = new double[v.length];
      unit[k] = 1;
      coordinates.move(q, 0, unit, 0, h);
    }
    double[] value = function.get();
    System.arraycopy(kept, 0, ofVelocity ? v : q, 0, kept.length);
    return value;
  }

  /** Returns the power of wrenches and joint forces. */
  public double workRate(double[] all) {
    double[] twists = twists(0.3);
    double sum = 0;
    for (int i = 0; i < all.length; i++) {
      sum += all[i] * twists[i];
    }
    return sum;
  }

  /** Returns the rate of the potential energy along the motion, by differences. */
  public double potentialEnergyRate(double t) {
    double[] rates = new double[3];
    for (int i = 0; i < 3; i++) {
      double h = 4e-3 / (1 << i);
      rates[i] = (energyAlong(t, h) - energyAlong(t, -h)) / (2 * h);
    }
    double first = rates[1] + (rates[1] - rates[0]) / 3;
    double second = rates[2] + (rates[2] - rates[1]) / 3;
    return second + (second - first) / 15;
  }

  private double energyAlong(double t, double h) {
    double[] kept = q.clone();
    coordinates.move(q, 0, v, 0, h);
    evaluate(t + h);
    double energy = forces.potentialEnergy();
    System.arraycopy(kept, 0, q, 0, q.length);
    return energy;
  }

  /** Returns the sum of all wrenches, referred to the root. */
  double[] totalInRoot(double[] all) {
    double[] total = new double[6];
    for (int link = 0; link < geometry.linkCount; link++) {
      double[] wrench = new double[6];
      System.arraycopy(all, 6 * link, wrench, 0, 6);
      for (int i = link; i != TreeGeometry.ROOT; i = geometry.parent[i]) {
        motion.wrenches.toParent(i, wrench, 0);
      }
      for (int i = 0; i < 6; i++) {
        total[i] += wrench[i];
      }
    }
    return total;
  }
}
