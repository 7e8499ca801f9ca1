package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.assembly.Assembly;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Joint;

/** Mechanisms large enough for their matrices to be kept in their sparsity. */
class LargeLoopsTest {
  private static final int WINDOWS = 60;
  private static final double SPEED = 1;
  private static final double GRAVITY = 9.81;

  /**
   * Angles of an upright at 0, 0.1, … 0.5 s: windows in a row move as one pendulum. n + 1 uprights
   * of 1 kg, 1 m and 0.001 kg·m² more than a rod has turn about their feet, n couplers of 1 kg move
   * with their tops.
   */
  private static double[] pendulum(int windows) {
    return pendulum(windows, 1);
  }

  /** Likewise, with couplers of any mass. */
  private static double[] pendulum(int windows, double couplerMass) {
    double inertia = (windows + 1) * (1 / 3.0 + 1e-3) + windows * couplerMass;
    double moment = GRAVITY * ((windows + 1) / 2.0 + windows * couplerMass);
    FirstOrderDifferentialEquations equation =
        new FirstOrderDifferentialEquations() {
          @Override
          public int getDimension() {
            return 2;
          }

          @Override
          public void computeDerivatives(double t, double[] y, double[] yDot) {
            yDot[0] = y[1];
            yDot[1] = moment / inertia * Math.sin(y[0]);
          }
        };
    DormandPrince853Integrator integrator =
        new DormandPrince853Integrator(1e-12, 0.05, 1e-13, 1e-13);
    double[] angles = new double[6];
    double[] y = {0, SPEED};
    for (int i = 1; i < angles.length; i++) {
      integrator.integrate(equation, 0.1 * (i - 1), y, 0.1 * i, y);
      angles[i] = y[0];
    }
    return angles;
  }

  @ParameterizedTest
  @CsvSource({
    "DSR, ode113, 1e-9",
    "DSR penalty, ode113, 1e-9",
    "DSR, ode15s, 1e-6",
    "RR penalty, ode15sR, 1e-6",
    "RR-JF, ode15sR, 1e-6",
    "RR-JF penalty, ode15sR, 1e-6"
  })
  void windowsInARowSwingAsOnePendulum(String formulation, String integrator, double tolerance) {
    RunSettings settings = SceneRun.settings(0.5, 0.1, integrator, tolerance);
    SceneRun run = LoopModels.run(Linkages.windows(WINDOWS, SPEED), formulation, settings);
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    double[] angles = pendulum(WINDOWS);
    for (int row = 0; row < angles.length; row++) {
      for (int i = 0; i <= WINDOWS; i++) {
        // error ≤ 10 rtol, the run's promise
        assertThat(run.rows.get(row)[1 + i]).isCloseTo(angles[row], within(10 * tolerance));
        if (i > 0) {
          double coupler = run.rows.get(row)[1 + WINDOWS + i];
          assertThat(coupler).isCloseTo(-angles[row], within(10 * tolerance));
        }
      }
    }
  }

  /** The joints of their couplers have no pivot before the loops are closed. */
  @Test
  void windowsWithMasslessCouplersSwingAsOnePendulum() {
    RunSettings settings = SceneRun.settings(0.5, 0.1, "ode113", 1e-9);
    SceneRun run = LoopModels.run(Linkages.windows(WINDOWS, SPEED, 0), "DSR", settings);
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    double[] angles = pendulum(WINDOWS, 0);
    for (int row = 0; row < angles.length; row++) {
      for (int i = 0; i <= WINDOWS; i++) {
        // error ≤ 10 rtol, the run's promise
        assertThat(run.rows.get(row)[1 + i]).isCloseTo(angles[row], within(1e-8));
      }
    }
  }

  /** Many degrees of freedom: neither R nor the matrix along the loops may be formed. */
  @ParameterizedTest
  @CsvSource({
    "DSR, ode113, 1e-9",
    "DSR, ode15s, 1e-6",
    "RR, ode15sR, 1e-6",
    "RR-JF, ode15sR, 1e-6",
    "RR-JF penalty, ode15sR, 1e-6"
  })
  void separateWindowsSwingAsPendulums(String formulation, String integrator, double tolerance) {
    int count = 110;
    RunSettings settings = SceneRun.settings(0.5, 0.1, integrator, tolerance);
    Mechanism windows = Linkages.separateWindows(count, SPEED);
    SceneRun run = LoopModels.run(windows, formulation, settings);
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    double[] angles = pendulum(1);
    for (int row = 0; row < angles.length; row++) {
      for (int i = 0; i < count; i++) {
        // error ≤ 10 rtol, the run's promise
        assertThat(run.rows.get(row)[1 + 3 * i]).isCloseTo(angles[row], within(10 * tolerance));
        assertThat(run.rows.get(row)[3 + 3 * i]).isCloseTo(-angles[row], within(10 * tolerance));
      }
    }
  }

