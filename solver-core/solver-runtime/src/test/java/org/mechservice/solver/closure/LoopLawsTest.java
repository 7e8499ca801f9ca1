package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.solver.api.JointType.C;
import static org.mechservice.solver.api.JointType.R;
import static org.mechservice.solver.api.JointType.S;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.text.Origin;

/** What does not depend on how a loop is written down. */
class LoopLawsTest {
  private static final List<JointType> REDUNDANT = List.of(R, R, R, R);
  private static final int PLACE = 7;
  private static final List<JointType> EXACT = List.of(R, R, S, C);

  /** Positions and Euler parameters of all bodies at every output time. */
  private static List<double[]> poses(
      Mechanism mechanism, String formulation, String integrator, double tolerance) {
    RunSettings settings = new RunSettings(0, 2, 0.25, integrator, tolerance, tolerance / 100);
    LoopModel model = LoopModels.of(mechanism, formulation, settings);
    SceneRun run = SceneRun.of(model);
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    int states = model.description().stateCount();
    List<double[]> all = new ArrayList<>();
    for (double[] row : run.rows) {
      double[] y = new double[states];
      System.arraycopy(row, 1, y, 0, states);
      int bodies = mechanism.bodies().size();
      double[] poses = new double[BodyPoses.NUMBERS_PER_BODY * bodies];
      model.poses(row[0], y, poses);
      double[] places = new double[PLACE * bodies];
      for (int b = 0; b < bodies; b++) {
        System.arraycopy(poses, BodyPoses.NUMBERS_PER_BODY * b, places, PLACE * b, PLACE);
      }
      all.add(places);
    }
    return all;
  }

  /** Same up to a part of 1 + |x|, as references are compared with. */
  private static void assertSame(List<double[]> actual, List<double[]> expected, double within) {
    assertThat(actual).hasSameSizeAs(expected);
    for (int row = 0; row < actual.size(); row++) {
      for (int i = 0; i < expected.get(row).length; i++) {
        double value = expected.get(row)[i];
        assertThat(actual.get(row)[i])
            .as("row %s, number %s", row, i)
            .isCloseTo(value, within(within * (1 + Math.abs(value))));
      }
    }
  }

  private static final List<double[]> FOUR_BAR =
      poses(Linkages.fourBar(EXACT, 3), "DSR", "ode113", 1e-12);

  @ParameterizedTest
  @CsvSource({"0", "1", "2"})
  void fourBarMovesTheSameWhicheverJointIsCut(int cut) {
    assertSame(poses(Linkages.fourBar(EXACT, cut), "DSR", "ode113", 1e-12), FOUR_BAR, 1e-9);
  }

  @ParameterizedTest
  @CsvSource({"0", "1", "2", "3"})
  void redundantFourBarMovesAsItsTwinWithoutRedundancy(int cut) {
    assertSame(poses(Linkages.fourBar(REDUNDANT, cut), "DSR", "ode113", 1e-12), FOUR_BAR, 1e-9);
  }

  @ParameterizedTest
  @CsvSource({
    "DSR penalty, ode113, 1e-11, 1e-8",
    "RR, ode15sR, 1e-8, 1e-4",
    "RR-JF, ode15sR, 1e-8, 1e-4",
    "RR penalty, ode15sR, 1e-8, 1e-4",
    "RR-JF penalty, ode15sR, 1e-8, 1e-4"
  })
  void redundantFourBarMovesTheSameInEveryFormulation(
      String formulation, String integrator, double tolerance, double within) {
    assertSame(
        poses(Linkages.fourBar(REDUNDANT, 3), formulation, integrator, tolerance),
        FOUR_BAR,
        within);
  }

  /** Neither loops of one equation too many nor loose tolerances make steps collapse. */
  @CsvSource({"RR penalty, 1e-4", "RR-JF penalty, 1e-4", "RR-JF penalty, 1e-6"})
  @ParameterizedTest
  void stabilisedEquationsTakeNotManyMoreStepsThanIndependentCoordinates(
      String formulation, double tolerance) {
    for (List<JointType> types : List.of(EXACT, REDUNDANT)) {
      RunSettings settings = new RunSettings(0, 2, 0.25, "ode15sR", tolerance, tolerance / 100);
      long independent =
          LoopModels.run(Linkages.fourBar(types, 3), "RR-JF", settings).report.steps();
      long stabilised =
          LoopModels.run(Linkages.fourBar(types, 3), formulation, settings).report.steps();
      assertThat(stabilised).isLessThan(3 * independent);
    }
  }

  @Test
  void aCutJointDrivenMovesAsOneOfTheTreeDriven() {
    assertSame(
        poses(Linkages.fourBarDrivenAtCut(0.2), "DSR", "ode113", 1e-11),
        poses(Linkages.drivenFourBar(0.2), "DSR", "ode113", 1e-11),
        1e-8);
  }

  /** A way along the axis that follows the angle makes a screw of a cylindrical joint. */
  @Test
  void aCouplingOfAWayAndAnAngleIsAScrew() {
    double pitch = 0.3;
    Mechanism screw = Linkages.nut(List.of(), pitch);
    Expression way = new Expression.CoordinatePosition(new JointCoordinate(0, 0));
    Expression angle = new Expression.CoordinatePosition(new JointCoordinate(0, 1));
    Expression relation =
        new Expression.Sum(
            way, new Expression.Negation(new Expression.Product(Expression.of(pitch), angle)));
    Mechanism coupled =
        Linkages.nut(List.of(new CoordinateClosure("thread", relation, Origin.NONE)), 0);
    assertSame(poses(coupled, "DSR", "ode113", 1e-11), poses(screw, "DSR", "ode113", 1e-11), 1e-8);
  }
}
