package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.analysis.equation.RestingLinks;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Equilibria by links against closed forms, and against dense matrices in free directions. */
class LinkedEquilibriumTest {
  private static final double G = 10;
  private static final Vector3 Y = new Vector3(0, 1, 0);

  /** Of residual forces: some hundred roundings of the largest moment in play. */
  private static final double TOLERANCE = 1e-13;

  /** Numbers of velocities from which stiffness is kept by links: all mechanisms, and none. */
  private static final int BY_LINKS = 0;

  private static final int DENSE = Integer.MAX_VALUE;

  static IntStream seeds() {
    return IntStream.range(0, 15);
  }

  private static Mechanism of(
      List<Body> bodies, List<Joint> joints, List<LoopClosure> closures, List<ForceElement> all) {
    return new Mechanism(
        "chain",
        new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
        new Vector3(0, 0, -G),
        bodies,
        joints,
        List.of(),
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        closures,
        all,
        List.of());
  }

  private static Body rod(int i, double mass, double length) {
    double j = mass * length * length / 12;
    return new Body(
        "rod" + i,
        mass,
        new Vector3(length / 2, 0, 0),
        new InertiaTensor(0.1 * j, j, j, 0, 0, 0),
        Origin.NONE);
  }

  private static Attachment at(int parent, double arm, int child) {
    return new Attachment(parent, new Vector3(arm, 0, 0), child, Vector3.ZERO, Rotation.IDENTITY);
  }

  private static ForceElement spring(int joint, double stiffness, double damping, double rest) {
    return new JointSpringDamper(
        "k" + joint,
        new JointCoordinate(joint, 0),
        Expression.of(stiffness),
        Expression.of(damping),
        Expression.of(rest),
        Expression.ZERO,
        Side.BOTH,
        Expression.ZERO,
        Origin.NONE);
  }

  private static StaticEquilibrium found(Mechanism mechanism, int large) {
    // loops are closed to 1e-14 of their size, which tightens or slackens a chain
    double tolerance = mechanism.closures().isEmpty() ? TOLERANCE : 10 * TOLERANCE;
    StaticEquilibrium found =
        new StaticEquilibrium(mechanism, UserForceSource.NONE, tolerance, 300, large);
    boolean isFound = found.find(0);
    assertThat(isFound).as(() -> found.defect().cause()).isTrue();
    return found;
  }

  /** Rods of mass m and length l between two points of a level: slopes of (i − (n−1)/2) m g / H. */
  @ParameterizedTest
  @CsvSource({"3, 0.5", "20, 0.9", "60, 0.7", "61, 0.2", "150, 0.7"})
  void aChainBetweenTwoPointsHangsInACatenaryPolygon(int n, double part) {
    double mass = 0.3;
    double length = 2.0 / n;
    double span = part * n * length;
    double below = 1e-6;
    double above = 1e6;
    for (int halving = 0; halving < 200; halving++) {
      double pull = Math.sqrt(below * above);
      double reach = 0;
      for (int i = 0; i < n; i++) {
        reach += length * Math.cos(slope(n, mass, pull, i));
      }
      below = reach < span ? pull : below;
      above = reach < span ? above : pull;
    }
    // it starts on an arc
    double half = arc(part);
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    double angle = 0;
    double reach = 0;
    for (int i = 0; i < n; i++) {
      double next = half * (1 - (2.0 * i + 1) / n); // x turns down about y
      reach += length * Math.cos(next);
      bodies.add(rod(i, mass, length));
      joints.add(
          new Revolute(
              "h" + i, at(i - 1, i == 0 ? 0 : length, i), Y, next - angle, 0, Origin.NONE));
      angle = next;
    }
    assertThat(reach).isCloseTo(span, within(0.1 * span));
    Attachment end =
        new Attachment(
            n - 1,
            new Vector3(length, 0, 0),
            Mechanism.ROOT,
            new Vector3(span, 0, 0),
            Rotation.IDENTITY);
    Joint last = new Revolute("last", end, Y, 0, 0, Origin.NONE);
    Mechanism chain = of(bodies, joints, List.of(new JointClosure(last)), List.of());
    StaticEquilibrium found = found(chain, BY_LINKS);
    assertThat(found.notes())
        .extracting(Note::code)
        .isSubsetOf(MessageCode.START_POSITION_CORRECTED); // the arc misses the other point
    // a slack chain starts as all but a circle, whose upper rods turn over
    assertThat(found.iterations()).isLessThanOrEqualTo(part < 0.5 ? 30 : 12);
    if (n < 100 && part >= 0.5) {
      assertThat(found.iterations()).isLessThanOrEqualTo(found(chain, DENSE).iterations());
    }
    double turned = 0;
    for (int i = 0; i < n; i++) {
      turned += found.state()[i];
      // the middle of a tight or slack chain turns by the rounding of the closed loop
      assertThat(turned).isCloseTo(slope(n, mass, below, i), within(1e-9));
    }
  }

  /** Returns how far a rod points down, rad. */
  private static double slope(int n, double mass, double pull, int i) {
    return Math.atan(((n - 1) / 2.0 - i) * mass * G / pull);
  }

