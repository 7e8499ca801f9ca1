package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.assembly.LoopFinding;

/** Starts of models with loops: half turns, given values that must move, misfits, sizes. */
@Tag("slow")
class StartsThatCloseTest {
  private static final String AXES =
      "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/>"
          + "<vector name='z' vx='0' vy='0' vz='1'/>";

  private static String model(
      String bodies, String joints, String constraints, String forces, String starts) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.1' tstep='0.05'/><integrator"
        + " name='auto' relTol='1e-9' absTol='1e-11'/></dynamic></MBSsimulation><MBSmodel"
        + " name='start' massUnits='kg' lengthUnits='m' silence='no-gravity'><Bodies>"
        + bodies
        + "</Bodies><Joints>"
        + joints
        + "</Joints>"
        + (constraints.isEmpty() ? "" : "<Constraints>" + constraints + "</Constraints>")
        + (forces.isEmpty() ? "" : "<Forces>" + forces + "</Forces>")
        + "<topology><root name='g'/>"
        + (starts.isEmpty() ? "" : "<relCoorVals>" + starts + "</relCoorVals>")
        + "</topology></MBSmodel></MechML>";
  }

  private static String body(String name, String points, double size) {
    double inertia = 0.01 * size * size;
    return "<body name='%s'><point name='o' x='0' y='0' z='0'/>%s%s<cog x='%s' y='0' z='0'/><mass value='1'/><inertiaTensor Ixx='%s' Iyy='%s' Izz='%s'/></body>"
        .formatted(name, points, AXES, 0.1 * size, inertia, 1.5 * inertia, 2 * inertia);
  }

  private static String ground(String points) {
    return "<body name='g'><point name='o' x='0' y='0' z='0'/>" + points + AXES + "</body>";
  }

  private static String point(String name, double x, double y, double z) {
    return "<point name='" + name + "' x='" + x + "' y='" + y + "' z='" + z + "'/>";
  }

  private static String joint(String name, String type, String first, String second) {
    return "<joint name='%s' type='%s'><body1 %s/><body2 %s/></joint>"
        .formatted(name, type, first, second);
  }

  private static ClosedStart start(String text) throws Exception {
    return MechmlReader.read("start.xml", text.getBytes(StandardCharsets.UTF_8)).closedStart(0);
  }

  private static Trajectory run(String text) throws Exception {
    Trajectory rows = MechModel.of("start.xml", text).columns(ColumnGroup.CONSTRAINTS).simulate();
    assertThat(rows.report().outcome()).isInstanceOf(Outcome.Completed.class);
    rows.columns()
        .forEach(
            column ->
                assertThat(Arrays.stream(rows.column(column.name())).allMatch(Double::isFinite))
                    .as(column.name())
                    .isTrue());
    return rows;
  }

  private static LoopFinding only(ClosedStart start, LoopFinding.Kind kind) {
    return start.findings().stream().filter(one -> one.kind() == kind).findFirst().orElseThrow();
  }

  static Stream<Arguments> turnsOfEveryJoint() {
    return Stream.of("R", "P", "C", "H", "PL", "U", "S", "W")
        .flatMap(type -> IntStream.range(0, 12).mapToObj(turn -> Arguments.of(type, turn)));
  }

  /**
   * A plate on a ball, closed by a second joint in the same place, turned by 90, 180, 270 or nearly
   * 180 degrees about each axis: the poses at which tilts and angles of cut joints have no value.
   */
  @ParameterizedTest
  @MethodSource("turnsOfEveryJoint")
  void platesTurnedByQuartersClose(String type, int turn) throws Exception {
    double half = new double[] {45, 90, 135, 89.9999999}[turn / 3] * Math.PI / 180;
    double[] e = {Math.cos(half), 0, 0, 0};
    e[1 + turn % 3] = Math.sin(half);
    String vectors =
        switch (type) {
          case "S" -> "";
          case "PL", "W" -> " vector='x' vector2='y'";
          default -> " vector='x'";
        };
    String second = type.equals("U") ? " vector='y'" : vectors;
    String lock =
        "<joint name='lock' type='%s' cut='true'%s><body1 name='g' point='o'%s/><body2 name='plate' point='o'%s/></joint>"
            .formatted(type, type.equals("H") ? " pitch='0.1'" : "", vectors, second);
    Trajectory rows =
        run(
            model(
                    ground(""),
                    joint("ball", "S", "name='g' point='o'", "name='plate' point='o'") + lock,
                    "",
                    "<gravity gx='0' gy='0' gz='-9.81'/>",
                    "<jointVal name='ball' posVals='%s;%s;%s;%s'/>"
                        .formatted(e[0], e[1], e[2], e[3]))
                .replace("</Bodies>", body("plate", "", 1) + "</Bodies>"));
    for (double residual : rows.column("constraint.position")) {
      assertThat(residual).isCloseTo(0, within(1e-9));
    }
  }

  private static String sliderCrank(String crank) {
    return model(
        ground("")
            + body("crank", point("e", 0.3, 0, 0), 1)
            + body("rod", point("e", 0.9, 0, 0), 1)
            + body("piston", "", 1),
        joint("crankpin", "R", "name='g' point='o' vector='y'", "name='crank' point='o' vector='y'")
            + joint(
                "bigend",
                "R",
                "name='crank' point='e' vector='y'",
                "name='rod' point='o' vector='y'")
            + joint(
                "smallend",
                "R",
                "name='rod' point='e' vector='y'",
                "name='piston' point='o' vector='y'")
            + joint(
                "bore", "P", "name='g' point='o' vector='x'", "name='piston' point='o' vector='x'"),
        "",
        "<gravity gx='0' gy='0' gz='-9.81'/><jointForce name='motor' joint='crankpin'"
            + " expression='1.5'/>",
        "<jointVal name='crankpin' posVals='" + crank + "'/>");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "PI/2", "PI", "3*PI/2", "-PI", "3.1415926"})
  void crankThatIsGivenStaysAndItsSliderCloses(String crank) throws Exception {
    Trajectory rows = run(sliderCrank(crank));
    assertThat(rows.column("crankpin.q")[0]).isEqualTo(angle(crank));
    assertThat(rows.column("constraint.position")[0]).isCloseTo(0, within(1e-14));
  }

  /**
   * An event sets the crank by half a turn, in which the piston turns over: the loop closes from
   * there as from a start, and what was set stays.
   */
  @ParameterizedTest
  @ValueSource(strings = {"PI", "PI/2", "3", "-PI"})
  void crankThatAnEventSetsStaysAndItsSliderCloses(String crank) throws Exception {
    String event =
        "<event name='flip' expression='t-0.05' direction='rising' action='set'><set"
            + " name='crankpin' posVals='"
            + crank
            + "'/></event>";
    Trajectory rows =
        run(
            sliderCrank("0")
                .replace("tend='0.1' tstep='0.05'", "tend='0.0501' tstep='0.0001'")
                .replace("</dynamic>", event + "</dynamic>"));
    double[] q = rows.column("crankpin.q");
    // moves by less than 2e-5 rad in the last interval
    assertThat(q[q.length - 1]).isCloseTo(angle(crank), within(1e-3));
    assertThat(rows.column("constraint.position")[q.length - 1]).isCloseTo(0, within(1e-12));
  }

  private static double angle(String crank) {
    return switch (crank) {
      case "0" -> 0;
      case "PI/2" -> Math.PI / 2;
      case "PI" -> Math.PI;
      case "3*PI/2" -> 3 * Math.PI / 2;
      case "-PI" -> -Math.PI;
      default -> Double.parseDouble(crank);
    };
  }

  /** Links of 1 and 0.5 m, and a rod of 0.8 m to a point 2 m away. */
  private static String threeBars(String starts) {
    return model(
        ground(point("p", 2, 0, 0))
            + body("l1", point("e", 1, 0, 0), 1)
            + body("l2", point("e", 0.5, 0, 0), 1),
        joint("A", "R", "name='g' point='o' vector='z'", "name='l1' point='o' vector='z'")
            + joint("B", "R", "name='l1' point='e' vector='z'", "name='l2' point='o' vector='z'"),
        "<DISTConstraint name='rod' dist='0.8'><body1 name='l2' point='e'/><body2 name='g'"
            + " point='p'/></DISTConstraint>",
        "",
        starts);
  }

  /**
   * Its tip comes to 1.3 m from the point, where the others are stretched: 1 + 4 − 4 cos A = 1.69.
   */
  @Test
  void givenAngleMovesAsLittleAsTheOthersReach() throws Exception {
    double[] y = start(threeBars("<jointVal name='A' posVals='0.9'/>")).state();
    double limit = Math.acos(3.31 / 4);
    assertThat(y[0]).isLessThanOrEqualTo(limit + 1e-12).isCloseTo(limit, within(1e-5));
    run(threeBars("<jointVal name='A' posVals='0.9'/>"));
  }

  @Test
  void givenAngleStaysInEveryBitIfTheOthersReach() throws Exception {
    assertThat(start(threeBars("<jointVal name='A' posVals='0.59'/>")).state()[0]).isEqualTo(0.59);
  }

  /** The least square sum of two given angles, by a search over all first ones. */
  @ParameterizedTest
  @CsvSource({"0.9, 0.1", "0.3, 2", "-1.2, 0.4", "1.5, -1.5", "3.14159265358979, 0"})
  void givenAnglesMoveByTheLeastSquares(double a, double b) throws Exception {
    String given = "<jointVal name='A' posVals='%s'/><jointVal name='B' posVals='%s'/>";
    double[] y = start(threeBars(given.formatted(a, b))).state();
    double least = Double.POSITIVE_INFINITY;
    for (int i = -2_000_000; i <= 2_000_000; i++) {
      double first = a + i * 3.2 / 2_000_000;
      // from the tip (x; z) the end of the second link is 0.5 m away, and the point 0.8 m from that
      double x = 2 - Math.cos(first);
      double z = -Math.sin(first);
      double way = Math.hypot(x, z);
      double cosine = (way * way + 0.25 - 0.64) / way;
      if (Math.abs(cosine) <= 1) {
        double to = Math.atan2(z, x) - first - b;
        for (double bend : new double[] {Math.acos(cosine), -Math.acos(cosine)}) {
          double move = Math.IEEEremainder(to + bend, 2 * Math.PI);
          least = Math.min(least, Math.hypot(first - a, move));
        }
      }
    }
    // steps of 1.6e-6, and the distance bends by less than 1e6 at a limit
    assertThat(Math.hypot(y[0] - a, y[1] - b)).isCloseTo(least, within(1e-5));
  }

  /**
   * A parallel four-bar of hinges whose last joint is a ball, with a misfit of its height: the
   * height follows from the others.
   */
  private static String fourBar(double size, double gap) {
    return model(
        ground(point("c", 0.5 * size, 0, 0))
            + body("crank", point("b", 0, 0.2 * size, 0), size)
            + body("rod", point("d", 0.5 * size, 0.1 * size, gap), size)
            + body("rocker", point("d", 0, 0.3 * size, 0), size),
        joint("a", "R", "name='g' point='o' vector='z'", "name='crank' point='o' vector='z'")
            + joint(
                "b", "R", "name='crank' point='b' vector='z'", "name='rod' point='o' vector='z'")
            + joint("c", "R", "name='g' point='c' vector='z'", "name='rocker' point='o' vector='z'")
            + joint("d", "S", "name='rod' point='d'", "name='rocker' point='d'"),
        "",
        "<gravity gx='0' gy='-9.81' gz='0'/>",
        "");
  }

  /** Misfits relative to the size up to 8e-9 are data with few digits, whatever the size. */
  @ParameterizedTest
  @CsvSource({
    "1, 0",
    "1, 1e-10",
    "1, 1e-9",
    "1, 4e-9",
    "1e-6, 0",
    "1e-6, 1e-15",
    "1e-6, 4e-15",
    "1e4, 0",
    "1e4, 1e-6",
    "1e4, 4e-5"
  })
  void smallMisfitOfARedundantEquationIsAccepted(double size, double gap) throws Exception {
    String text = fourBar(size, gap);
    ClosedStart start = start(text);
    assertThat(start.isAssembled()).isTrue();
    assertThat(start.rank()).isEqualTo(2);
    assertThat(only(start, LoopFinding.Kind.REDUNDANT).amount()).isEqualTo(1);
    assertThat(start.findings()).noneMatch(one -> one.kind() == LoopFinding.Kind.START_MOVED);
    for (String closure : new String[] {"projection", "penalty"}) {
      Trajectory rows =
          MechModel.of("start.xml", text).closure(closure).until(0.1 * Math.sqrt(size)).simulate();
      assertThat(rows.report().outcome()).as(closure).isInstanceOf(Outcome.Completed.class);
    }
  }

  /**
   * A hinge whose axis leans by a misfit has two tilts and a height that follow from the others.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-10, 1e-9, 3e-9})
  void smallMisfitOfAnAxisIsAccepted(double lean) throws Exception {
    String text =
        fourBar(1, 0)
            .replace("name='d' type='S'", "name='d' type='R'")
            .replace("name='rod' point='d'", "name='rod' point='d' vector='w'")
            .replace(
                "name='rocker' point='d'/></joint>", "name='rocker' point='d' vector='z'/></joint>")
            .replace(
                "<point name='d' x='0.5' y='0.1' z='0.0'/>",
                "<point name='d' x='0.5' y='0.1' z='0'/><vector name='w' vx='"
                    + lean
                    + "' vy='"
                    + -lean
                    + "' vz='1'/>");
    ClosedStart start = start(text);
    assertThat(start.isAssembled()).isTrue();
    assertThat(start.rank()).isEqualTo(2);
    assertThat(only(start, LoopFinding.Kind.REDUNDANT).amount()).isEqualTo(3);
    run(text);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-6, 1, 1e4})
  void misfitOfAMillionthIsRefusedWithItsSize(double size) throws Exception {
    ClosedStart start = start(fourBar(size, 1e-6 * size));
    assertThat(start.isAssembled()).isFalse();
    LoopFinding open = only(start, LoopFinding.Kind.NOT_CLOSED);
    assertThat(open.amount()).isCloseTo(1e-6 * size, within(1e-12 * size));
    assertThat(open.unit()).isEqualTo("m");
    assertThat(open.part()).contains("\"d\"");
  }

  /** A body on the end of a rod of half a metre that starts in the rod's other end. */
  @Test
  void residualOfADistanceIsALengthAlsoFromZero() throws Exception {
    ClosedStart start =
        start(
            model(
                ground("") + body("bob", "", 1),
                joint(
                    "free",
                    "PL",
                    "name='g' point='o' vector='y' vector2='x'",
                    "name='bob' point='o' vector='y' vector2='x'"),
                "<DISTConstraint name='rod' dist='0.5'><body1 name='g' point='o'/><body2 name='bob'"
                    + " point='o'/></DISTConstraint>",
                "",
                ""));
    LoopFinding moved = only(start, LoopFinding.Kind.START_MOVED);
    assertThat(moved.unit()).isEqualTo("m");
    assertThat(moved.amount()).isEqualTo(0.5);
    assertThat(Math.hypot(start.state()[0], start.state()[1])).isCloseTo(0.5, within(1e-15));
  }

  /** A zigzag of links of 1 m, its end on a line: positions carry 2e-11 m of rounding. */
  @ParameterizedTest
  @ValueSource(ints = {40, 2560})
  void longChainClosesAllTheWay(int links) throws Exception {
    StringBuilder bodies = new StringBuilder(ground(point("end", links * Math.cos(0.3), 0, 0)));
    StringBuilder joints = new StringBuilder();
    StringBuilder starts = new StringBuilder();
    for (int i = 0; i < links; i++) {
      bodies.append(body("k" + i, point("e", 1, 0, 0), 1));
      String before = i == 0 ? "name='g' point='o'" : "name='k" + (i - 1) + "' point='e'";
      joints.append(
          joint("a" + i, "R", before + " vector='y'", "name='k" + i + "' point='o' vector='y'"));
      double angle = i == 0 ? 0.3 : i % 2 == 0 ? 0.6 : -0.6;
      starts.append("<jointVal name='a" + i + "' posVals='" + angle + "'/>");
    }
    String line =
        "<PointOnLine name='l'><body1 name='g' point='end' vector='y'/><body2 name='k%d' point='e'/></PointOnLine>"
            .formatted(links - 1);
    String text =
        model(
            bodies.toString(),
            joints.toString(),
            line,
            "<gravity gx='0' gy='0' gz='-9.81'/>",
            starts.toString());
    run(text.replace("relTol='1e-9' absTol='1e-11'", "relTol='1e-6' absTol='1e-8'"));
  }
}
