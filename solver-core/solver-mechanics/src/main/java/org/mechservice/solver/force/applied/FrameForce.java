package org.mechservice.solver.force.applied;

import java.util.Arrays;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.force.ForceElement;

/** A force between two bodies, given by a law of their relative motion and applied to both. */
public final class FrameForce extends AppliedForce {
  private final FrameMotion motion;
  private final FrameLaw law;
  private final double[] w = new double[6];
  private final double[] slopes = new double[72];
  private final double[] xi = new double[6];
  private final double[] still = new double[6];
  private final double[] place = new double[6];
  private final double[] velocity = new double[6];
  private final double[] dw = new double[6];
  private final double[] column = new double[6];

  /** Derivatives of the wrench on body 1, then of that on body 2, by one body. */
  private final double[][] byPlace = new double[2][36];

  private final double[][] byVelocity = new double[2][36];

  public FrameForce(ForceElement element, FrameMotion motion, FrameLaw law) {
    super(element);
    this.motion = motion;
    this.law = law;
  }

  @Override
  public boolean parameters(double[] values) {
    return law.parameters(values, this);
  }

  @Override
  public boolean apply(double t, double[] wrench, double[] tau) {
    motion.read();
    if (!law.wrench(motion, w, this)) {
      return false;
    }
    for (double component : w) {
      if (!Double.isFinite(component)) {
        return notFinite("force or moment", component);
      }
    }
    motion.addWrench(w, wrench);
    return true;
  }

  @Override
  public boolean linearise(double t, ForceJacobian sink) {
    Arrays.fill(slopes, 0);
    law.slopes(motion, slopes);
    for (int i = 0; i < 36; i++) {
      double entry = slopes[i] + slopes[36 + i];
      if (!Double.isFinite(entry)) {
        return notFinite("derivative", entry);
      }
    }
    linearise(true, motion.link1(), sink);
    linearise(false, motion.link2(), sink);
    return true;
  }

  /** Adds the derivatives by body 1 or 2, one column per component of its twist. */
  private void linearise(boolean first, int link, ForceJacobian sink) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    for (int j = 0; j < 6; j++) {
      Arrays.fill(xi, 0);
      xi[j] = 1;
      motion.changeByPlace(first, xi, place, velocity);
      change(place, velocity);
      motion.wrenchChange1(w, dw, place, column);
      putColumn(byPlace[0], j);
      motion.wrenchChange2(w, dw, first, xi, column);
      putColumn(byPlace[1], j);
      motion.changeByVelocity(first, xi, velocity);
      change(still, velocity);
      motion.wrenchChange1(w, dw, still, column);
      putColumn(byVelocity[0], j);
      motion.wrenchChange2(w, dw, first, still, column);
      putColumn(byVelocity[1], j);
    }
    if (motion.link1() != TreeGeometry.ROOT) {
      sink.wrenchByLink(motion.link1(), link, byPlace[0], byVelocity[0]);
    }
    if (motion.link2() != TreeGeometry.ROOT) {
      sink.wrenchByLink(motion.link2(), link, byPlace[1], byVelocity[1]);
    }
  }

  @Override
  public void addByState(int state, double[] wrench, double[] tau) {
    if (law.byState(state, dw)) {
      motion.addWrench(dw, wrench);
    }
  }

  private void change(double[] byThisPlace, double[] byThisVelocity) {
    for (int i = 0; i < 6; i++) {
      double sum = 0;
      for (int k = 0; k < 6; k++) {
        sum += slopes[6 * i + k] * byThisPlace[k] + slopes[36 + 6 * i + k] * byThisVelocity[k];
      }
      dw[i] = sum;
    }
  }

  private void putColumn(double[] matrix, int j) {
    for (int i = 0; i < 6; i++) {
      matrix[6 * i + j] = column[i];
    }
  }

  @Override
  public double potentialEnergy() {
    return law.potentialEnergy();
  }

  @Override
  public double power() {
    return law.power(motion, w);
  }

  @Override
  public void values(double[] out, int at) {
    law.values(motion, out, at);
  }

  @Override
  public void accepted() {
    law.accepted();
  }

  @Override
  public boolean isLocal() {
    return motion.isOfNeighbours();
  }

  @Override
  public void couplings(Couplings couplings) {
    if (motion.link1() != TreeGeometry.ROOT && motion.link2() != TreeGeometry.ROOT) {
      couplings.couple(motion.link1(), motion.link2());
      couplings.couple(motion.link2(), motion.link1());
    }
  }
}
