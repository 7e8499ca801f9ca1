package org.mechservice.solver.force.law;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Coefficients;
import org.mechservice.solver.force.applied.FrameLaw;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.spatial.RotationVector;

/**
 * Force and moment of a bushing. Legend: x = [r; φ]; φ′ = B ω with B = B(φ); g = preload − K x − C
 * x′; force g_r; moment Bᵀ g_φ (ENERGY) or g_φ (LINEAR, where φ′ is replaced by ω).
 */
public final class BushingLaw implements FrameLaw {
  private static final int PRELOAD = 72;

  private final Coefficients coefficients;
  private final boolean byEnergy;
  private final RotationVector phi = new RotationVector();
  private final double[] stiffness = new double[36];
  private final double[] damping = new double[36];
  private final double[] preload = new double[6];
  private final double[] x = new double[6];
  private final double[] rate = new double[6];
  private final double[] g = new double[6];
  private final double[] dx = new double[6];
  private final double[] dRate = new double[6];
  private final double[] direction = new double[3];
  private final double[] dMoment = new double[3];
  private final double[] dB = new double[9];
  private final double[] unit = new double[6];
  private final double[] none = new double[6];

  public BushingLaw(Bushing element) {
    List<Expression> all = new ArrayList<>(element.stiffness());
    all.addAll(element.damping());
    all.addAll(element.preload());
    coefficients = new Coefficients(element.name(), all);
    byEnergy = element.law() == Bushing.Law.ENERGY;
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    int bad = coefficients.update(values);
    if (bad >= 0) {
      String quantity = bad < 36 ? "stiffness" : bad < PRELOAD ? "damping" : "preload";
      return force.refuse(quantity, coefficients.at(bad), "finite");
    }
    for (int i = 0; i < 36; i++) {
      stiffness[i] = coefficients.at(i);
      damping[i] = coefficients.at(36 + i);
    }
    for (int i = 0; i < 6; i++) {
      preload[i] = coefficients.at(PRELOAD + i);
    }
    return true;
  }

  @Override
  public boolean wrench(FrameMotion motion, double[] w, AppliedForce force) {
    if (!phi.set(motion.rotation, 0)) {
      return force.fail(
          MessageCode.FORCE_WITHOUT_DIRECTION,
          "Its frames are turned by half a turn, where a rotation vector changes its sign.",
          "Turn one of the frames, or use a joint with a spring for large rotations.");
    }
    for (int i = 0; i < 3; i++) {
      x[i] = motion.displacement[i];
      x[3 + i] = phi.at(i);
      rate[i] = motion.twist[3 + i];
      rate[3 + i] = motion.twist[i];
    }
    if (byEnergy) {
      phi.rate(motion.twist, 0, rate, 3);
    }
    for (int i = 0; i < 6; i++) {
      double sum = preload[i];
      for (int k = 0; k < 6; k++) {
        sum -= stiffness[6 * i + k] * x[k] + damping[6 * i + k] * rate[k];
      }
      g[i] = sum;
      w[(i + 3) % 6] = sum;
    }
    if (byEnergy) {
      phi.rateTransposed(g, 3, w, 0);
    }
    return true;
  }

  @Override
  public void jacobian(FrameMotion motion, double[] byPlace, double[] byVelocity) {
    for (int j = 0; j < 6; j++) {
      for (int i = 0; i < 6; i++) {
        unit[i] = i == j ? 1 : 0;
      }
      column(motion, unit, none, byPlace, j);
      column(motion, none, unit, byVelocity, j);
    }
  }

  /** Writes the change of the wrench for a change of pose and of twist. */
  private void column(FrameMotion motion, double[] place, double[] twist, double[] out, int j) {
    phi.rate(place, 0, direction, 0);
    for (int i = 0; i < 3; i++) {
      dx[i] = place[3 + i];
      dx[3 + i] = direction[i];
      dRate[i] = twist[3 + i];
      dRate[3 + i] = twist[i];
    }
    if (byEnergy) {
      phi.rateMatrixChange(direction, dB);
      phi.rate(twist, 0, dRate, 3);
      for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
          dRate[3 + i] += dB[3 * i + k] * motion.twist[k];
        }
      }
    }
    for (int i = 0; i < 6; i++) {
      double sum = 0;
      for (int k = 0; k < 6; k++) {
        sum -= stiffness[6 * i + k] * dx[k] + damping[6 * i + k] * dRate[k];
      }
      out[6 * ((i + 3) % 6) + j] = sum;
    }
    if (byEnergy) {
      energyMoment(out, j);
    }
  }

  /** Replaces the change of g_φ, in the rows of the moment, by that of Bᵀ g_φ. */
  private void energyMoment(double[] out, int j) {
    for (int i = 0; i < 3; i++) {
      direction[i] = out[6 * i + j];
    }
    phi.rateTransposed(direction, 0, dMoment, 0);
    for (int i = 0; i < 3; i++) {
      double sum = dMoment[i];
      for (int k = 0; k < 3; k++) {
        sum += dB[3 * k + i] * g[3 + k];
      }
      out[6 * i + j] = sum;
    }
  }

  @Override
  public double potentialEnergy(FrameMotion motion) {
    double sum = 0;
    for (int i = 0; i < 6; i++) {
      for (int k = 0; k < 6; k++) {
        sum += 0.5 * x[i] * stiffness[6 * i + k] * x[k];
      }
      sum -= preload[i] * x[i];
    }
    return sum;
  }

  @Override
  public double energyRate(FrameMotion motion) {
    phi.rate(motion.twist, 0, direction, 0);
    double sum = 0;
    for (int i = 0; i < 6; i++) {
      double force = -preload[i];
      for (int k = 0; k < 6; k++) {
        force += 0.5 * (stiffness[6 * i + k] + stiffness[6 * k + i]) * x[k];
      }
      sum += force * (i < 3 ? motion.twist[3 + i] : direction[i - 3]);
    }
    return sum;
  }

  @Override
  public void values(FrameMotion motion, double[] out, int at) {
    System.arraycopy(x, 0, out, at, 6);
    System.arraycopy(g, 0, out, at + 6, 6);
    if (byEnergy) {
      phi.rateTransposed(g, 3, out, at + 9);
    }
  }
}