  /** Hinges in place of points on lines: three of the five equations of each repeat the others. */
  @Test
  void everyRedundantEquationIsCountedAndNoneMatters() {
    Mechanism planar = Linkages.windows(WINDOWS, SPEED);
    List<LoopClosure> hinges = new ArrayList<>();
    List<Body> bodies = planar.bodies();
    List<Joint> joints = planar.joints();
    for (int i = 1; i <= WINDOWS; i++) {
      Joint hinge =
          new Linkages.Hinge(
                  "window" + i,
                  JointType.R,
                  i,
                  WINDOWS + i,
                  Linkages.X.times(i).plus(Linkages.Z),
                  Linkages.Y)
              .joint();
      hinges.add(new JointClosure(hinge));
    }
    Mechanism spatial = Linkages.mechanism("spatial windows", bodies, joints, hinges);
    RunSettings settings = SceneRun.settings(0.5, 0.1, "ode113", 1e-8);
    ClosedMechanism closed = new ClosedMechanism(spatial, "DSR", settings);
    assertThat(closed.freedom()).isEqualTo(1);
    assertThat(closed.start().rank()).isEqualTo(2 * WINDOWS);
    LoopFinding redundant = closed.start().findings().get(0);
    assertThat(redundant.kind()).isEqualTo(LoopFinding.Kind.REDUNDANT);
    for (int i = 1; i <= WINDOWS; i++) {
      assertThat(redundant.part()).contains("\"window" + i + "\"");
    }
    double[] angles = pendulum(WINDOWS);
    for (String formulation : List.of("DSR", "DSR penalty")) {
      SceneRun run = LoopModels.run(spatial, formulation, settings);
      assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
      assertThat(run.rows.get(5)[1]).isCloseTo(angles[5], within(1e-7));
      assertThat(run.rows.get(5)[1 + WINDOWS]).isCloseTo(angles[5], within(1e-7));
    }
  }

  /** The freedoms of a few windows are those of many, whichever way their rank is found. */
  @ParameterizedTest
  @ValueSource(ints = {1, 5, 49, 50, 51, 120})
  void windowsHaveOneFreedomHoweverManyTheyAre(int windows) {
    RunSettings settings = SceneRun.settings(0.5, 0.1, "ode113", 1e-8);
    ClosedMechanism closed = new ClosedMechanism(Linkages.windows(windows, SPEED), "DSR", settings);
    assertThat(closed.freedom()).isEqualTo(1);
    assertThat(closed.start().findings()).isEmpty();
  }

  @Test
  void aWideRingMovesAlikeByBothClosures() {
    RunSettings settings = SceneRun.settings(0.3, 0.1, "ode113", 1e-8);
    SceneRun byProjection = LoopModels.run(Linkages.ring(150), "DSR", settings);
    SceneRun byPenalty = LoopModels.run(Linkages.ring(150), "DSR penalty", settings);
    assertThat(byPenalty.rows).hasSameSizeAs(byProjection.rows);
    for (int row = 0; row < byPenalty.rows.size(); row++) {
      for (int i = 0; i < 150; i++) {
        double expected = byProjection.rows.get(row)[i];
        assertThat(byPenalty.rows.get(row)[i]).isCloseTo(expected, within(1e-6));
      }
    }
  }

  /**
   * Its implicit steps are eliminated from link to link; a wrong matrix would need more of them.
   */
  @ParameterizedTest
  @ValueSource(strings = {"RR-JF", "RR-JF penalty"})
  void aWideRingIsSteppedByItsOwnMatrix(String formulation) {
    Mechanism ring = Linkages.ring(150);
    SceneRun expected = LoopModels.run(ring, "DSR", SceneRun.settings(0.2, 0.1, "ode113", 1e-8));
    SceneRun run = LoopModels.run(ring, formulation, SceneRun.settings(0.2, 0.1, "ode15sR", 1e-6));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    assertThat(run.report.evaluations()).isLessThanOrEqualTo(4 * run.report.steps());
    for (int row = 0; row < run.rows.size(); row++) {
      for (int i = 1; i <= 150; i++) {
        // error ≤ 10 rtol, the run's promise
        assertThat(run.rows.get(row)[i]).isCloseTo(expected.rows.get(row)[i], within(1e-5));
      }
    }
  }

  /** Angles and velocities that do not close the loops are moved until they do. */
  @Test
  void aStartOffTheLoopsIsAssembled() {
    Mechanism row = Linkages.windows(WINDOWS, SPEED);
    double[] y = new double[row.positionCount() + row.velocityCount()];
    row.initialState(y);
    for (int i = 1; i <= WINDOWS; i++) {
      y[i] = 0.02 * (i % 3);
      y[row.positionCount() + i] = 0;
    }
    TreeGeometry tree = new TreeGeometry(row);
    List<LoopFinding> findings = new Assembly(tree).assemble(0, y);
    assertThat(findings)
        .extracting(LoopFinding::kind)
        .containsExactly(LoopFinding.Kind.START_MOVED, LoopFinding.Kind.START_VELOCITY_CHANGED);
    for (int i = 1; i <= WINDOWS; i++) {
      assertThat(y[i]).isCloseTo(y[0], within(1e-12));
      assertThat(y[row.positionCount() + i]).isCloseTo(y[row.positionCount()], within(1e-11));
    }
  }
}
