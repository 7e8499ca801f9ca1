package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.analysis.column.FurtherColumns;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** The slider-crank, crank 0.2 m and rod 0.5 m, with its crank or its slider driven. */
class PrescribedModelTest {
  private static final double R = 0.2;
  private static final double L = 0.5;
  private static final Expression T = new Expression.Time();

  /** Rows of a run, and how it ended. */
  private static final class Rows implements ResultSink {
    final List<double[]> rows = new ArrayList<>();
    List<Variable> columns = List.of();
    RunReport report;

    Rows(Mechanism mechanism, double end, String groups) throws IOException {
      this(mechanism, end, groups, false, Set.of());
    }

    Rows(Mechanism mechanism, double end, String groups, boolean strict, Set<MessageCode> silenced)
        throws IOException {
      RunSettings settings = new RunSettings(0, end, 0.01, "none", 1e-5, 1e-5);
      CompactModel data = new CompactModel(mechanism, "kinematic", "none", settings);
      ExplicitModel model = new PrescribedModel(data, UserForceSource.NONE);
      Set<ColumnGroup> further = EnumSet.range(ColumnGroup.CONSTRAINTS, ColumnGroup.DRIVES);
      further.retainAll(ColumnGroup.of(groups));
      Model extended =
          ModelParts.of(model)
              .with(
                  new FurtherColumns(model, data, further, UserForceSource.NONE, Optional.empty()));
      RunRequest request =
          new RunRequest(
              settings, ColumnGroup.of(groups), strict, OptionalDouble.empty(), silenced);
      report = new RuntimeSolver().run(extended, request, this, new RunControl());
    }

    @Override
    public void begin(List<Variable> names) {
      columns = names;
    }

    @Override
    public void row(double[] values) {
      rows.add(values.clone());
    }

    double value(int row, String column) {
      for (int i = 0; i < columns.size(); i++) {
        if (columns.get(i).name().equals(column)) {
          return rows.get(row)[i];
        }
      }
      throw new AssertionError("no column " + column + " in " + columns);
    }
  }

  private static Mechanism driven(int joint, Expression motion) {
    Mechanism free = SharedScene.named("slider_crank_planar").mechanism();
    return new Mechanism(
        free.name(),
        free.root(),
        free.gravity(),
        free.bodies(),
        free.joints(),
        List.of(new PrescribedMotion(joint, List.of(motion))),
        Collections.nCopies(free.joints().size(), StartRole.PREFERRED),
        free.closures(),
        free.forces(),
        free.parameters());
  }

  private static Expression times(double factor, Expression x) {
    return new Expression.Product(Expression.of(factor), x);
  }

  @Test
  void sliderFollowsTheCrankAsTheClosedFormSays() throws IOException {
    double omega = 4;
    Rows found = new Rows(driven(0, times(omega, T)), 2, "joints,accelerations");
    assertThat(found.report.outcome()).isInstanceOf(Outcome.Completed.class);
    assertThat(found.rows).hasSize(201);
    for (int i = 0; i < found.rows.size(); i++) {
      double phi = omega * found.rows.get(i)[0];
      double sin = Math.sin(phi);
      double cos = Math.cos(phi);
      double root = Math.sqrt(L * L - R * R * sin * sin);
      double first = -R * sin - R * R * sin * cos / root;
      double second =
          -R * cos
              - R * R * (cos * cos - sin * sin) / root
              - R * R * R * R * sin * sin * cos * cos / (root * root * root);
      assertThat(found.value(i, "j_slider.q")).isCloseTo(R * cos + root, within(1e-13));
      assertThat(found.value(i, "j_slider.v")).isCloseTo(omega * first, within(1e-12));
      assertThat(found.value(i, "j_slider.a")).isCloseTo(omega * omega * second, within(1e-11));
    }
  }

  /** The crank's drive does all the work: its power is the rate of the energy. */
  @Test
  void drivingTorqueTimesSpeedIsTheRateOfTheEnergy() throws IOException {
    double omega = 4;
    Rows found = new Rows(driven(0, times(omega, T)), 1, "joints,energy,forces,drives");
    assertThat(found.rows).hasSize(101);
    for (int i = 3; i < found.rows.size() - 3; i++) {
      double rate =
          (45 * (energy(found, i + 1) - energy(found, i - 1))
                  - 9 * (energy(found, i + 2) - energy(found, i - 2))
                  + (energy(found, i + 3) - energy(found, i - 3)))
              / 0.6;
      double power = omega * found.value(i, "j_crank.drive");
      // the sixth derivative of the energy over 140, times h⁶: some 1e-6 of the power
      assertThat(power).isCloseTo(rate, within(1e-5 * 40));
      assertThat(found.value(i, "j_crank.power")).isEqualTo(power);
      assertThat(found.value(i, "j_crank.q")).isEqualTo(omega * found.rows.get(i)[0]);
    }
  }

