package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.analysis.column.FurtherColumns;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelEvents.Action;
import org.mechservice.solver.api.capability.ModelEvents.Direction;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.StateChange;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Momentum of the whole is what acts on it from outside, added up: in a state and along a run. */
class MomentumTest {
  private static final Set<ColumnGroup> ASKED = EnumSet.of(ColumnGroup.MOMENTUM);
  private static final OptionalDouble UNWATCHED = OptionalDouble.empty();

  /** A run with its rows. */
  private static final class Run implements ResultSink {
    final List<double[]> rows = new ArrayList<>();
    final RunReport report;
    private int momentumAt;

    Run(Model model, Set<ColumnGroup> columns, OptionalDouble maxDrift, Checkpoints checkpoints)
        throws IOException {
      RunRequest request = new RunRequest(model.description().defaults(), columns, false, maxDrift);
      report = new RuntimeSolver().run(model, request, this, new RunControl(), checkpoints);
    }

    @Override
    public void begin(List<Variable> columns) {
      momentumAt = columns.stream().map(Variable::name).toList().indexOf("momentum.px");
    }

    @Override
    public void row(double[] values) {
      rows.add(values.clone());
    }

    double momentum(double[] row, int component) {
      return row[momentumAt + component];
    }

    double impulse(double[] row, int component) {
      return row[momentumAt + 6 + component];
    }

    /** Returns the largest change of one component of momentum less impulse. */
    double drift(int component) {
      double start = momentum(rows.get(0), component);
      return rows.stream()
          .mapToDouble(row -> momentum(row, component) - impulse(row, component) - start)
          .map(Math::abs)
          .max()
          .orElseThrow();
    }
  }

  private static Run run(Model model) throws IOException {
    return new Run(model, ASKED, UNWATCHED, Checkpoints.NONE);
  }

  private static Model model(
      Mechanism mechanism, String formulation, String closure, double end, double tolerance) {
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "ode113";
    RunSettings settings =
        new RunSettings(0, end, end / 20, integrator, tolerance, tolerance / 100);
    CompactModel data = new CompactModel(mechanism, formulation, closure, settings, List.of());
    ModelParts made = ModelParts.of(DataDriven.model(data, UserForceSource.NONE));
    ExplicitModel equations = (ExplicitModel) made.equations();
    return made.with(
        new FurtherColumns(equations, data, ASKED, UserForceSource.NONE, Optional.empty()));
  }

  private static Model fourBar(String formulation, String closure, double tolerance) {
    Mechanism scene = SharedScene.named("fourbar_redundant").mechanism();
    return model(scene, formulation, closure, 0.5, tolerance);
  }