  /** Returns half the angle of an arc whose chord is a part of its length. */
  private static double arc(double part) {
    double below = 0;
    double above = Math.PI;
    for (int halving = 0; halving < 60; halving++) {
      double half = 0.5 * (below + above);
      boolean longer = Math.sin(half) / half > part;
      below = longer ? half : below;
      above = longer ? above : half;
    }
    return below;
  }

  /** The number of corrections does not grow with the number of links. */
  @ParameterizedTest
  @ValueSource(ints = {5, 40, 300})
  void aLevelChainHangsDownInAFewCorrections(int n) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      bodies.add(rod(i, 1, 1));
      joints.add(new Revolute("h" + i, at(i - 1, i == 0 ? 0 : 1, i), Y, 0, 0, Origin.NONE));
    }
    StaticEquilibrium found = found(of(bodies, joints, List.of(), List.of()), BY_LINKS);
    assertThat(found.iterations()).isLessThanOrEqualTo(12);
    assertThat(found.notes()).isEmpty();
    assertThat(found.state()[0]).isCloseTo(Math.PI / 2, within(1e-12));
    for (int i = 1; i < n; i++) {
      assertThat(found.state()[i]).isCloseTo(0, within(1e-12));
    }
  }

  /** Hinges and slides in all directions with springs and dampers, and springs between far rods. */
  private static Mechanism random(int seed, double stiffness, boolean loop) {
    Random random = new Random(seed);
    int n = 4 + seed * 4;
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    List<ForceElement> forces = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      bodies.add(rod(i, 0.2 + random.nextDouble(), 1));
      int parent = i == 0 || random.nextInt(4) > 0 ? i - 1 : random.nextInt(i);
      Attachment at = at(parent, parent < 0 ? 0 : 1, i);
      Vector3 axis =
          new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
              .normalized();
      double start = 0.1 * random.nextGaussian();
      joints.add(
          i % 5 == 4
              ? new Prismatic("j" + i, at, axis, start, 0, Origin.NONE)
              : new Revolute("j" + i, at, axis, start, 0, Origin.NONE));
      forces.add(spring(i, stiffness * (1 + random.nextDouble()), random.nextDouble(), 0));
    }
    for (int k = 0; k < 3; k++) {
      int one = random.nextInt(n);
      int other = random.nextInt(n + 1) - 1;
      if (one != other) {
        forces.add(
            new SpringDamper(
                "s" + k,
                new BodyPoint(one, new Vector3(0.5, 0.2, 0)),
                new BodyPoint(other < 0 ? BodyPoint.ROOT : other, new Vector3(0.3, 2, 1)),
                Expression.of(20),
                Expression.of(1),
                Expression.of(1),
                Expression.ZERO,
                Side.BOTH,
                Expression.ZERO,
                Origin.NONE));
      }
    }
    List<LoopClosure> closures = new ArrayList<>();
    if (loop) {
      Mechanism open = of(bodies, joints, List.of(), forces);
      EquationsOfMotion placed = new EquationsOfMotion(open, UserForceSource.NONE);
      double[] y = new double[open.stateCount()];
      open.initialState(y);
      placed.place(0, y);
      double[] world = new double[3];
      int link = placed.tree.linkOf(n - 1);
      System.arraycopy(placed.motion.worldPosition, 3 * link, world, 0, 3);
      closures.add(
          new DistanceClosure(
              "rope",
              new BodyPoint(n - 1, Vector3.ZERO),
              new BodyPoint(BodyPoint.ROOT, new Vector3(world[0], world[1] + 1, world[2] + 1)),
              Math.sqrt(2),
              0,
              Origin.NONE));
    }
    return of(bodies, joints, closures, forces);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void equilibriaAreThoseOfDenseMatrices(int seed) {
    Mechanism mechanism = random(seed, 3000, seed % 2 == 1);
    StaticEquilibrium links = found(mechanism, BY_LINKS);
    StaticEquilibrium dense = found(mechanism, DENSE);
    assertThat(links.iterations()).isLessThanOrEqualTo(dense.iterations() + 2);
    assertThat(links.notes()).isEqualTo(dense.notes());
    for (int i = 0; i < mechanism.positionCount(); i++) {
      assertThat(links.state()[i]).isCloseTo(dense.state()[i], within(1e-10));
    }
  }

  /** Weak springs: many fall. The verdict is that of all eigenvalues, at any state. */
  @ParameterizedTest
  @MethodSource("seeds")
  void verdictsAreThoseOfTheEigenvalues(int seed) throws Exception {
    Mechanism mechanism = random(seed, 1 << (2 * (seed % 5)), seed % 2 == 1);
    EquationsOfMotion equations = new EquationsOfMotion(mechanism, UserForceSource.NONE);
    double[] y = new double[mechanism.stateCount()];
    mechanism.initialState(y);
    assertThat(equations.closePositions(0, y)).isTrue();
    double[] rest = new double[equations.nv];
    Linearisation linear = new Linearisation(equations, 0, y, rest);
    List<Note> expected = EquilibriumStability.judged(equations, 0, linear);
    RestingLinks links = new RestingLinks(equations);
    links.evaluate(0, y);
    List<Note> found = EquilibriumStability.judged(equations, 0, links);
    assertThat(found).isEqualTo(expected);
  }
}