  /** Simpson's rule errs by h⁴/180 of the fourth derivative of the power: some 4e-9 · 1e4. */
  @Test
  void workIsThePowerOfTheDrivesOverTime() throws IOException {
    Rows found = new Rows(driven(0, times(4, T)), 1, "joints,energy,drives");
    double work = 0;
    for (int i = 2; i < found.rows.size(); i += 2) {
      work +=
          0.01
              / 3
              * (found.value(i - 2, "j_crank.power")
                  + 4 * found.value(i - 1, "j_crank.power")
                  + found.value(i, "j_crank.power"));
      assertThat(found.value(i, "energy.work")).isCloseTo(work, within(1e-4));
    }
    assertThat(found.value(0, "energy.work")).isZero();
    assertThat(Math.abs(found.value(30, "energy.work"))).isGreaterThan(0.1);
  }

  /** The spatial loop with its first joint driven, be it of the tree or cut; columns tell it. */
  @Test
  void driveIsTheSameWhetherItsJointIsCutOrNot() throws IOException {
    Expression motion = new Expression.Product(T, T);
    Mechanism ofTree = SpatialLoop.cutAt(3, false, List.of());
    Mechanism ofCut = SpatialLoop.cutAt(0, false, List.of());
    JointClosure cut = (JointClosure) ofCut.closures().get(0);
    JointClosure driving = new JointClosure(cut.joint(), StartRole.PREFERRED, List.of(motion));
    Rows expected =
        new Rows(
            with(ofTree, List.of(new PrescribedMotion(0, List.of(motion))), ofTree.closures()),
            0.15,
            "joints,forces,drives");
    Rows found = new Rows(with(ofCut, List.of(), List.of(driving)), 0.15, "joints,forces,drives");
    assertThat(found.rows).hasSize(16);
    for (int i = 0; i < found.rows.size(); i++) {
      double drive = expected.value(i, "j0.drive");
      // the condition of the loop's equations is some hundreds
      assertThat(found.value(i, "j0.drive"))
          .isCloseTo(drive, within(1e-10 * (1 + Math.abs(drive))));
      for (Rows rows : List.of(expected, found)) {
        double t = rows.value(i, "t");
        assertThat(rows.value(i, "j0.q")).isEqualTo(t * t);
        assertThat(rows.value(i, "j0.v")).isEqualTo(2 * t);
        assertThat(rows.value(i, "j0.a")).isEqualTo(2);
        assertThat(rows.value(i, "j0.power")).isEqualTo(2 * t * rows.value(i, "j0.drive"));
      }
    }
  }

  private static Mechanism with(
      Mechanism of, List<PrescribedMotion> motions, List<LoopClosure> closures) {
    return new Mechanism(
            of.name(),
            of.root(),
            of.gravity(),
            of.bodies(),
            of.joints(),
            motions,
            of.startRoles(),
            closures,
            of.forces(),
            of.parameters())
        .withArmatures(of.armatures());
  }

  private static double energy(Rows found, int row) {
    return found.value(row, "energy.kinetic") + found.value(row, "energy.potential");
  }

  @Test
  void motionThatLeavesCoordinatesFreeIsRefused() throws IOException {
    Mechanism free = SharedScene.named("slider_crank_planar").mechanism();
    Rows found = new Rows(free, 1, "joints");
    assertThat(failure(found)).startsWith("N-060").contains("1 coordinate free, such as j_");
    assertThat(found.rows).isEmpty();
  }

  /** The slider is drawn out beyond the stretched linkage, at 0.7 m. */
  @Test
  void positionOutOfReachIsToldWithItsConstraint() throws IOException {
    Expression out = new Expression.Sum(Expression.of(0.6), times(0.2, T));
    Rows found = new Rows(driven(2, out), 1, "joints");
    assertThat(failure(found)).containsPattern("^N-06[12]");
    assertThat(found.rows.get(found.rows.size() - 1)[0]).isBetween(0.4, 0.5);
  }

