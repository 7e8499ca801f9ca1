package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.model.LinearisedProjectionModel;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.oracle.GlobalFormulation;
import org.mechservice.solver.oracle.OracleForce;

/**
 * Accelerations and reactions of one mechanism with loops by every formulation and closure, against
 * maximal coordinates.
 *
 * @param freedom degrees of freedom
 * @param redundant equations of the loops that follow from others
 * @param condition κ of D M D times that of J D (docs/theory/formulations.md#agreement)
 * @param forward for each formulation the largest difference of an acceleration from that of the
 *     oracle, over 1 + the largest acceleration
 * @param missing largest force or moment that the reactions of DSR and of DSR with penalty leave
 *     missing to move a body as it moves, over 1 + the largest reaction
 */
public record LoopComparison(
    int freedom, int redundant, double condition, Map<String, Double> forward, double missing) {
  /** What {@link #missing} may be. */
  public static final double MISSING = 1e-9;

  private static final RunSettings SETTINGS = SceneRun.settings(1, 0.1, "ode113", 1e-8);

  /** Why a mechanism is not compared. */
  public enum LeftOut {
    NOT_CLOSED("no velocities or positions fit the loops"),
    LOCKED("no degree of freedom is left"),
    SINGULAR_START("starts in a singular position");

    private final String words;

    LeftOut(String words) {
      this.words = words;
    }

    /** Returns the reason in words. */
    public String words() {
      return words;
    }
  }

  /** Returns what forward differences may be: 100 ε κ, or 1e-11. */
  public double forwardBound() {
    return Math.max(1e-11, 100 * Math.ulp(1.0) * condition);
  }

  /** Returns the seeded mechanism of 2 to 8 bodies with 1 or 2 loops. */
  public static Mechanism mechanism(long seed) {
    return RandomLoops.of(seed, 2 + (int) (seed % 7), 1 + (int) (seed % 2));
  }

  /** Returns why a mechanism cannot be compared, if it cannot. */
  public static Optional<LeftOut> leftOut(Mechanism mechanism) {
    ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", SETTINGS);
    if (!closed.start().isAssembled()) {
      return Optional.of(LeftOut.NOT_CLOSED);
    } else if (closed.freedom() == 0) {
      return Optional.of(LeftOut.LOCKED);
    }
    return closed.start().findings().stream()
            .anyMatch(finding -> finding.kind() == LoopFinding.Kind.SINGULAR_START)
        ? Optional.of(LeftOut.SINGULAR_START)
        : Optional.empty();
  }

  /** Compares all formulations; the mechanism has no forces. */
  public static LoopComparison of(Mechanism mechanism) {
    return of(mechanism, List.of());
  }

  /**
   * Compares all formulations.
   *
   * @param forces the mechanism's, written down a second time
   */
  public static LoopComparison of(Mechanism mechanism, List<OracleForce> forces) {
    ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", SETTINGS);
    double[] y = closed.start().state();
    int nq = mechanism.positionCount();
    double[] v = Arrays.copyOfRange(y, nq, y.length);
    double[] expected = new GlobalFormulation(mechanism, forces).accelerations(0, y, v);
    Map<String, Double> forward = new LinkedHashMap<>();
    double missing = 0;
    double condition = 0;
    for (String formulation : List.of("DSR", "DSR penalty")) {
      LoopModel model = LoopModels.of(mechanism, formulation, SETTINGS);
      double[] a = accelerations(model, y);
      forward.put(formulation, difference(a, expected));
      missing = Math.max(missing, missing(mechanism, forces, model, y, a));
      condition = condition(model, closed.start().rank());
    }
    LinearisedProjectionModel residual =
        (LinearisedProjectionModel) LoopModels.of(mechanism, "RR-JF", SETTINGS);
    forward.put("RR", difference(byResidual(residual, y), expected));
    return new LoopComparison(
        closed.freedom(),
        residual.work.loops.count() - closed.start().rank(),
        condition,
        forward,
        missing);
  }

  private static void require(boolean done) {
    if (!done) {
      throw new IllegalStateException("an evaluation failed");
    }
  }

  private static double[] accelerations(LoopModel model, double[] y) {
    double[] yDot = new double[y.length];
    require(model.derivative(0, y, yDot) == ExplicitModel.REGULAR);
    return Arrays.copyOfRange(yDot, model.work.nq, y.length);
  }

  /** Solves for a zero of the residual, which is linear in the derivatives. */
  private static double[] byResidual(LinearisedProjectionModel model, double[] y) {
    int nq = model.work.nq;
    double[] yDot = new double[y.length];
    double[] residual = new double[y.length];
    require(model.linearise(0, y, yDot) && model.factor(0));
    for (int i = 0; i < 2; i++) {
      require(model.residual(0, y, yDot, residual) == ExplicitModel.REGULAR);
      Arrays.fill(residual, 0, nq, 0);
      model.solve(residual);
      for (int k = nq; k < y.length; k++) {
        yDot[k] -= residual[k];
      }
    }
    require(model.residual(0, y, yDot, residual) == ExplicitModel.REGULAR);
    return model.acceleration.clone();
  }

  private static double difference(double[] a, double[] expected) {
    double largest = 0;
    double difference = 0;
    for (int i = 0; i < a.length; i++) {
      largest = Math.max(largest, Math.abs(expected[i]));
      difference = Math.max(difference, Math.abs(a[i] - expected[i]));
    }
    return difference / (1 + largest);
  }

  /** Newton and Euler for every body, with the reactions of all joints, planes, lines and rods. */
  private static double missing(
      Mechanism mechanism, List<OracleForce> forces, LoopModel model, double[] y, double[] a) {
    require(model.react(0, y) == ExplicitModel.REGULAR);
    Reactions reactions = model.reactions();
    double largest =
        Arrays.stream(reactions.onJoints).map(Math::abs).max().orElse(0)
            + Arrays.stream(reactions.multipliers).map(Math::abs).max().orElse(0);
    List<OracleForce> all = new ArrayList<>(forces);
    all.add((t, pose, loads) -> ReactionsTest.apply(mechanism, reactions, pose, loads));
    GlobalFormulation global = new GlobalFormulation(mechanism, all);
    double[] v = Arrays.copyOfRange(y, model.work.nq, y.length);
    double missing = Arrays.stream(global.missing(0, y, v, a)).map(Math::abs).max().orElse(0);
    return missing / (1 + largest);
  }

  private static double condition(LoopModel model, int rank) {
    ClosedTree work = model.work;
    int n = work.nv;
    work.formMass();
    RealMatrix mass = new Array2DRowRealMatrix(n, n);
    RealMatrix rows = new Array2DRowRealMatrix(work.loops.count(), n);
    for (int i = 0; i < n; i++) {
      double perRoot = 1 / Math.sqrt(work.mass()[i * n + i]);
      for (int j = 0; j < n; j++) {
        mass.setEntry(i, j, work.mass()[i * n + j] * perRoot / Math.sqrt(work.mass()[j * n + j]));
      }
      for (int row = 0; row < work.loops.count(); row++) {
        rows.setEntry(row, i, work.loops.jacobian.get(row, i) * perRoot);
      }
    }
    double ofMass = new SingularValueDecomposition(mass).getConditionNumber();
    if (rank == 0) {
      return ofMass;
    }
    double[] sigma = new SingularValueDecomposition(rows).getSingularValues();
    return ofMass * sigma[0] / sigma[rank - 1];
  }
}
