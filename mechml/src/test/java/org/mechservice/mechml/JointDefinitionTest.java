package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Every type of joint moves its second body as the table in docs/mechml.md says: as a joint of the
 * tree the pose and velocity follow from q and v, as one that closes a loop the pose and velocity
 * obey its equations, and another pose does not.
 *
 * <pre>
 *   tree:  Ground --j-- link          loop:  Ground --F-- link
 *                                            Ground --j-- link  (cut)
 * </pre>
 */
class JointDefinitionTest {
  /** A dozen operations on numbers of a few units. */
  private static final double ROUNDING = 1e-14;

  /** Central differences of step 1e-5 of functions whose third derivatives are some ten. */
  private static final double DIFFERENCE = 1e-8;

  private static final double STEP = 1e-5;

  /** m per rad. */
  private static final double PITCH = -0.3;

  /** A pose of body 2: A turns its axes into those of body 1, r leads from point 1 to point 2. */
  private record Pose(Rotation turn, Vector3 r) {}

  /** A joint in a file, with what the definition says of it. */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  private record Case(String type, Vector3 a1, Vector3 b1, Vector3 a2, double[] q, double[] v) {

    static Case draw(String type, Random random) {
      Vector3 a1 = direction(random);
      int positions = positions(type);
      double[] q = random.doubles(positions, -1, 1).toArray();
      if (type.equals("S") || type.equals("F")) {
        double norm = Math.sqrt(Arrays.stream(q, 0, 4).map(x -> x * x).sum());
        for (int i = 0; i < 4; i++) {
          q[i] /= norm;
        }
      }
      double[] v =
          random.doubles(Math.min(positions, 6) - (type.equals("S") ? 1 : 0), -1, 1).toArray();
      return new Case(type, a1, direction(random), direction(random), q, v);
    }

    private static int positions(String type) {
      return switch (type) {
        case "W" -> 0;
        case "R", "P", "H" -> 1;
        case "C", "U" -> 2;
        case "PL" -> 3;
        case "S" -> 4;
        default -> 7;
      };
    }

    private boolean hasEulerParameters() {
      return type.equals("S") || type.equals("F");
    }

    /** The definition, word for word. */
    Pose pose(double[] q) {
      Rotation zero = Rotation.least(a2, a1);
      return switch (type) {
        case "W" -> new Pose(zero, Vector3.ZERO);
        case "R" -> new Pose(Rotation.about(a1, q[0]).times(zero), Vector3.ZERO);
        case "P" -> new Pose(zero, a1.times(q[0]));
        case "C" -> new Pose(Rotation.about(a1, q[1]).times(zero), a1.times(q[0]));
        case "H" -> new Pose(Rotation.about(a1, q[0]).times(zero), a1.times(PITCH * q[0]));
        case "PL" -> {
          Vector3 x = b1.minus(a1.times(a1.dot(b1))).normalized();
          Vector3 r = x.times(q[0]).plus(a1.cross(x).times(q[1]));
          yield new Pose(Rotation.about(a1, q[2]).times(zero), r);
        }
        case "U" -> {
          Vector3 across = a2.minus(a1.times(a1.dot(a2))).normalized();
          Rotation bent = Rotation.least(a2, across);
          yield new Pose(
              Rotation.about(a1, q[0]).times(bent).times(Rotation.about(a2, q[1])), Vector3.ZERO);
        }
        case "S" -> new Pose(ofEulerParameters(q), Vector3.ZERO);
        default -> new Pose(ofEulerParameters(q), new Vector3(q[4], q[5], q[6]));
      };
    }

    /** Returns how fast something of the pose changes, world axes; Ground's are the world's. */
    Vector3 rate(java.util.function.Function<Pose, Vector3> of) {
      if (hasEulerParameters()) {
        Pose pose = pose(q);
        Vector3 turning = new Vector3(v[0], v[1], v[2]);
        Vector3 sliding = type.equals("F") ? new Vector3(v[3], v[4], v[5]) : Vector3.ZERO;
        return turning.cross(of.apply(pose).minus(pose.r())).plus(sliding);
      }
      Vector3 later = of.apply(pose(moved(STEP)));
      return later.minus(of.apply(pose(moved(-STEP)))).times(1 / (2 * STEP));
    }

    private double[] moved(double time) {
      return IntStream.range(0, q.length).mapToDouble(i -> q[i] + time * v[i]).toArray();
    }

    private String ends(String vectors1, String vectors2) {
      boolean none = hasEulerParameters();
      return "<body1 name='Ground' point='p'%s/><body2 name='link' point='p'%s/>"
          .formatted(none ? "" : vectors1, none ? "" : vectors2);
    }

    String joint(String name, String attributes) {
      String second = type.equals("PL") ? " vector2='b'" : "";
      return "<joint name='%s' type='%s'%s%s>%s</joint>"
          .formatted(
              name,
              type,
              type.equals("H") ? " pitch='" + PITCH + "'" : "",
              attributes,
              ends(" vector='a'" + second, " vector='a'"));
    }
  }

