package examples.driver;

import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/**
 * Cushion and back of the seat: with the depth d below the plane, the push along its normal is
 * k pos(d) + c d' pos'(d), where pos(d) = (d + √(d² + ε²)) / 2. This is the law of the reference
 * solution, whose damper can pull for an instant while a body leaves; a contact of MechML never does.
 */
public final class DriverSeat implements UserForce.Derivatives {
  /** Smoothing ε, m. */
  private static final double SMOOTHING = 0.002;

  private static final String[] BODY = {"thighL", "thighR", "thorax"};
  private static final String[] POINT = {"seat cushion L", "seat cushion R", "seat back"};

  /** Unit normals of the planes, towards the driver. */
  private static final double[][] NORMAL = {{-0.28, 0, 0.96}, {-0.28, 0, 0.96}, {0.96, 0, 0.28}};

  /** Distances of the planes from the origin, along their normals, m. */
  private static final double[] OFFSET = {0.366, 0.366, 0.011};

  /** N/m. */
  private static final double[] STIFFNESS = {30000, 30000, 20000};

  /** N·s/m. */
  private static final double[] DAMPING = {300, 300, 200};

  private final int[] point = new int[BODY.length];
  private final double[] p = new double[3];
  private final double[] v = new double[3];
  private final double[] block = new double[9];

  @Override
  public void declare(ForceDeclaration model) {
    for (int i = 0; i < BODY.length; i++) {
      point[i] =
          model.point(
              BODY[i],
              POINT[i],
              ForceDeclaration.Reads.POSITION,
              ForceDeclaration.Reads.VELOCITY);
    }
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    for (int i = 0; i < point.length; i++) {
      double[] n = NORMAL[i];
      double d = depth(state, i);
      double rate = -dot(n, v);
      double root = Math.sqrt(d * d + SMOOTHING * SMOOTHING);
      double push = STIFFNESS[i] * (d + root) / 2 + DAMPING[i] * rate * (1 + d / root) / 2;
      loads.addForce(point[i], push * n[0], push * n[1], push * n[2]);
    }
  }

  @Override
  public void differentiate(ForceState state, ForceBlocks blocks) {
    for (int i = 0; i < point.length; i++) {
      double[] n = NORMAL[i];
      double d = depth(state, i);
      double rate = -dot(n, v);
      double root = Math.sqrt(d * d + SMOOTHING * SMOOTHING);
      double slope = (1 + d / root) / 2;
      double bend = SMOOTHING * SMOOTHING / (2 * root * root * root);
      block(n, -(STIFFNESS[i] * slope + DAMPING[i] * rate * bend));
      blocks.byPoint(
          ForceBlocks.Load.FORCE, point[i], ForceDeclaration.Reads.POSITION, point[i], block);
      block(n, -DAMPING[i] * slope);
      blocks.byPoint(
          ForceBlocks.Load.FORCE, point[i], ForceDeclaration.Reads.VELOCITY, point[i], block);
    }
  }

  /** Reads place and velocity of a point; returns how deep it lies in its plane, m. */
  private double depth(ForceState state, int i) {
    state.position(point[i], p);
    state.velocity(point[i], v);
    return OFFSET[i] - dot(NORMAL[i], p);
  }

  /** Sets the block to factor · n nᵀ. */
  private void block(double[] n, double factor) {
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        block[3 * row + column] = factor * n[row] * n[column];
      }
    }
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
}
