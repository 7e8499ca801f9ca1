package examples.driver;

import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/**
 * Four belts: with the elongation x beyond the free length, the tension is k pos(x) + c x' pos'(x),
 * where pos(x) = (x + √(x² + ε²)) / 2. This is the law of the reference solution, whose damper can
 * push for an instant while a belt slackens; a springDamper of MechML never does.
 */
public final class DriverBelts implements UserForce.Derivatives {
  /** Smoothing ε, m. */
  private static final double SMOOTHING = 0.002;

  private static final String[] BODY = {"pelvis", "pelvis", "thorax", "thorax"};
  private static final String[] NAME = {
    "lap belt L", "lap belt R", "shoulder belt upper", "shoulder belt lower"
  };

  /** Free lengths, m. */
  private static final double[] LENGTH = {
    0.391393581727, 0.391393581727, 0.366272479992, 0.634298390195
  };

  /** N/m. */
  private static final double[] STIFFNESS = {40000, 40000, 30000, 30000};

  /** N·s/m. */
  private static final double[] DAMPING = {200, 200, 150, 150};

  private final int[] point = new int[BODY.length];
  private final int[] anchor = new int[BODY.length];
  private final double[] p = new double[3];
  private final double[] v = new double[3];

  /** Unit vector from the point to the anchor. */
  private final double[] u = new double[3];

  private final double[] block = new double[9];

  @Override
  public void declare(ForceDeclaration model) {
    for (int i = 0; i < BODY.length; i++) {
      point[i] =
          model.point(
              BODY[i], NAME[i], ForceDeclaration.Reads.POSITION, ForceDeclaration.Reads.VELOCITY);
      anchor[i] = model.point("Ground", NAME[i], ForceDeclaration.Reads.POSITION);
    }
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    for (int i = 0; i < point.length; i++) {
      double x = length(state, i) - LENGTH[i];
      double rate = -dot(u, v);
      double root = Math.sqrt(x * x + SMOOTHING * SMOOTHING);
      double tension = STIFFNESS[i] * (x + root) / 2 + DAMPING[i] * rate * (1 + x / root) / 2;
      loads.addForce(point[i], tension * u[0], tension * u[1], tension * u[2]);
    }
  }

  @Override
  public void differentiate(ForceState state, ForceBlocks blocks) {
    for (int i = 0; i < point.length; i++) {
      double length = length(state, i);
      double x = length - LENGTH[i];
      double rate = -dot(u, v);
      double root = Math.sqrt(x * x + SMOOTHING * SMOOTHING);
      double slope = (1 + x / root) / 2;
      double bend = SMOOTHING * SMOOTHING / (2 * root * root * root);
      double tension = STIFFNESS[i] * (x + root) / 2 + DAMPING[i] * rate * slope;
      double byLength = STIFFNESS[i] * slope + DAMPING[i] * rate * bend;
      byPosition(tension / length, byLength, DAMPING[i] * slope / length);
      blocks.byPoint(
          ForceBlocks.Load.FORCE, point[i], ForceDeclaration.Reads.POSITION, point[i], block);
      byVelocity(DAMPING[i] * slope);
      blocks.byPoint(
          ForceBlocks.Load.FORCE, point[i], ForceDeclaration.Reads.VELOCITY, point[i], block);
    }
  }

  /**
   * Sets the block to ∂(T u)/∂p = u (T_L ∂L/∂p + T_rate ∂L'/∂p) + T ∂u/∂p, with ∂L/∂p = −u, ∂u/∂p =
   * −(1 − u uᵀ)/L and ∂L'/∂p = (1 − u uᵀ) v / L.
   *
   * @param pull T / L
   * @param byLength T_L
   * @param byRate T_rate / L
   */
  private void byPosition(double pull, double byLength, double byRate) {
    double along = dot(u, v);
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        double unit = row == column ? 1 : 0;
        block[3 * row + column] =
            u[row] * (-byLength * u[column] + byRate * (v[column] - along * u[column]))
                - pull * (unit - u[row] * u[column]);
      }
    }
  }

  private void byVelocity(double byRate) {
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        block[3 * row + column] = -byRate * u[row] * u[column];
      }
    }
  }

  /** Reads velocity and direction of a belt; returns its length, m. */
  private double length(ForceState state, int i) {
    state.position(point[i], p);
    state.velocity(point[i], v);
    state.position(anchor[i], u);
    double square = 0;
    for (int k = 0; k < 3; k++) {
      u[k] -= p[k];
      square += u[k] * u[k];
    }
    double length = Math.sqrt(square);
    for (int k = 0; k < 3; k++) {
      u[k] /= length;
    }
    return length;
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
}
