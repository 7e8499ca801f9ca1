package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** How loops are closed again after an event has set some components of the state. */
class StateJumpTest {
  /** Mechanisms that close and move. */
  static LongStream seeds() {
    return LongStream.iterate(1, seed -> seed + 1)
        .filter(seed -> LoopComparison.leftOut(LoopComparison.mechanism(seed)).isEmpty())
        .limit(40);
  }

  private static LoopModel model(Mechanism mechanism, String formulation) {
    return LoopModels.of(mechanism, formulation, SceneRun.settings(1, 0.1, "ode113", 1e-8));
  }

  /** 1 kg on three crossed slides without mass, held at 1 m from the origin. */
  private static Mechanism sphericalPendulum() {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    Vector3[] axes = {Linkages.X, Linkages.Y, Linkages.Z};
    double[] start = {0.6, 0, -0.8};
    for (int i = 0; i < 3; i++) {
      double mass = i == 2 ? 1 : 0;
      bodies.add(new Body("b" + i, mass, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE));
      Attachment at = new Attachment(i - 1, Vector3.ZERO, i, Vector3.ZERO, Rotation.IDENTITY);
      joints.add(new Prismatic("s" + i, at, axes[i], start[i], 0, Origin.NONE));
    }
    BodyPoint origin = new BodyPoint(BodyPoint.ROOT, Vector3.ZERO);
    BodyPoint end = new BodyPoint(2, Vector3.ZERO);
    DistanceClosure rod = new DistanceClosure("rod", origin, end, 1, 0, Origin.NONE);
    return Linkages.mechanism("spherical pendulum", bodies, joints, List.of(rod));
  }

  /** The rod's impulse is along the rod; what is set takes the impulse it needs besides. */
  @ValueSource(strings = {"DSR", "DSR penalty", "RR", "RR-JF", "RR-JF penalty"})
  @ParameterizedTest
  void velocitiesThatWereNotSetChangeByTheImpulseOfTheRodAlone(String formulation) {
    LoopModel model = model(sphericalPendulum(), formulation);
    double[] y = {0.48, 0.36, -0.8, 3, 0.2, -0.4};
    assertThat(model.jump(0, y, new boolean[] {false, false, false, true, false, false})).isTrue();
    assertThat(Arrays.copyOf(y, 3)).containsExactly(0.48, 0.36, -0.8);
    assertThat(y[3]).isCloseTo(3, within(1e-12));
    double rate = 0.48 * y[3] + 0.36 * y[4] - 0.8 * y[5];
    assertThat(rate).isCloseTo(0, within(1e-12));
    // (Δvy, Δvz) is along the rod's (y, z)
    assertThat((y[4] - 0.2) * -0.8 - (y[5] + 0.4) * 0.36).isCloseTo(0, within(1e-12));
  }

  @ValueSource(strings = {"DSR", "DSR penalty"})
  @ParameterizedTest
  void positionsThatWereNotSetMoveOntoTheLoops(String formulation) {
    LoopModel model = model(sphericalPendulum(), formulation);
    double[] y = {-0.5, 0, -0.8, 0, 0, 0};
    assertThat(model.jump(0, y, new boolean[] {true, false, false, false, false, false})).isTrue();
    assertThat(y[0]).isCloseTo(-0.5, within(1e-14));
    assertThat(Math.hypot(y[0], Math.hypot(y[1], y[2]))).isCloseTo(1, within(1e-12));
    assertThat(y[2]).isCloseTo(-Math.sqrt(0.75), within(1e-3));
  }

  /** A point 3 m aside cannot be held at 1 m: what is set gives way, and the caller sees it. */
  @ValueSource(strings = {"DSR", "DSR penalty"})
  @ParameterizedTest
  void whatIsSetGivesWayWhereNoPositionFits(String formulation) {
    LoopModel model = model(sphericalPendulum(), formulation);
    double[] y = {3, 0, -0.8, 0, 0, 0};
    boolean closed = model.jump(0, y, new boolean[] {true, false, false, false, false, false});
    assertThat(closed).isTrue();
    assertThat(Math.hypot(y[0], Math.hypot(y[1], y[2]))).isCloseTo(1, within(1e-12));
  }

  /** Along every motion that the loops and what was set leave free, no momentum is put in. */
  @MethodSource("seeds")
  @ParameterizedTest
  void impulsesLieAlongTheConstraints(long seed) {
    Mechanism mechanism = LoopComparison.mechanism(seed);
    LoopModel model = model(mechanism, seed % 2 == 0 ? "DSR" : "DSR penalty");
    Random random = new Random(seed);
    double[] y = model.closed.start().state();
    int nq = model.work.nq;
    int n = model.work.nv;
    boolean[] set = new boolean[y.length];
    set[nq + random.nextInt(n)] = true;
    double[] before = new double[n];
    for (int k = 0; k < n; k++) {
      y[nq + k] += set[nq + k] ? 0 : random.nextDouble() - 0.5;
      before[k] = y[nq + k];
    }
    assertThat(model.jump(0, y, set)).isTrue();
    model.work.place(0, y);
    assertThat(model.work.loops.worst(model.work.loops.rate)).isNotNegative();
    for (double rate : model.work.loops.rate) {
      assertThat(rate).isCloseTo(0, within(1e-11));
    }
    model.work.formMass();
    double[] impulse = new double[n];
    double largest = 0;
    for (int i = 0; i < n; i++) {
      for (int k = 0; k < n; k++) {
        impulse[i] += model.work.mass()[i * n + k] * (y[nq + k] - before[k]);
      }
      largest = Math.max(largest, Math.abs(impulse[i]));
    }
    RealMatrix free = freeDirections(model, set);
    for (double momentum : free.preMultiply(impulse)) {
      assertThat(momentum).as("seed %s", seed).isCloseTo(0, within(1e-9 * (1 + largest)));
    }
  }

  /** Motions that obey the loops and do not move what was set, one per column. */
  private static RealMatrix freeDirections(LoopModel model, boolean[] set) {
    int n = model.work.nv;
    int m = model.work.loops.count();
    RealMatrix rows = new Array2DRowRealMatrix(m + 2 * n, n);
    for (int k = 0; k < n; k++) {
      for (int row = 0; row < m; row++) {
        rows.setEntry(row, k, model.work.loops.jacobian.get(row, k));
      }
      rows.setEntry(m + k, k, set[model.work.nq + k] ? 1 : 0);
    }
    SingularValueDecomposition svd = new SingularValueDecomposition(rows);
    int rank = svd.getRank();
    return rank == n
        ? new Array2DRowRealMatrix(n, 1)
        : svd.getV().getSubMatrix(0, n - 1, rank, n - 1);
  }
}
