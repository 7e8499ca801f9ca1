package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.FiveBarPendulum;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.simulation.RecordedRows;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Equilibria against closed forms and against motion that is damped until it rests. */
class StaticEquilibriumTest {
  private static final Root GROUND = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
  private static final Vector3 DOWN = new Vector3(0, 0, -10);
  private static final Vector3 Z = new Vector3(0, 0, 1);
  private static final Vector3 Y = new Vector3(0, 1, 0);

  private static StaticEquilibrium of(Mechanism mechanism) {
    return new StaticEquilibrium(mechanism, UserForceSource.NONE, 1e-12, 200);
  }

  private static Mechanism with(
      List<Body> bodies,
      List<Joint> joints,
      List<PrescribedMotion> motions,
      List<ForceElement> forces) {
    Mechanism tree = new Mechanism("statics", GROUND, DOWN, bodies, joints);
    return new Mechanism(
        tree.name(),
        tree.root(),
        tree.gravity(),
        bodies,
        joints,
        motions,
        tree.startRoles(),
        List.of(),
        forces,
        List.of());
  }

  private static ForceElement spring(int joint, double stiffness, double damping, Side side) {
    return new JointSpringDamper(
        "k" + joint,
        new JointCoordinate(joint, 0),
        Expression.of(stiffness),
        Expression.of(damping),
        Expression.ZERO,
        Expression.ZERO,
        side,
        Expression.of(side == Side.BOTH ? 0 : 1e-4),
        Origin.NONE);
  }

  private static Body mass(String name, double mass, Vector3 center) {
    return new Body(name, mass, center, InertiaTensor.ZERO, Origin.NONE);
  }

  private static Attachment at(int parent, int child) {
    return new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }

  /** Rods on hinges, level, askew or all but upright: they hang straight down after few steps. */
  @ParameterizedTest
  @CsvSource({
    "2, 0",
    "5, 0",
    "20, 0",
    "60, 0",
    "20, 0.5",
    "2, -1.57",
    "20, -1",
    "20, -1.5",
    "20, -1.57"
  })
  void aChainHangsDownAfterFewStepsHoweverLong(int n, double start) {
    StaticEquilibrium found = of(chain(n, start));
    assertThat(found.find(0)).isTrue();
    assertThat(found.iterations()).isLessThan(50);
    assertThat(found.notes()).isEmpty();
    assertThat(Math.sin(found.state()[0])).isCloseTo(1, within(1e-12));
    for (int i = 1; i < n; i++) {
      assertThat(Math.cos(found.state()[i])).isCloseTo(1, within(1e-12));
    }
  }

  /**
   * Rods on top of each other, held up by springs and dampers at random: some stand, others fall.
   * The eigenvalues say which, and the proof by factors says the same.
   */
  @Test
  void stabilityIsProvenWhereTheEigenvaluesHaveNegativeRealParts() throws Exception {
    Random random = new Random(12);
    int stable = 0;
    for (int trial = 0; trial < 60; trial++) {
      int n = 2 + trial % 4;
      Mechanism rods = chain(n, -Math.PI / 2);
      List<ForceElement> springs = new ArrayList<>();
      for (int i = 0; i < n; i++) {
        double stiffness = 20 * n * n * random.nextDouble();
        double damping = trial % 3 == 0 ? 0 : random.nextDouble();
        springs.add(
            new JointSpringDamper(
                "k" + i,
                new JointCoordinate(i, 0),
                Expression.of(stiffness),
                Expression.of(damping),
                Expression.of(i == 0 ? -Math.PI / 2 : 0),
                Expression.ZERO,
                Side.BOTH,
                Expression.ZERO,
                Origin.NONE));
      }
      EquationsOfMotion equations =
          new EquationsOfMotion(
              with(rods.bodies(), rods.joints(), List.of(), springs), UserForceSource.NONE);
      double[] y = new double[2 * n];
      y[0] = -Math.PI / 2;
      Linearisation linear = new Linearisation(equations, 0, y, new double[n]);
      Modes modes = new Modes(linear, linear.changing(linear.system()));
      boolean falls =
          IntStream.range(0, modes.count())
              .anyMatch(k -> modes.growth(k) > 1e-9 || modes.frequency(k) == 0);
      assertThat(ProvenStability.of(linear, Modes.ZERO)).as("trial %s", trial).isEqualTo(!falls);
      stable += falls ? 0 : 1;
    }
    assertThat(stable).isBetween(15, 45);
  }

  @Test
  void aFreeHingeIsNotProvenToHaveARestoringForce() throws Exception {
    Body wheel = new Body("w", 1, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE);
    Joint hinge = new Revolute("h", at(Mechanism.ROOT, 0), Y, 0, 0, Origin.NONE);
    EquationsOfMotion equations =
        new EquationsOfMotion(
            with(List.of(wheel), List.of(hinge), List.of(), List.of()), UserForceSource.NONE);
    Linearisation linear = new Linearisation(equations, 0, new double[2], new double[1]);
    assertThat(ProvenStability.of(linear, Modes.ZERO)).isFalse();
  }