  /** At the dead centre the slider does not say which way the crank goes on. */
  @Test
  void deadCentreIsTold() throws IOException {
    Expression cosine = new Expression.Call(MathFunction.COS, List.of(times(2, T)));
    Expression there = new Expression.Sum(Expression.of(0.5), times(-0.2, cosine));
    Rows found = new Rows(driven(2, there), 3, "joints");
    assertThat(failure(found)).startsWith("N-062");
    assertThat(found.rows.get(found.rows.size() - 1)[0]).isLessThan(Math.PI / 2);
  }

  /** A body that slides along z under gravity, on as many driven slides as there are motions. */
  private static Mechanism onSlides(int drives, Expression motion) {
    Vector3 z = new Vector3(0, 0, 1);
    Attachment both = new Attachment(-1, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
    List<LoopClosure> cut = new ArrayList<>();
    for (int i = 1; i < drives; i++) {
      Prismatic slide = new Prismatic("z" + i, both, z, 0, 0, Origin.NONE);
      cut.add(new JointClosure(slide, StartRole.PREFERRED, List.of(motion)));
    }
    return new Mechanism(
        "slides",
        new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
        new Vector3(0, 0, -9.81),
        List.of(
            new Body("body", 2, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE)),
        List.of(new Prismatic("z0", both, z, 0, 0, Origin.NONE)),
        List.of(new PrescribedMotion(0, List.of(motion))),
        List.of(StartRole.PREFERRED),
        cut,
        List.of(),
        List.of());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 7})
  void drivesOfOneFreedomShareItsForceEvenly(int drives) throws IOException {
    Expression motion = times(0.1, new Expression.Call(MathFunction.SIN, List.of(times(3, T))));
    Rows found = new Rows(onSlides(drives, motion), 0.5, "joints,forces,reactions,drives");
    for (int row = 0; row < found.rows.size(); row++) {
      double t = found.rows.get(row)[0];
      double force = 2 * (9.81 - 0.9 * Math.sin(3 * t));
      for (int i = 0; i < drives; i++) {
        assertThat(found.value(row, "z" + i + ".drive")).isCloseTo(force / drives, within(1e-13));
        assertThat(found.value(row, "z" + i + ".fz")).isCloseTo(force / drives, within(1e-13));
      }
    }
    assertThat(found.report.notes())
        .filteredOn(note -> note.code() == MessageCode.REDUNDANT_CONSTRAINTS)
        .hasSize(drives == 1 ? 0 : 1)
        .allSatisfy(note -> assertThat(note.text()).contains("\"z0\", \"z1\""));
  }

  /**
   * Crank and slider are driven so that they fit: torque and force do the work that the torque of
   * the crank alone does, τ + s'(φ) F, and the least norm has F proportional to s'(φ) τ.
   */
  @Test
  void crankAndSliderShareWorkByTheLeastNorm() throws IOException {
    Expression angle = new Expression.Sum(Expression.of(0.3), times(4, T));
    Expression sin = new Expression.Call(MathFunction.SIN, List.of(angle));
    Expression along = times(R, new Expression.Call(MathFunction.COS, List.of(angle)));
    Expression under =
        new Expression.Sum(Expression.of(L * L), times(-R * R, new Expression.Product(sin, sin)));
    Expression way =
        new Expression.Sum(along, new Expression.Call(MathFunction.SQRT, List.of(under)));
    Rows alone = new Rows(driven(0, angle), 1, "joints,forces,reactions,drives");
    Mechanism both =
        with(
            driven(0, angle),
            List.of(new PrescribedMotion(0, List.of(angle)), new PrescribedMotion(2, List.of(way))),
            driven(0, angle).closures());
    Rows found = new Rows(both, 1, "joints,forces,reactions,drives");
    assertThat(found.report.notes())
        .anyMatch(note -> note.text().contains("\"j_crank\", \"j_slider\""));
    double perTorque = Double.NaN;
    int compared = 0;
    for (int row = 0; row < found.rows.size(); row++) {
      double phi = 0.3 + 4 * found.rows.get(row)[0];
      double root = Math.sqrt(L * L - R * R * Math.sin(phi) * Math.sin(phi));
      double slope = -R * Math.sin(phi) - R * R * Math.sin(phi) * Math.cos(phi) / root;
      double torque = found.value(row, "j_crank.drive");
      double force = found.value(row, "j_slider.drive");
      double expected = alone.value(row, "j_crank.drive");
      // forces of some hundreds, by equations of condition some ten
      assertThat(torque + slope * force).isCloseTo(expected, within(1e-10));
      double share = force / (slope * torque);
      if (Math.abs(slope * torque) > 1e-3) {
        assertThat(share).isPositive();
        perTorque = Double.isNaN(perTorque) ? share : perTorque;
        assertThat(share).isCloseTo(perTorque, within(1e-8 * perTorque));
        compared++;
      }
    }
    // The torque and the slope are 0 at single instants alone.
    assertThat(compared).isGreaterThan(90);
  }

