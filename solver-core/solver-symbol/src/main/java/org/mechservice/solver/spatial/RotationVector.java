package org.mechservice.solver.spatial;

/**
 * The rotation vector φ (axis times angle) of a rotation from child to parent axes, and its rate φ′
 * = B(φ) ω, ω the angular velocity of the child in parent axes: B = I − ½ [φ]× + γ [φ]×², γ = (1 −
 * (θ/2) cot(θ/2)) / θ², θ = |φ| (inverse of the left Jacobian of SO(3)). Workspace of one thread;
 * nothing allocates.
 */
public final class RotationVector {
  /** Cosine of half the angle below which a rotation counts as half a turn. */
  private static final double HALF_TURN = 1e-3;

  /** Angle below which γ is taken from its series; the next term is then below 1e-17. */
  private static final double SERIES = 0.05;

  private final double[] euler = new double[4];
  private final double[] phi = new double[3];
  private double gamma;

  /** γ′ / θ. */
  private double gammaSlope;

  /**
   * Sets the rotation.
   *
   * @param r rotation matrix row by row, child to parent axes; not modified
   * @return false within 2e-3 rad of half a turn, where the vector jumps
   */
  public boolean set(double[] r, int ir) {
    EulerParameters.of(r, ir, euler, 0);
    double sine = Math.sqrt(euler[1] * euler[1] + euler[2] * euler[2] + euler[3] * euler[3]);
    if (!(euler[0] > HALF_TURN)) {
      return false;
    }
    double theta = 2 * StrictMath.atan2(sine, euler[0]);
    double perSine = sine == 0 ? 2 : theta / sine;
    for (int i = 0; i < 3; i++) {
      phi[i] = perSine * euler[1 + i];
    }
    double z = theta * theta;
    if (theta < SERIES) {
      gamma = 1.0 / 12 + z * (1.0 / 720 + z * (1.0 / 30240 + z / 1209600));
      gammaSlope = 1.0 / 360 + z * (1.0 / 7560 + z / 201600);
    } else {
      // cot(θ/2) = e0 / |e|; its derivative −1/2 (1 + cot²)
      double cot = euler[0] / sine;
      gamma = (1 - 0.5 * theta * cot) / z;
      gammaSlope = (-0.5 * cot + 0.25 * theta * (1 + cot * cot) - 2 * theta * gamma) / (z * theta);
    }
    return true;
  }

  /** Returns a component of φ, rad. */
  public double at(int i) {
    return phi[i];
  }

  /** Writes B ω = ω − ½ φ × ω + γ φ × (φ × ω). */
  public void rate(double[] omega, int io, double[] out, int at) {
    rate(-0.5, omega, io, out, at);
  }

  /** Writes Bᵀ g = g + ½ φ × g + γ φ × (φ × g). */
  public void rateTransposed(double[] g, int ig, double[] out, int at) {
    rate(0.5, g, ig, out, at);
  }

  private void rate(double half, double[] a, int ia, double[] out, int at) {
    double x = phi[1] * a[ia + 2] - phi[2] * a[ia + 1];
    double y = phi[2] * a[ia] - phi[0] * a[ia + 2];
    double z = phi[0] * a[ia + 1] - phi[1] * a[ia];
    double xx = phi[1] * z - phi[2] * y;
    double yy = phi[2] * x - phi[0] * z;
    double zz = phi[0] * y - phi[1] * x;
    out[at] = a[ia] + half * x + gamma * xx;
    out[at + 1] = a[ia + 1] + half * y + gamma * yy;
    out[at + 2] = a[ia + 2] + half * z + gamma * zz;
  }

  /**
   * Writes the change of B for a change of φ: −½ [δ]× + γ ([δ]×[φ]× + [φ]×[δ]×) + (γ′/θ) (φ · δ)
   * [φ]×².
   *
   * @param delta change of φ; not modified
   * @param out 3 × 3 row by row; overwritten
   */
  public void rateMatrixChange(double[] delta, double[] out) {
    double along = phi[0] * delta[0] + phi[1] * delta[1] + phi[2] * delta[2];
    double square = phi[0] * phi[0] + phi[1] * phi[1] + phi[2] * phi[2];
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        // [a]×[b]× = b aᵀ − (a · b) I
        double mixed = phi[i] * delta[j] + delta[i] * phi[j] - (i == j ? 2 * along : 0);
        double same = phi[i] * phi[j] - (i == j ? square : 0);
        out[3 * i + j] = gamma * mixed + gammaSlope * along * same;
      }
    }
    out[1] += 0.5 * delta[2];
    out[2] -= 0.5 * delta[1];
    out[3] -= 0.5 * delta[2];
    out[5] += 0.5 * delta[0];
    out[6] += 0.5 * delta[1];
    out[7] -= 0.5 * delta[0];
  }
}