  /** The rate by accelerations against reactions, which come from a sweep over forces. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void itsRateIsWeightAndReactionsOfTheGround(long seed) {
    Mechanism tree = RandomTrees.ofAllJoints(seed, 7);
    ColumnsAt columns = new ColumnsAt(tree, ColumnGroup.REACTIONS, ColumnGroup.MOMENTUM);
    double[] y = columns.start();
    Map<String, Double> found = columns.at(0, y);
    MomentumBalance balance = columns.columns.momentum().orElseThrow();
    balance.add(1, 0, y);
    Map<String, Double> after = columns.at(0, y);

    EquationsOfMotion at = new EquationsOfMotion(tree, UserForceSource.NONE);
    at.place(0, y);
    double mass = tree.bodies().stream().mapToDouble(Body::mass).sum();
    double[] center = new double[3];
    double[] place = new double[3];
    for (int link = 0; link < at.tree.linkCount; link++) {
      at.motion.points.position(link, at.tree.centerOfMass, 3 * link, place, 0);
      for (int i = 0; i < 3; i++) {
        center[i] += at.tree.mass[link] / mass * place[i];
      }
    }
    Vector3 force = tree.gravity().times(mass);
    Vector3 moment = Vector3.ZERO;
    for (Joint joint : tree.joints()) {
      Attachment attachment = joint.attachment();
      if (attachment.parent() < 0) {
        Vector3 exerted = vector(ColumnsAt.vector(found, joint.name(), "f"));
        int link = at.tree.linkOf(attachment.child());
        double[] point = new double[3];
        at.tree.fromReference(new BodyPoint(attachment.child(), attachment.childPoint()), point, 0);
        at.motion.points.position(link, point, 0, place, 0);
        Vector3 lever = vector(place).minus(vector(center));
        force = force.plus(exerted);
        moment =
            moment
                .plus(vector(ColumnsAt.vector(found, joint.name(), "t")))
                .plus(lever.cross(exerted));
      }
    }
    double scale = 1 + found.values().stream().mapToDouble(Math::abs).max().orElseThrow();
    // reactions come from sums over the whole tree, of the size of the largest of them
    assertClose(after, "impulse.p", force, 2e-12 * scale);
    assertClose(after, "impulse.l", moment, 2e-12 * scale);
  }

  private static Vector3 vector(double[] v) {
    return new Vector3(v[0], v[1], v[2]);
  }

  private static void assertClose(
      Map<String, Double> values, String name, Vector3 expected, double tolerance) {
    assertThat(ColumnsAt.value(values, name + "x")).isCloseTo(expected.x(), within(tolerance));
    assertThat(ColumnsAt.value(values, name + "y")).isCloseTo(expected.y(), within(tolerance));
    assertThat(ColumnsAt.value(values, name + "z")).isCloseTo(expected.z(), within(tolerance));
  }

  /**
   * Only its weight acts on it, at its centre of mass, whose place at the start the moment is of.
   */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void floatingTreeTakesUpItsWeightAlone(long seed) throws IOException {
    Mechanism tree = RandomTrees.floating(seed, 4);
    Run run = run(model(tree, "DTR", "none", 0.2, 1e-9));
    assertThat(run.report.outcome()).isEqualTo(new Outcome.Completed());
    double mass = tree.bodies().stream().mapToDouble(Body::mass).sum();
    Vector3 weight = tree.gravity().times(mass);
    double[] last = run.rows.get(run.rows.size() - 1);
    double t = last[0];
    double[] expected = {weight.x() * t, weight.y() * t, weight.z() * t};
    for (int i = 0; i < 3; i++) {
      // rounding of accelerations, and their sums over the tree
      assertThat(run.impulse(last, i)).isCloseTo(expected[i], within(1e-9 * weight.norm()));
    }
    double size = Math.abs(run.momentum(last, 5)) + weight.norm();
    for (int i = 0; i < 6; i++) {
      // a hundred steps, each held to 1e-9
      assertThat(run.drift(i)).isLessThan(1e-6 * size);
    }
    assertThat(run.report.notes()).anyMatch(note -> note.code() == MessageCode.MOMENTUM_BALANCE);
  }

  @ParameterizedTest
  @CsvSource({"DSR, projection", "DSR, penalty", "RR-JF, projection", "RR-JF, penalty"})
  void loopsKeepTheBalanceAndTheRowsTheirBits(String formulation, String closure)
      throws IOException {
    Run with = run(fourBar(formulation, closure, 1e-8));
    Run without =
        new Run(fourBar(formulation, closure, 1e-8), Set.of(), UNWATCHED, Checkpoints.NONE);
    assertThat(with.rows).hasSameSizeAs(without.rows);
    for (int i = 0; i < with.rows.size(); i++) {
      double[] states = Arrays.copyOf(with.rows.get(i), without.rows.get(i).length);
      assertThat(states).containsExactly(without.rows.get(i));
    }
    for (int i = 0; i < 6; i++) {
      // some hundred steps, each held to 1e-8
      assertThat(with.drift(i)).isLessThan(1e-5);
    }
  }

