package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.stream.IntStream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.program.Trajectory;

/** Contacts of spheres, boxes, capsules and discs, against closed solutions. */
class ShapeContactTest {
  private static String run(double end, String formulation, String integrator) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='"
        + end
        + "' tstep='0.1'/><integrator name='"
        + integrator
        + "' relTol='1e-9' absTol='1e-12'/><formulation name='"
        + formulation
        + "'/><output columns='joints; forces; energy'/></dynamic></MBSsimulation>";
  }

  private static final String AXES =
      "<point name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/><vector name='y'"
          + " vx='0' vy='1' vz='0'/><vector name='z' vx='0' vy='0' vz='1'/>";

  private static String body(String name, String content) {
    return "<body name='" + name + "'>" + AXES + content + "</body>";
  }

  private static String joint(String name, String type, String body, String vector) {
    return "<joint name='"
        + name
        + "' type='"
        + type
        + "'><body1 name='Ground' point='o'"
        + vector
        + "/><body2 name='"
        + body
        + "' point='o'"
        + vector
        + "/></joint>";
  }

  private static String model(String bodies, String joints, String forces, String starts) {
    return "<MBSmodel name='m' massUnits='kg' lengthUnits='m'><Bodies>"
        + body("Ground", "")
        + bodies
        + "</Bodies><Joints>"
        + joints
        + "</Joints><Forces>"
        + forces
        + "</Forces><topology><root name='Ground'/><relCoorVals>"
        + starts
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static double last(Trajectory rows, String column) {
    return rows.column(column)[rows.rows() - 1];
  }

  /**
   * Masses 1 and 2, the first with 1 m/s: after an elastic impact -1/3 and 2/3 m/s. Tolerances of
   * 1e-9 leave 1e-6 after an impact of some thousand steps.
   */
  @ParameterizedTest
  @CsvSource({
    "DTR, ode113, 1.5",
    "DSR, DE, 1",
    "DSR, ode15s, 1.5",
    "RR, ode15sR, 1",
    "RR-JF, ode15sR, 1.5"
  })
  void elasticSpheresExchangeTheirVelocities(String formulation, String integrator, double n)
      throws Exception {
    String text =
        run(1, formulation, integrator)
            + model(
                body("a", "<mass value='1'/>") + body("b", "<mass value='2'/>"),
                joint("a", "P", "a", " vector='x'") + joint("b", "P", "b", " vector='x'"),
                "<sphereContact name='c' radius1='0.1' radius2='0.15' stiffness='1e5' exponent='"
                    + n
                    + "' smoothing='1e-7'><body1 name='a' point='o'/><body2 name='b' point='o'/>"
                    + "</sphereContact>",
                "<jointVal name='a' velVals='1'/><jointVal name='b' posVals='0.6'/>");
    Trajectory rows = MechModel.of("m.xml", text).simulate();
    assertThat(last(rows, "a.v")).isCloseTo(-1.0 / 3, within(2e-6));
    assertThat(last(rows, "b.v")).isCloseTo(2.0 / 3, within(2e-6));
  }

  /**
   * Spheres about a box and a capsule: the depth is the sum of the radii less the distance from the
   * closest point, found here by search in steps that halve, good to 1e-7.
   */
  @Test
  void depthIsThatOfTheClosestPoint() throws Exception {
    double[][] half = {{0.3, 0.2, 0.1}, {0, 0, 0.4}, {0, 0, 0}};
    String[] shape = {
      "box1='0.6; 0.4; 0.2' radius1='0.05'", "length1='0.8' radius1='0.2'", "radius1='0.3'"
    };
    Random random = new Random(23);
    double[][] centres = new double[15][];
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    StringBuilder forces = new StringBuilder();
    StringBuilder starts = new StringBuilder();
    for (int i = 0; i < centres.length; i++) {
      double[] at = IntStream.range(0, 3).mapToDouble(k -> random.nextGaussian() * 0.5).toArray();
      centres[i] = at;
      bodies.append(body("b" + i, "<mass value='1'/><inertiaTensor Ixx='1' Iyy='1' Izz='1'/>"));
      joints.append(joint("j" + i, "F", "b" + i, ""));
      forces.append("<sphereContact name='c" + i + "' " + shape[i % 3]);
      forces.append(" radius2='0.25' stiffness='100' smoothing='1e-9'>");
      forces.append("<body1 name='Ground' point='o'/><body2 name='b" + i + "' point='o'/>");
      forces.append("</sphereContact>");
      starts.append("<jointVal name='j" + i + "' posVals='1;0;0;0;");
      starts.append(at[0] + ";" + at[1] + ";" + at[2] + "'/>");
    }
    String text =
        run(0, "auto", "auto")
            + model(bodies.toString(), joints.toString(), forces.toString(), starts.toString());
    Trajectory rows = MechModel.of("m.xml", text).simulate();
    double[] rounding = {0.05, 0.2, 0.3};
    for (int i = 0; i < centres.length; i++) {
      double distance = distance(centres[i], half[i % 3]);
      double expected = 0.25 + rounding[i % 3] - distance;
      double depth = last(rows, "c" + i + ".penetration");
      assertThat(depth).as("sphere %d", i).isCloseTo(expected, within(1e-7));
      double push = 100 * Math.max(0, expected);
      assertThat(last(rows, "c" + i + ".normal")).isCloseTo(push, within(2e-5));
    }
  }

  /** Returns the distance from a box, negative inside, without its formula. */
  private static double distance(double[] r, double[] h) {
    boolean inside = IntStream.range(0, 3).allMatch(k -> Math.abs(r[k]) < h[k]);
    if (inside) {
      double[] ways = IntStream.range(0, 3).mapToDouble(k -> h[k] - Math.abs(r[k])).toArray();
      return -Math.min(ways[0], Math.min(ways[1], ways[2]));
    }
    double[] p = new double[3];
    for (double step = 1; step > 1e-10; step /= 2) {
      for (int round = 0; round < 4; round++) {
        for (int k = 0; k < 3; k++) {
          double better = p[k] + Math.copySign(step, r[k] - p[k]);
          if (Math.abs(better) <= h[k] && Math.abs(better - r[k]) < Math.abs(p[k] - r[k])) {
            p[k] = better;
          }
        }
      }
    }
    return Math.sqrt(
        Math.pow(p[0] - r[0], 2) + Math.pow(p[1] - r[1], 2) + Math.pow(p[2] - r[2], 2));
  }

  private static String block(double friction) {
    double slope = Math.atan(0.3);
    double weight = 2 * 9.81 * Math.cos(slope);
    // the eight corners, four of them on the plane, carry the weight at this depth
    double height = 0.1 - weight / 4 / 1e5;
    return model(
        body("b", "<mass value='2'/><inertiaTensor Ixx='0.02' Iyy='0.02' Izz='0.02'/>"),
        joint("j", "F", "b", ""),
        "<gravity gx='9.81*sin(atan(0.3))' gy='0' gz='-9.81*cos(atan(0.3))'/><boxContact name='c'"
            + " box='0.4; 0.4; 0.2' stiffness='1e5' damping='500' friction='"
            + friction
            + "' stickLength='1e-4'><body1 name='Ground' point='o' vector='z' vector2='x'/><body2"
            + " name='b' point='o'/></boxContact>",
        "<jointVal name='j' posVals='1;0;0;0;0;0;" + height + "'/>");
  }

  /** Friction of 0.5 holds a block on a slope of 0.3: its velocity decays to rounding. */
  @ParameterizedTest
  @CsvSource({"DTR, ode15s", "DSR, ode15s", "RR, ode15sR", "RR-JF, ode15sR"})
  void blockOnSlopeStaysAtRest(String formulation, String integrator) throws Exception {
    Trajectory rows =
        MechModel.of("m.xml", run(3, formulation, integrator) + block(0.5)).simulate();
    assertThat(Math.abs(last(rows, "j.v[3]"))).isLessThan(1e-9);
    double holding = 2 * 9.81 * Math.sin(Math.atan(0.3));
    assertThat(last(rows, "c.frictionX")).isCloseTo(-holding, within(1e-6 * holding));
    double[] way = rows.column("j.q[4]");
    assertThat(way[rows.rows() - 1]).isCloseTo(way[rows.rows() - 6], within(1e-9));
    // three fifths of the limit: an elastic displacement of about as much of stickLength
    assertThat(way[rows.rows() - 1]).isBetween(0.0, 2e-4);
  }

  /** Friction of 0.2 does not: the block slides with g (sin - 0.2 cos). */
  @ParameterizedTest
  @CsvSource({"DTR, ode15s", "RR-JF, ode15sR"})
  void blockSlidesByCoulombsLaw(String formulation, String integrator) throws Exception {
    Trajectory rows =
        MechModel.of("m.xml", run(2, formulation, integrator) + block(0.2)).simulate();
    double slope = Math.atan(0.3);
    double expected = 9.81 * (Math.sin(slope) - 0.2 * Math.cos(slope));
    double[] v = rows.column("j.v[3]");
    assertThat(v[20] - v[10]).isCloseTo(expected, within(1e-5 * expected));
  }

  /** A disc rolls down a slope with two thirds of the acceleration of a sliding one. */
  @ParameterizedTest
  @CsvSource({"DTR, ode15s", "RR-JF, ode15sR"})
  void discRollsWithoutSlipping(String formulation, String integrator) throws Exception {
    double weight = 2 * 9.81 * Math.cos(0.2);
    String text =
        run(2, formulation, integrator)
            + model(
                body("b", "<mass value='2'/><inertiaTensor Ixx='0.02' Iyy='0.04' Izz='0.02'/>"),
                joint("j", "F", "b", ""),
                "<gravity gx='9.81*sin(0.2)' gy='0' gz='-9.81*cos(0.2)'/><discContact name='c'"
                    + " radius='0.2' stiffness='1e6' damping='1000' friction='0.6'"
                    + " stickLength='1e-5'><body1 name='Ground' point='o' vector='z'"
                    + " vector2='x'/><body2 name='b' point='o' vector='y'/></discContact>",
                "<jointVal name='j' posVals='1;0;0;0;0;0;" + (0.2 - weight / 1e6) + "'/>");
    Trajectory rows = MechModel.of("m.xml", text).simulate();
    double expected = 9.81 * Math.sin(0.2) * 2 / 3;
    double[] v = rows.column("j.v[3]");
    double[] w = rows.column("j.v[1]");
    // the depth of 19 um is a ten-thousandth of the radius and lengthens nothing: the arm is 0.2
    Offset<Double> close = within(1e-5 * expected);
    assertThat(v[20] - v[10]).isCloseTo(expected, close);
    assertThat(v[20] - 0.2 * w[20]).isCloseTo(0, within(1e-6));
  }

  /** A block that is shaken ten times a second stays where it is: rows of the same phase agree. */
  @Test
  void shakenBlockDoesNotCreep() throws Exception {
    String shaking =
        "<forceTorque name='shaker' body='b' point='o' fx='2*sin(20*PI*t)'/><boxContact";
    String text = block(0.9).replace("<boxContact", shaking);
    Trajectory rows = MechModel.of("m.xml", run(2, "DTR", "ode15s") + text).simulate();
    double[] way = rows.column("j.q[4]");
    assertThat(way[20]).isCloseTo(way[10], within(1e-9));
    assertThat(way[20]).isBetween(1e-6, 1e-4);
  }

  /**
   * A soft wheel that is drawn over a round bump: where the bump begins, the closest point jumps
   * before the wheel's centre is there. Steps that pass over the jump leave the energy off by 4 %;
   * the way is that of steps of 1e-5 s with half the tolerances, to 1e-9.
   */
  @Test
  void hollowOfACurveIsMetWhereTheClosestPointJumps() throws Exception {
    String bump = "max(0, 0.0871*(1 - ((s - 14.4156)/0.3276)^2))";
    Trajectory rows = wheel(bump, "relTol='2e-8' absTol='1e-8'").strict().simulate();
    Trajectory fine = wheel(bump, "maxStep='1e-5' relTol='1e-8' absTol='5e-9'").simulate();
    assertThat(last(rows, "z.q")).isCloseTo(last(fine, "z.q"), within(1e-7));
    assertThat(last(rows, "w.v")).isCloseTo(last(fine, "w.v"), within(1e-6));
  }

  private static MechModel wheel(String height, String tolerances) throws Exception {
    String vertical = " vector='z'";
    String masses = "<mass value='39.819'/>";
    return MechModel.of(
        "m.xml",
        "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1.7031' tstep='0.085155'/>"
            + "<integrator name='ode15s' "
            + tolerances
            + "/><formulation name='DTR'/></dynamic></MBSsimulation>"
            + model(
                body("car", "") + body("w", masses) + body("b", "<mass value='450.67'/>"),
                joint("x", "P", "car", " vector='x'")
                    + joint("w", "P", "w", vertical).replace("name='Ground'", "name='car'")
                    + joint("z", "P", "b", vertical)
                        .replace("name='Ground'", "name='w'")
                        .replace(
                            "type='P'",
                            "type='P' stiffness='15746' damping='2749.7' freePosition='0.5'"),
                "<gravity gx='0' gy='0' gz='-9.81'/><contact name='c' radius='0.13580561'"
                    + " stiffness='110952.23527572167' height='"
                    + height
                    + "'><body1 name='Ground' point='o' vector='z' vector2='x'/>"
                    + "<body2 name='w' point='o'/></contact>",
                "<jointVal name='w' posVals='0.09243833'/><jointVal name='z'"
                    + " posVals='0.21922567'/><jointVal name='x' driven='9.97774856*t'/>"));
  }
}
