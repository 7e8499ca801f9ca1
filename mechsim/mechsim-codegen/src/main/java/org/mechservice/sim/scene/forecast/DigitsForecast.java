package org.mechservice.sim.scene.forecast;

import java.util.Locale;
import java.util.Optional;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.InertiaCheck;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.SemiRecursive;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Warns before a run of an open chain by DSR if the mass matrix leaves accelerations fewer digits
 * than the tolerance needs. This happens if light bodies carry heavy ones: the inertia at a joint,
 * with the joints beyond it free, is then a small difference of large numbers. Error tests mistake
 * such rounding for motion, and steps shrink a hundredfold. DTR and the residual formulations do
 * not form this difference.
 */
final class DigitsForecast {
  private static final String MATRIX = Formulation.DSR.label();

  /** Largest number of velocities; factoring a larger mass matrix costs too much for a warning. */
  private static final int MOST_VELOCITIES = 300;

  private DigitsForecast() {}

  /**
   * Forecasts a run.
   *
   * @param formulation requested formulation
   */
  static Optional<Finding> of(Mechanism mechanism, String formulation, RunSettings settings) {
    int n = mechanism.velocityCount();
    boolean asked = formulation.equalsIgnoreCase(MATRIX) && mechanism.closures().isEmpty();
    if (!asked || n == 0 || n > MOST_VELOCITIES) {
      return Optional.empty();
    }
    double[] left = partsLeft(massMatrix(mechanism, settings.tStart()), n);
    int worst = 0;
    for (int k = 1; k < n; k++) {
      worst = left[k] < left[worst] ? k : worst;
    }
    double error = Math.ulp(1.0) / left[worst];
    return error > settings.relativeTolerance()
        ? Optional.of(finding(InertiaCheck.jointAt(mechanism, worst), left[worst], settings))
        : Optional.empty();
  }

  private static double[] massMatrix(Mechanism mechanism, double t) {
    TreeGeometry tree = new TreeGeometry(mechanism);
    TreeMotion motion = new TreeMotion(tree);
    int n = mechanism.velocityCount();
    double[] y = new double[mechanism.positionCount() + n];
    mechanism.initialState(y);
    motion.sweep(t, y);
    SemiRecursive work = new SemiRecursive(motion);
    work.formMassMatrix();
    double[] mass = new double[n * n];
    work.massMatrix().toDense(mass);
    return mass;
  }

  /** Returns the pivots of M = LᵀDL, from the tips to the root, over the diagonal of M. */
  private static double[] partsLeft(double[] m, int n) {
    double[] left = new double[n];
    for (int k = 0; k < n; k++) {
      left[k] = m[k * n + k];
    }
    for (int k = n - 1; k >= 0; k--) {
      double pivot = m[k * n + k];
      left[k] = pivot / left[k];
      for (int i = 0; i < k; i++) {
        double factor = m[k * n + i] / pivot;
        for (int j = 0; j <= i && factor != 0; j++) {
          m[i * n + j] -= factor * m[k * n + j];
        }
      }
    }
    return left;
  }

  private static Finding finding(Joint joint, double left, RunSettings settings) {
    return new Finding(
        MessageCode.NEARLY_SINGULAR_INERTIA,
        String.format(
            Locale.ROOT,
            "the joints beyond joint \"%s\" leave one part in %.0e of the inertia at it, so that"
                + " DSR has about %d digits of its acceleration, fewer than the relative tolerance"
                + " %.0e asks for, and steps will shrink; use formulation DTR, or RR-JF with"
                + " ode15sR",
            joint.name(),
            1 / left,
            (int) Math.max(0, Math.floor(Math.log10(left / Math.ulp(1.0)))),
            settings.relativeTolerance()),
        joint.origin());
  }
}
