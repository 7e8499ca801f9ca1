package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.FiveBarPendulum;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Columns that are computed apart from the model. */
class FurtherColumnsTest {
  @Test
  void outputsAreValuesOfTheirExpressions() {
    Mechanism pendulum = FiveBarPendulum.mechanism();
    Expression tip = new Expression.PointPosition(new BodyPoint(4, new Vector3(1, 0, 0)), 0);
    Expression angle = new Expression.CoordinatePosition(new JointCoordinate(0, 0));
    List<Output> outputs =
        List.of(
            new Output("tip", tip, "m", Origin.NONE),
            new Output("doubled", new Expression.Sum(angle, angle), "rad", Origin.NONE));
    ColumnsAt columns = new ColumnsAt(pendulum, outputs, ColumnGroup.OUTPUTS);
    double[] y = columns.start();
    y[4] = Math.PI / 3;
    assertThat(columns.columns.columns(ColumnGroup.OUTPUTS))
        .containsExactly(new Variable("tip", "m"), new Variable("doubled", "rad"));
    // four bars ahead and one turned by 60 degrees
    assertThat(columns.at(0, y).get("tip")).isCloseTo(4.5, within(1e-14));
    y[0] = 0.25;
    assertThat(columns.at(0, y).get("doubled")).isEqualTo(0.5);
  }

  @Test
  void residualsSayHowFarLoopsAreFromClosed() {
    SharedScene scene = SharedScene.named("slider_crank_planar");
    ColumnsAt columns = new ColumnsAt(scene.mechanism(), ColumnGroup.CONSTRAINTS);
    double[] y = columns.start();
    Map<String, Double> closed = columns.at(0, y);
    assertThat(closed.get("constraint.position")).isLessThan(1e-15);
    assertThat(closed.get("constraint.velocity")).isLessThan(1e-13);
    y[2] += 0.01; // the slider alone
    y[5] += 0.1;
    Map<String, Double> open = columns.at(0, y);
    assertThat(open.get("constraint.position")).isCloseTo(0.01, within(1e-14));
    assertThat(open.get("constraint.velocity")).isCloseTo(0.1, within(1e-12));
  }

  @Test
  void constraintsOfLoopsHaveOneMultiplierPerEquation() {
    SharedScene scene = SharedScene.named("slider_crank_planar");
    ColumnsAt columns = new ColumnsAt(scene.mechanism(), ColumnGroup.CONSTRAINTS);
    assertThat(columns.columns.columns(ColumnGroup.CONSTRAINTS))
        .containsExactly(
            new Variable("constraint.position", "m"),
            new Variable("constraint.velocity", "m/s"),
            new Variable("pin.lambda[0]", "N"),
            new Variable("pin.lambda[1]", "N"));
  }

  /** A load of 2 kg that slides on two rails, in a vertical plane, hangs from a rod at rest. */
  @Test
  void multiplierOfARodIsItsTension() {
    Body carriage =
        new Body("carriage", 1, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE);
    Body load = new Body("load", 2, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE);
    Mechanism hanging =
        new Mechanism(
            "hanging",
            new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
            new Vector3(0, 0, -9.81),
            List.of(carriage, load),
            List.of(
                slider(Mechanism.ROOT, 0, new Vector3(1, 0, 0), 0),
                slider(0, 1, new Vector3(0, 0, 1), -0.5)),
            List.of(),
            List.of(StartRole.PREFERRED, StartRole.PREFERRED),
            List.of(
                new DistanceClosure(
                    "rod",
                    new BodyPoint(Mechanism.ROOT, Vector3.ZERO),
                    new BodyPoint(1, Vector3.ZERO),
                    0.5,
                    0,
                    Origin.NONE)),
            List.of(),
            List.of());
    ColumnsAt columns = new ColumnsAt(hanging, ColumnGroup.CONSTRAINTS);
    assertThat(columns.at(0, columns.start()).get("rod.lambda"))
        .isCloseTo(2 * 9.81, within(1e-12 * 9.81));
  }

  private static Prismatic slider(int parent, int child, Vector3 axis, double position) {
    Attachment attachment =
        new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
    return new Prismatic("slider" + child, attachment, axis, position, 0, Origin.NONE);
  }

  @Test
  void groupsNotAskedForAreTheModelsOwn() {
    SharedScene scene = SharedScene.named("driver_C0");
    ColumnsAt columns = new ColumnsAt(scene.mechanism(), ColumnGroup.FORCES);
    ColumnsAt others = new ColumnsAt(scene.mechanism(), ColumnGroup.REACTIONS);
    List<Variable> names = columns.columns.columns(ColumnGroup.FORCES);
    assertThat(others.columns.columns(ColumnGroup.FORCES)).isEqualTo(names);
    double[] own = new double[names.size()];
    double[] apart = new double[names.size()];
    columns.columns.values(ColumnGroup.FORCES, 0, columns.start(), own, 0);
    ((ResultColumns) others.model).values(ColumnGroup.FORCES, 0, others.start(), apart, 0);
    assertThat(own).containsExactly(apart);
  }

  @Test
  void groupsThatNobodyHasAreEmpty() {
    SharedScene scene = SharedScene.named("slider_crank_planar");
    ColumnsAt columns = new ColumnsAt(scene.mechanism(), ColumnGroup.REACTIONS);
    assertThat(columns.columns.columns(ColumnGroup.OUTPUTS)).isEmpty();
    columns.columns.values(ColumnGroup.OUTPUTS, 0, columns.start(), new double[0], 0);
  }

  @Test
  void openChainsHaveNoConstraints() {
    ColumnsAt columns = new ColumnsAt(FiveBarPendulum.mechanism(), ColumnGroup.CONSTRAINTS);
    assertThat(columns.columns.columns(ColumnGroup.CONSTRAINTS)).isEmpty();
    assertThat(columns.at(0, columns.start())).isEmpty();
  }
}
