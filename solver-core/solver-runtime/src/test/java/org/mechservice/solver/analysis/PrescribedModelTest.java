package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
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
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Function;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.simulation.RuntimeSolver;

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
      RunSettings settings = new RunSettings(0, end, 0.01, "none", 1e-5, 1e-5);
      CompactModel data = new CompactModel(mechanism, "kinematic", "none", settings);
      ExplicitModel model = new PrescribedModel(data, UserForceSource.NONE);
      Set<ColumnGroup> further = EnumSet.range(ColumnGroup.CONSTRAINTS, ColumnGroup.DRIVES);
      further.retainAll(ColumnGroup.of(groups));
      Model extended =
          ModelParts.of(model)
              .with(
                  new FurtherColumns(model, data, further, UserForceSource.NONE, Optional.empty()));
      RunRequest request = new RunRequest(settings, ColumnGroup.of(groups));
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
        of.parameters());
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
    Expression cosine = new Expression.Call(Function.COS, List.of(times(2, T)));
    Expression there = new Expression.Sum(Expression.of(0.5), times(-0.2, cosine));
    Rows found = new Rows(driven(2, there), 3, "joints");
    assertThat(failure(found)).startsWith("N-062");
    assertThat(found.rows.get(found.rows.size() - 1)[0]).isLessThan(Math.PI / 2);
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
