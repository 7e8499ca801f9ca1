package org.mechservice.solver.dynamics;

import static org.mechservice.solver.dynamics.Evaluation.largest;
import static org.mechservice.solver.dynamics.Evaluation.norm;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntFunction;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.oracle.GlobalFormulation;
import org.mechservice.solver.oracle.OracleForce;
import org.mechservice.solver.oracle.TaylorPose;
import org.mechservice.solver.spatial.Vector3;

/**
 * Accelerations of one loaded tree by every formulation, judged as in
 * docs/theory/formulations.md#agreement.
 *
 * @param velocities number of velocities
 * @param condition κ of D M D with D = diag(M)^(−1/2)
 * @param backward for each formulation ‖M a + b − τ‖ / (‖M‖ ‖a‖ + ‖b − τ‖), by the residual of RR
 * @param forward for each formulation besides DSR the largest difference of an acceleration from
 *     that of DSR, over 1 + the largest acceleration
 */
public record TreeComparison(
    int velocities, double condition, Map<String, Double> backward, Map<String, Double> forward) {
  /** What a backward error may be. */
  public static final double BACKWARD = 1e-12;

  /** Returns what forward differences may be: 100 ε κ, or 1e-11. */
  public double forwardBound() {
    return Math.max(1e-11, 100 * Math.ulp(1.0) * condition);
  }

  /** Compares all formulations on a tree under random forces; the oracle only if asked for. */
  public static TreeComparison of(Mechanism mechanism, long seed, boolean withGlobal) {
    Evaluation at = new Evaluation(mechanism).loaded(seed);
    RealMatrix mass = massMatrix(at);
    Map<String, double[]> found = new LinkedHashMap<>();
    found.put("DSR", at.bySemiRecursion());
    found.put("DTR", at.byArticulatedBodies());
    found.put("RR", at.byResidual());
    Map<String, Double> backward = new LinkedHashMap<>();
    Map<String, Double> forward = new LinkedHashMap<>();
    compare(at, mass, found, backward, forward);
    if (withGlobal) {
      // the oracle knows wrenches on bodies, not forces in joints
      Arrays.fill(at.tau, 0);
      Map<String, double[]> pushed = new LinkedHashMap<>();
      pushed.put("DSR", at.bySemiRecursion());
      pushed.put("global", byOracle(at));
      Map<String, Double> again = new LinkedHashMap<>();
      compare(at, mass, pushed, again, forward);
      backward.put("global", again.get("global"));
    }
    return new TreeComparison(at.nv, condition(mass), backward, forward);
  }

  private static void compare(
      Evaluation at,
      RealMatrix mass,
      Map<String, double[]> found,
      Map<String, Double> backward,
      Map<String, Double> forward) {
    double massNorm = mass.getFrobeniusNorm();
    double forceNorm = norm(at.residual(new double[at.nv]));
    double[] reference = Objects.requireNonNull(found.get("DSR"));
    found.forEach(
        (name, a) -> {
          double size = massNorm * norm(a) + forceNorm;
          backward.put(name, size == 0 ? 0 : norm(at.residual(a)) / size);
          if (a != reference) {
            double[] difference = new double[a.length];
            Arrays.setAll(difference, i -> a[i] - reference[i]);
            forward.put(name, largest(difference) / (1 + largest(reference)));
          }
        });
  }

  private static double[] byOracle(Evaluation at) {
    OracleForce wrenches = (t, pose, loads) -> apply(at, pose, loads);
    double[] q = Arrays.copyOf(at.y, at.nq);
    return new GlobalFormulation(at.mechanism, List.of(wrenches))
        .accelerations(0, q, at.velocities());
  }

  private static void apply(Evaluation at, IntFunction<TaylorPose> pose, OracleForce.Loads loads) {
    for (int body = 0; body < at.tree.linkOfBody.length; body++) {
      int link = at.tree.linkOfBody[body];
      TaylorPose ofBody = pose.apply(body);
      Vector3 moment = ofBody.rotation().value().apply(vector(at.wrench, 6 * link));
      Vector3 force = ofBody.rotation().value().apply(vector(at.wrench, 6 * link + 3));
      Vector3 reference = vector(at.tree.bodyOrigin, 3 * link).negated();
      loads.force(new BodyPoint(body, reference), force);
      loads.moment(body, moment);
    }
  }

  private static Vector3 vector(double[] x, int at) {
    return new Vector3(x[at], x[at + 1], x[at + 2]);
  }

  private static RealMatrix massMatrix(Evaluation at) {
    double[] dense = new double[at.nv * at.nv];
    at.semiRecursive().massMatrix().toDense(dense);
    RealMatrix m = new Array2DRowRealMatrix(Math.max(1, at.nv), Math.max(1, at.nv));
    for (int i = 0; i < at.nv; i++) {
      for (int j = 0; j < at.nv; j++) {
        m.setEntry(i, j, dense[at.nv * i + j]);
      }
    }
    return m;
  }

  private static double condition(RealMatrix mass) {
    RealMatrix scaled = mass.copy();
    int n = mass.getRowDimension();
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        double d = Math.sqrt(mass.getEntry(i, i) * mass.getEntry(j, j));
        scaled.setEntry(i, j, d == 0 ? 1 : mass.getEntry(i, j) / d);
      }
    }
    return new SingularValueDecomposition(scaled).getConditionNumber();
  }
}