  private static final Vector3 POINT1 = new Vector3(0.3, -0.2, 0.7);
  private static final Vector3 POINT2 = new Vector3(-0.4, 0.1, 0.2);
  private static final List<Vector3> PROBES =
      List.of(
          new Vector3(0, 0, 0), new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1));

  private static Mechanism mechanism(Case one, String joints, String starts)
      throws MechmlException {
    String text =
        """
        <MechML>
          <MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.1'/>
            <integrator name='DE' relTol='1e-5' absTol='1e-5'/></dynamic></MBSsimulation>
          <MBSmodel name='Joint' massUnits='kg' lengthUnits='m'>
            <Bodies>
              <body name='Ground'>%s%s%s</body>
              <body name='link'>%s%s<mass value='1'/>
                <inertiaTensor Ixx='1' Iyy='1' Izz='1'/></body>
            </Bodies>
            <Joints>%s</Joints>
            <topology><root name='Ground'/><relCoorVals>%s</relCoorVals></topology>
          </MBSmodel>
        </MechML>
        """
            .formatted(
                point(POINT1),
                vector("a", one.a1()),
                vector("b", one.b1()),
                point(POINT2),
                vector("a", one.a2()),
                joints,
                starts);
    return MechmlReader.read("joint.xml", text.getBytes(StandardCharsets.UTF_8)).mechanism();
  }

  private static String start(String joint, double[] q, double[] v) {
    return "<jointVal name='%s' posVals='%s' velVals='%s'/>".formatted(joint, list(q), list(v));
  }

  private static String list(double[] values) {
    return DoubleStream.of(values).mapToObj(Double::toString).collect(Collectors.joining(";"));
  }

  private static String point(Vector3 p) {
    return String.format(
        Locale.ROOT, "<point name='p' x='%s' y='%s' z='%s'/>", p.x(), p.y(), p.z());
  }

  private static String vector(String name, Vector3 v) {
    return "<vector name='%s' vx='%s' vy='%s' vz='%s'/>".formatted(name, v.x(), v.y(), v.z());
  }

  static Stream<Arguments> joints() {
    List<Arguments> cases = new ArrayList<>();
    for (String type : List.of("R", "P", "C", "H", "PL", "U", "S", "F", "W")) {
      for (int seed = 1; seed <= 5; seed++) {
        cases.add(Arguments.of(type, seed));
      }
    }
    return cases.stream();
  }

  /** Joints that can close a loop: one of type F forbids nothing. */
  static Stream<Arguments> closingJoints() {
    return joints().filter(one -> !one.get()[0].equals("F"));
  }

  @ParameterizedTest(name = "{0} {1}")
  @MethodSource("joints")
  void jointOfTheTreeMovesAsDefined(String type, int seed) throws MechmlException {
    Case one = Case.draw(type, new Random(seed));
    boolean moves = one.q().length > 0;
    Mechanism mechanism =
        mechanism(one, one.joint("j", ""), moves ? start("j", one.q(), one.v()) : "");
    TreeMotion motion = motion(mechanism, mechanism.positionCount() + mechanism.velocityCount());
    Pose pose = one.pose(one.q());
    for (Vector3 probe : PROBES) {
      assertClose(place(motion, probe), world(pose, probe), ROUNDING);
      assertClose(
          velocity(motion, probe),
          one.rate(p -> world(p, probe).minus(POINT1)),
          one.hasEulerParameters() ? ROUNDING : DIFFERENCE);
    }
  }

  @ParameterizedTest(name = "{0} {1}")
  @MethodSource("closingJoints")
  void jointThatClosesALoopHoldsWhereItsDefinitionPutsTheBody(String type, int seed)
      throws MechmlException {
    Random random = new Random(seed);
    Case one = Case.draw(type, random);
    Pose pose = one.pose(one.q());
    Vector3 sliding = one.rate(p -> p.r());
    Vector3 turning = angularVelocity(one);
    LoopEquations loops = loops(one, pose, turning, sliding);
    assertThat(loops.count()).isEqualTo(6 - freedoms(type));
    for (int row = 0; row < loops.count(); row++) {
      assertThat(loops.value[row]).isCloseTo(0, within(ROUNDING));
      assertThat(loops.rate[row]).isCloseTo(0, within(DIFFERENCE));
    }
    Pose elsewhere =
        new Pose(
            Rotation.about(direction(random), 0.1).times(pose.turn()),
            pose.r().plus(direction(random).times(0.1)));
    LoopEquations broken = loops(one, elsewhere, turning, sliding);
    double worst =
        IntStream.range(0, broken.count())
            .mapToDouble(i -> Math.abs(broken.value[i]))
            .max()
            .orElse(0);
    assertThat(worst).isGreaterThan(1e-3);
  }

  private static int freedoms(String type) {
    return type.equals("S") ? 3 : Case.positions(type);
  }

  private static LoopEquations loops(Case one, Pose pose, Vector3 turning, Vector3 sliding)
      throws MechmlException {
    double[] e = eulerParameters(pose.turn());
    double[] q = {e[0], e[1], e[2], e[3], pose.r().x(), pose.r().y(), pose.r().z()};
    double[] v = {turning.x(), turning.y(), turning.z(), sliding.x(), sliding.y(), sliding.z()};
    String free =
        "<joint name='free' type='F'><body1 name='Ground' point='p'/>"
            + "<body2 name='link' point='p'/></joint>";
    Mechanism mechanism = mechanism(one, free + one.joint("j", " cut='true'"), start("free", q, v));
    TreeMotion motion = motion(mechanism, 13);
    LoopEquations loops = new LoopEquations(motion.tree());
    loops.place(motion, 0);
    loops.move(motion, 0);
    return loops;
  }

  private static TreeMotion motion(Mechanism mechanism, int states) {
    double[] y = new double[states];
    mechanism.initialState(y);
    TreeMotion motion = new TreeMotion(new TreeGeometry(mechanism));
    motion.sweep(0, y);
    return motion;
  }

  /** Returns w with A' = w x A, from how fast the axes of the body turn. */
  private static Vector3 angularVelocity(Case one) {
    if (one.hasEulerParameters()) {
      return new Vector3(one.v()[0], one.v()[1], one.v()[2]);
    }
    Vector3 w = Vector3.ZERO;
    for (Vector3 axis : PROBES.subList(1, 4)) {
      Vector3 now = one.pose(one.q()).turn().apply(axis);
      w = w.plus(now.cross(one.rate(p -> p.turn().apply(axis))).times(0.5));
    }
    return w;
  }

  private static Vector3 world(Pose pose, Vector3 probe) {
    return POINT1.plus(pose.r()).plus(pose.turn().apply(probe.minus(POINT2)));
  }

  private static Vector3 place(TreeMotion motion, Vector3 probe) {
    double[] out = new double[3];
    motion.points.position(motion.tree().linkOfBody[0], fromReference(motion, probe), 0, out, 0);
    return new Vector3(out[0], out[1], out[2]);
  }

  private static Vector3 velocity(TreeMotion motion, Vector3 probe) {
    double[] out = new double[3];
    motion.points.velocity(motion.tree().linkOfBody[0], fromReference(motion, probe), 0, out, 0);
    return new Vector3(out[0], out[1], out[2]);
  }

  private static double[] fromReference(TreeMotion motion, Vector3 probe) {
    double[] origin = motion.tree().bodyOrigin;
    int at = 3 * motion.tree().linkOfBody[0];
    return new double[] {
      origin[at] + probe.x(), origin[at + 1] + probe.y(), origin[at + 2] + probe.z()
    };
  }

  /** The matrix of Euler parameters e0 (the scalar), e1, e2, e3. */
  private static Rotation ofEulerParameters(double[] e) {
    double a = e[0];
    double b = e[1];
    double c = e[2];
    double d = e[3];
    return Rotation.ofColumns(
        new Vector3(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)),
        new Vector3(2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)),
        new Vector3(2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d));
  }

  /** Euler parameters of a rotation: the scalar and three times it, from trace and skew part. */
  private static double[] eulerParameters(Rotation turn) {
    Vector3 x = turn.apply(new Vector3(1, 0, 0));
    Vector3 y = turn.apply(new Vector3(0, 1, 0));
    Vector3 z = turn.apply(new Vector3(0, 0, 1));
    double scalar = Math.sqrt(1 + x.x() + y.y() + z.z()) / 2;
    return new double[] {
      scalar,
      (y.z() - z.y()) / (4 * scalar),
      (z.x() - x.z()) / (4 * scalar),
      (x.y() - y.x()) / (4 * scalar)
    };
  }

  private static Vector3 direction(Random random) {
    return new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
        .normalized();
  }

  private static void assertClose(Vector3 actual, Vector3 expected, double tolerance) {
    assertThat(actual.minus(expected).norm()).isCloseTo(0, within(tolerance));
  }
}