  private static Mechanism chain(int n, double start) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      bodies.add(
          new Body(
              "rod" + i,
              1,
              new Vector3(0.5, 0, 0),
              new InertiaTensor(1e-3, 1 / 12.0, 1 / 12.0, 0, 0, 0),
              Origin.NONE));
      Vector3 end = i == 0 ? Vector3.ZERO : new Vector3(1, 0, 0);
      Attachment at = new Attachment(i - 1, end, i, Vector3.ZERO, Rotation.IDENTITY);
      double angle = i == 0 ? start : 0.02 * (i % 3);
      joints.add(new Revolute("hinge" + i, at, Y, angle, 0, Origin.NONE));
    }
    return with(bodies, joints, List.of(), List.of());
  }

  @ParameterizedTest
  @CsvSource({"3, in 3 corrections:", "1, in 1 correction:"})
  void aSearchThatIsCutShortTellsHowManyCorrectionsItMade(int most, String told) {
    StaticEquilibrium found =
        new StaticEquilibrium(chain(20, 0), UserForceSource.NONE, 1e-12, most);
    assertThat(found.find(0)).isFalse();
    assertThat(found.iterations()).isEqualTo(most);
    assertThat(found.defect().cause()).contains(told);
  }

  /** A double pendulum with a strut between ground and its end, from where users begin. */
  @ParameterizedTest
  @CsvSource({"0, 0", "1.5, 0.1", "-1.5, 0.2", "3, -1", "-2, 2", "1, -2.5"})
  void aDoublePendulumWithAStrutRestsFromEveryStart(double first, double second) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    double[] start = {first, second};
    for (int i = 0; i < 2; i++) {
      bodies.add(mass("m" + i, 1 + i, new Vector3(1, 0, 0)));
      Vector3 end = i == 0 ? Vector3.ZERO : new Vector3(1, 0, 0);
      Attachment at = new Attachment(i - 1, end, i, Vector3.ZERO, Rotation.IDENTITY);
      joints.add(new Revolute("hinge" + i, at, Y, start[i], 0, Origin.NONE));
    }
    ForceElement strut =
        new SpringDamper(
            "strut",
            new BodyPoint(BodyPoint.ROOT, new Vector3(2, 0, 1)),
            new BodyPoint(1, new Vector3(1, 0, 0)),
            Expression.of(400),
            Expression.ZERO,
            Expression.of(1.2),
            Expression.ZERO,
            Side.BOTH,
            Expression.ZERO,
            Origin.NONE);
    StaticEquilibrium found = of(with(bodies, joints, List.of(), List.of(strut)));
    assertThat(found.find(0)).isTrue();
    assertThat(found.iterations()).isLessThan(50);
    assertThat(found.notes()).isEmpty();
  }

  /** n masses hanging from one another: spring i carries all below it. */
  @Test
  void chainOfSpringsSagsByTheWeightsBelow() {
    int n = 6;
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    List<ForceElement> springs = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      bodies.add(mass("m" + i, 2, Vector3.ZERO));
      joints.add(new Prismatic("s" + i, at(i - 1, i), Z, 0, 0, Origin.NONE));
      springs.add(spring(i, 1000, 0, Side.BOTH));
    }
    StaticEquilibrium found = of(with(bodies, joints, List.of(), springs));
    assertThat(found.find(0)).isTrue();
    for (int i = 0; i < n; i++) {
      assertThat(found.state()[i]).isCloseTo(-(n - i) * 2 * 10 / 1000.0, within(1e-12));
    }
    assertThat(found.notes()).isEmpty();
  }

  /** From anywhere but the very top. */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 1, 2, 3, 3.1, -1.5})
  void pendulumComesToHang(double start) {
    Joint joint = new Revolute("j", at(Mechanism.ROOT, 0), Y, start, 0, Origin.NONE);
    Body bob = mass("bob", 1, new Vector3(0, 0, -1));
    StaticEquilibrium found = of(with(List.of(bob), List.of(joint), List.of(), List.of()));
    assertThat(found.find(0)).isTrue();
    assertThat(found.state()[0]).isCloseTo(0, within(1e-11));
    assertThat(found.notes()).isEmpty();
  }

  @Test
  void pendulumOnItsHeadIsToldToBeUnstable() {
    Joint joint = new Revolute("j", at(Mechanism.ROOT, 0), Y, 0, 0, Origin.NONE);
    Body bob = mass("bob", 1, Z);
    StaticEquilibrium found = of(with(List.of(bob), List.of(joint), List.of(), List.of()));
    assertThat(found.find(0)).isTrue();
    assertThat(found.notes())
        .extracting(Note::code)
        .containsExactly(MessageCode.UNSTABLE_EQUILIBRIUM);
    assertThat(found.notes().get(0).text()).contains("3.16/s", "coordinate \"j\"");
  }

  @Test
  void bodyThatNothingHoldsAgainstGravityHasNoEquilibrium() {
    Joint joint = new Prismatic("fall", at(Mechanism.ROOT, 0), Z, 0, 0, Origin.NONE);
    Body stone = mass("stone", 1, Vector3.ZERO);
    StaticEquilibrium found = of(with(List.of(stone), List.of(joint), List.of(), List.of()));
    assertThat(found.find(0)).isFalse();
    assertThat(found.defect().code()).isEqualTo(MessageCode.NO_EQUILIBRIUM);
    assertThat(found.defect().part()).isEqualTo("coordinate \"fall\"");
  }

  @Test
  void equilibriumThatIsOneOfManyIsToldToBe() {
    Joint joint =
        new Prismatic("glide", at(Mechanism.ROOT, 0), new Vector3(1, 0, 0), 0.5, 0, Origin.NONE);
    Body stone = mass("stone", 1, Vector3.ZERO);
    StaticEquilibrium found = of(with(List.of(stone), List.of(joint), List.of(), List.of()));
    assertThat(found.find(0)).isTrue();
    assertThat(found.state()[0]).isEqualTo(0.5);
    assertThat(found.notes())
        .extracting(Note::code)
        .containsExactly(MessageCode.EQUILIBRIUM_NOT_UNIQUE);
    assertThat(found.notes().get(0).text()).contains("coordinate \"glide\"");
  }

  /** A stop below that only pushes; the mass starts above it, where nothing holds it. */
  @Test
  void massComesToRestOnStop() {
    Joint joint = new Prismatic("fall", at(Mechanism.ROOT, 0), Z, 2, 0, Origin.NONE);
    Body stone = mass("stone", 1, Vector3.ZERO);
    ForceElement stop = spring(0, 1e5, 0, Side.BELOW);
    StaticEquilibrium found = of(with(List.of(stone), List.of(joint), List.of(), List.of(stop)));
    assertThat(found.find(0)).isTrue();
    // k (x + √(x² + ε²)) / 2 = m g for the penetration x, ε = 1e-4 m
    double force = 10 / 1e5;
    double penetration = force - 0.25 * 1e-8 / force;
    assertThat(found.state()[0]).isCloseTo(-penetration, within(1e-13));
  }

  /** A crane's boom held by its motor at the angle it has at the time asked for. */
  @Test
  void drivenJointsAreHeldWhereTheyAre() {
    Joint boom = new Revolute("boom", at(Mechanism.ROOT, 0), Y, 0, 0, Origin.NONE);
    Joint load =
        new Revolute(
            "load",
            new Attachment(0, new Vector3(1, 0, 0), 1, Vector3.ZERO, Rotation.IDENTITY),
            Y,
            0.3,
            0,
            Origin.NONE);
    List<Body> bodies =
        List.of(mass("arm", 1, new Vector3(0.5, 0, 0)), mass("hook", 1, new Vector3(0, 0, -1)));
    PrescribedMotion turning = new PrescribedMotion(0, List.of(new Expression.Time()));
    StaticEquilibrium found = of(with(bodies, List.of(boom, load), List.of(turning), List.of()));
    assertThat(found.find(0.7)).isTrue();
    assertThat(found.state()[0]).isCloseTo(-0.7, within(1e-11));
    assertThat(found.state()[1]).isZero();
  }

  @Test
  void paperPendulumHangsInEquilibrium() {
    StaticEquilibrium found = of(FiveBarPendulum.mechanism());
    assertThat(found.find(0)).isTrue();
    assertThat(found.notes())
        .filteredOn(note -> note.code() == MessageCode.UNSTABLE_EQUILIBRIUM)
        .isEmpty();
  }

  /** The loop with a damper in its universal joint, until nothing moves any more. */
  @Test
  void equilibriumOfLoopIsWhereDampedMotionEnds() throws Exception {
    List<ForceElement> dampers = List.of(spring(2, 1, 1, Side.BOTH));
    Mechanism loop = SpatialLoop.cutAt(3, false, dampers);
    StaticEquilibrium found = of(loop);
    assertThat(found.find(0)).isTrue();
    double[] end = endOfMotion(loop, 40);
    for (int i = 0; i < loop.positionCount(); i++) {
      // the tolerance of the integration, with a motion that has died away
      assertThat(end[1 + i]).isCloseTo(found.state()[i], within(1e-7));
    }
  }

  private static double[] endOfMotion(Mechanism mechanism, double end) throws Exception {
    RunSettings settings = new RunSettings(0, end, end, "ode15sR", 1e-7, 1e-9);
    CompactModel data = new CompactModel(mechanism, "RR-JF", "projection", settings);
    RecordedRows recorded = new RecordedRows();
    RunReport report =
        new RuntimeSolver()
            .run(
                DataDriven.model(data, UserForceSource.NONE),
                new RunRequest(settings, Set.of()),
                recorded,
                new RunControl());
    assertThat(report.outcome()).isInstanceOf(Outcome.Completed.class);
    return recorded.rows.get(recorded.rows.size() - 1);
  }
}