  /** A second slide without a drive holds nothing along z; a body that is fixed as well does. */
  @Test
  void loopThatForbidsTheDrivenFreedomTakesTheForceOfTheDrive() throws IOException {
    Mechanism slides = onSlides(1, Expression.of(0));
    BodyPoint ofGround = new BodyPoint(-1, new Vector3(0, 0, -1));
    BodyPoint ofBody = new BodyPoint(0, Vector3.ZERO);
    Mechanism hung =
        with(
            slides,
            slides.motions(),
            List.of(new DistanceClosure("rod", ofGround, ofBody, 1, 0, Origin.NONE)));
    Rows found = new Rows(hung, 0.1, "joints,constraints,forces,drives");
    for (int row = 0; row < found.rows.size(); row++) {
      assertThat(found.value(row, "z0.drive")).isCloseTo(0, within(1e-13));
      assertThat(found.value(row, "rod.lambda")).isCloseTo(-19.62, within(1e-13));
    }
    assertThat(found.report.notes()).anyMatch(note -> note.text().contains("\"z0\""));
  }

  /** A triangle wave: its corners are jumps of the velocity, between which nothing accelerates. */
  private static Expression triangles() {
    Expression late = new Expression.Sum(T, Expression.of(-0.255));
    return new Expression.Call(MathFunction.ABS, List.of(late));
  }

  @Test
  void jumpsOfVelocityAreToldAsWarnings() throws IOException {
    Rows found = new Rows(onSlides(1, triangles()), 0.5, "joints,forces");
    assertThat(found.report.outcome()).isInstanceOf(Outcome.Completed.class);
    assertThat(found.report.notes())
        .singleElement()
        .satisfies(note -> assertThat(note.code()).isEqualTo(MessageCode.DRIVEN_VELOCITY_JUMPED))
        .satisfies(note -> assertThat(note.warning()).isTrue())
        .satisfies(note -> assertThat(note.time()).isCloseTo(0.255, within(1e-12)))
        .satisfies(note -> assertThat(note.text()).contains("\"z0\" jumps from -1.000 to 1.000"));
  }

  @Test
  void jumpOfVelocityEndsAStrictRunUnlessItIsSilenced() throws IOException {
    Mechanism slide = onSlides(1, triangles());
    Rows strict = new Rows(slide, 0.5, "joints,forces", true, Set.of());
    assertThat(failure(strict)).startsWith("N-027");
    assertThat(strict.rows).hasSize(26);
    Set<MessageCode> silenced = Set.of(MessageCode.DRIVEN_VELOCITY_JUMPED);
    Rows silent = new Rows(slide, 0.5, "joints,forces", true, silenced);
    assertThat(silent.report.outcome()).isInstanceOf(Outcome.Completed.class);
    assertThat(silent.report.notes()).isEmpty();
  }

  @Test
  void jumpOfPositionEndsTheRun() throws IOException {
    Expression late = new Expression.Sum(T, Expression.of(-0.25));
    Expression step = new Expression.Call(MathFunction.STEP, List.of(late));
    Rows found = new Rows(onSlides(1, step), 0.5, "joints");
    assertThat(failure(found)).startsWith("N-026");
    assertThat(found.rows).hasSize(25);
  }

  private static String failure(Rows found) {
    assertThat(found.report.outcome()).isInstanceOf(Outcome.Failed.class);
    return ((Outcome.Failed) found.report.outcome()).failure().message();
  }

  @Test
  void everyRowAsksForNoIntegrator() throws IOException {
    Rows found = new Rows(driven(0, times(1, T)), 0.1, "joints");
    assertThat(found.report.settings().integrator()).isEqualTo("none");
    assertThat(Set.of(found.report.formulation())).containsExactly("kinematic");
  }
}