  /** At a tolerance of 1e-4 this tree's momentum drifts by more of its scale than its energy. */
  @Test
  void runEndsWhereMomentumDriftsThoughEnergyDoesNot() throws IOException {
    Model tree = model(RandomTrees.floating(5, 4), "DTR", "none", 0.5, 1e-4);
    double bound = 1.5e-6;
    Run watched = new Run(tree, ASKED, OptionalDouble.of(bound), Checkpoints.NONE);
    Failure failure = ((Outcome.Failed) watched.report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.MOMENTUM_DRIFT);
    assertThat(failure.cause()).contains("momentum").contains("1.5E-6 is allowed");
    double[] last = watched.rows.get(watched.rows.size() - 1);
    assertThat(failure.time()).isEqualTo(last[0]).isLessThan(0.5);

    Run energyAlone = new Run(tree, Set.of(), OptionalDouble.of(bound), Checkpoints.NONE);
    assertThat(energyAlone.report.outcome()).isEqualTo(new Outcome.Completed());
  }

  private static Mechanism bouncingBall() {
    Vector3 up = new Vector3(0, 0, 1);
    Body mass = new Body("ball", 2, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE);
    Attachment at = new Attachment(-1, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
    Joint slide = new Prismatic("z", at, up, 1, 0, Origin.NONE);
    JointCoordinate height = new JointCoordinate(0, 0);
    StateChange back =
        new StateChange(
            0,
            List.of(),
            List.of(new Product(Expression.of(-0.8), new CoordinateVelocity(height))));
    Event bounce =
        new Event(
            "bounce",
            new CoordinatePosition(height),
            Direction.FALLING,
            Action.SET,
            List.of(back),
            Origin.NONE);
    return new Mechanism(
            "Ball",
            new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
            up.times(-9.81),
            List.of(mass),
            List.of(slide))
        .withEvents(List.of(bounce));
  }

  @Test
  void whatAnEventSetsIsAnImpulse() throws IOException {
    Run run = run(model(bouncingBall(), "DTR", "none", 2, 1e-9));
    assertThat(run.report.notes()).anyMatch(note -> note.code() == MessageCode.EVENT_OCCURRED);
    // parabolas are exact but for rounding and the time of the bounce
    assertThat(run.drift(2)).isLessThan(1e-11);
    double[] last = run.rows.get(run.rows.size() - 1);
    assertThat(run.impulse(last, 2)).isNotCloseTo(-2 * 9.81 * last[0], within(1.0));
  }

  @Test
  void runTakenUpGoesOnWithItsBalance() throws IOException {
    List<byte[]> kept = new ArrayList<>();
    Run whole =
        new Run(
            model(bouncingBall(), "DTR", "none", 2, 1e-9),
            ASKED,
            UNWATCHED,
            checkpoints(kept, Optional.empty()));
    assertThat(kept).hasSizeGreaterThan(10);
    for (byte[] saved : List.copyOf(kept)) {
      Run rest =
          new Run(
              model(bouncingBall(), "DTR", "none", 2, 1e-9),
              ASKED,
              UNWATCHED,
              checkpoints(new ArrayList<>(), Optional.of(saved)));
      int missing = whole.rows.size() - rest.rows.size();
      for (int i = 0; i < rest.rows.size(); i++) {
        assertThat(rest.rows.get(i)).containsExactly(whole.rows.get(missing + i));
      }
      assertThat(rest.report.notes()).isEqualTo(whole.report.notes());
    }
  }

  private static Checkpoints checkpoints(List<byte[]> kept, Optional<byte[]> saved) {
    return new Checkpoints() {
      @Override
      public String modelHash() {
        return "cafe";
      }

      @Override
      public double secondsBetween() {
        return 0;
      }

      @Override
      public Optional<byte[]> saved() {
        return saved;
      }

      @Override
      public void keep(byte[] checkpoint) {
        kept.add(checkpoint);
      }
    };
  }
}
