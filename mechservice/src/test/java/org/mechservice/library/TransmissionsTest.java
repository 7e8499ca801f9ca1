package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.Trajectory;

/** Ropes, gears and couplings of points, against closed solutions and independent references. */
class TransmissionsTest {
  private static final Path EXAMPLES = Path.of("../examples");
  private static final Offset<Double> CLOSE = within(1e-7);

  private static String run(String formulation, String closure, String integrator) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.1'/><integrator"
        + " name='"
        + integrator
        + "' relTol='1e-9' absTol='1e-11'/><formulation name='"
        + formulation
        + "' closure='"
        + closure
        + "'/></dynamic></MBSsimulation>";
  }

  private static MechModel of(String text) throws MechmlException {
    return MechModel.of("m.xml", text);
  }

  /** Two spherical pendulums whose bobs are tied to each other. */
  private static String pendulums(String simulation, String tie) {
    String pendulum =
        "<point name='o' x='0' y='0' z='0'/><point name='bob' x='0' y='0' z='-1'/><cog x='0' y='0'"
            + " z='-1'/><mass value='1.3'/><inertiaTensor Ixx='0.02' Iyy='0.02' Izz='0.03'/>";
    return simulation
        + "<MBSmodel name='tied' massUnits='kg' lengthUnits='m'><Bodies><body name='Ground'><point"
        + " name='a' x='0' y='0' z='0'/><point name='b' x='0.7' y='0' z='0.1'/></body><body"
        + " name='first'>"
        + pendulum
        + "</body><body name='second'>"
        + pendulum
        + "</body></Bodies><Joints><joint name='j1' type='S'><body1 name='Ground' point='a'/><body2"
        + " name='first' point='o'/></joint><joint name='j2' type='S'><body1 name='Ground'"
        + " point='b'/><body2 name='second' point='o'/></joint></Joints><Constraints>"
        + tie
        + "</Constraints><Forces><gravity gx='0' gy='0' gz='-9.81'/></Forces><topology><root"
        + " name='Ground'/><relCoorVals><jointVal name='j1' velVals='0.9;1.1;0.4'/><jointVal"
        + " name='j2' velVals='-0.8;0.5;-0.3'/></relCoorVals></topology></MBSmodel></MechML>";
  }

  /** Tolerances of 1e-9 leave errors of 1e-7 at most in one second. */
  @ParameterizedTest
  @CsvSource({
    "DSR, projection, ode113",
    "DSR, penalty, ode113",
    "RR, projection, ode15sR",
    "RR-JF, projection, ode15sR",
    "RR-JF, penalty, ode15sR"
  })
  void ropeBetweenTwoEyesMovesAsARodDoes(String formulation, String closure, String integrator)
      throws Exception {
    String simulation = run(formulation, closure, integrator);
    double length = Math.hypot(0.7, 0.1);
    String rod =
        "<DISTConstraint name='tie' dist='"
            + length
            + "'><body1 name='first' point='bob'/><body2 name='second' point='bob'/>"
            + "</DISTConstraint>";
    String rope =
        "<Rope name='tie' length='"
            + length
            + "'><via name='first' point='bob'/><via name='second' point='bob'/></Rope>";
    Trajectory expected = of(pendulums(simulation, rod)).simulate();
    Trajectory found = of(pendulums(simulation, rope)).simulate();
    for (int component = 0; component < 4; component++) {
      for (String joint : List.of("j1", "j2")) {
        String column = joint + ".q[" + component + "]";
        assertThat(found.column(column)).as(column).containsExactly(expected.column(column), CLOSE);
      }
    }
  }

  /**
   * A block and tackle: a rope from the ground under a pulley on the load of mass M, over a fixed
   * pulley to the weight m. The weight falls with 2 g (2 m - M) / (4 m + M).
   */
  @ParameterizedTest
  @CsvSource({
    "DSR, projection, ode113",
    "DSR, penalty, DE",
    "RR, projection, ode15sR",
    "RR-JF, projection, ode15sR",
    "RR-JF, penalty, ode15sR"
  })
  void tackleHalvesTheForce(String formulation, String closure, String integrator)
      throws Exception {
    String body =
        "<point name='o' x='0' y='0' z='0'/><vector name='z' vx='0' vy='0' vz='1'/><mass value='";
    // eye at x = 0, load pulley at x = 0.1, fixed pulley at x = 0.35, weight at x = 0.5
    String text =
        run(formulation, closure, integrator)
            + "<MBSmodel name='tackle' massUnits='kg' lengthUnits='m'><Bodies><body"
            + " name='Ground'><point name='eye' x='0' y='0' z='0'/><point name='under' x='0.1'"
            + " y='0' z='-2'/><point name='top' x='0.35' y='0' z='0'/><point name='beside' x='0.5'"
            + " y='0' z='-1'/><vector name='z' vx='0' vy='0' vz='1'/><vector name='n' vx='0'"
            + " vy='-1' vz='0'/></body><body name='load'>"
            + body
            + "5'/></body><body name='weight'>"
            + body
            + "4'/></body></Bodies><Joints><joint name='lift' type='P'><body1 name='Ground'"
            + " point='under' vector='z'/><body2 name='load' point='o' vector='z'/></joint><joint"
            + " name='fall' type='P'><body1 name='Ground' point='beside' vector='z'/><body2"
            + " name='weight' point='o' vector='z'/></joint></Joints><Constraints><Rope name='rope'"
            + " length='5 + 0.25*PI'><plane name='Ground' point='eye' vector='n'/><via"
            + " name='Ground' point='eye'/><pulley name='load' point='o' radius='0.1'"
            + " side='left'/><pulley name='Ground' point='top' radius='0.15' side='right'/><via"
            + " name='weight' point='o'/></Rope></Constraints><Forces><gravity gx='0' gy='0'"
            + " gz='-9.81'/></Forces><topology><root"
            + " name='Ground'/></topology></MBSmodel></MechML>";
    Trajectory rows = of(text).simulate();
    assertThat(rows.rows()).isGreaterThan(1);
    double acceleration = 2 * 9.81 * (2 * 4 - 5) / (4 * 4 + 5);
    for (int i = 0; i < rows.rows(); i++) {
      double way = acceleration * rows.time()[i] * rows.time()[i] / 2;
      assertThat(rows.column("fall.q")[i]).isCloseTo(-way, within(1e-8));
      assertThat(rows.column("lift.q")[i]).isCloseTo(way / 2, within(1e-8));
    }
  }

  /**
   * Scenes of the examples against references by equations that were derived by hand. Integrators
   * keep 1e-9 or 1e-10 of the state; velocities of the gearbox are its frequencies of 3000 rad/s
   * less accurate.
   */
  @ParameterizedTest
  @CsvSource({"gearbox, 1e-8, 5e-6", "crane, 1e-8, 1e-8", "walker, 1e-8, 5e-8"})
  void sceneFollowsItsReference(String scene, double ofPositions, double relative)
      throws Exception {
    Path folder = EXAMPLES.resolve(scene);
    Trajectory rows = MechModel.read(folder.resolve(scene + ".xml")).simulate();
    List<String> reference = Files.readAllLines(folder.resolve("reference.csv"));
    String[] names = reference.get(0).split(",", -1);
    assertThat(names).hasSizeGreaterThan(1);
    assertThat(reference).hasSizeGreaterThan(2);
    for (int c = 1; c < names.length; c++) {
      double[] column = rows.column(names[c]);
      int every = (rows.rows() - 1) / (reference.size() - 2);
      for (int i = 0; i < reference.size() - 1; i++) {
        double expected = Double.parseDouble(reference.get(i + 1).split(",", -1)[c]);
        boolean position = names[c].contains(".q");
        double bound = position ? ofPositions : relative * Math.max(1, Math.abs(expected));
        assertThat(column[every * i]).as(names[c] + " " + i).isCloseTo(expected, within(bound));
      }
    }
  }

  /**
   * A follower on an eccentric disc of radius r and eccentricity e, as a coupling of a point with
   * an angle; the disc turns with 3 rad/s.
   */
  @ParameterizedTest
  @CsvSource({"DSR, projection, ode113", "RR-JF, projection, ode15sR"})
  void camLiftsThePointOfItsFollower(String formulation, String closure, String integrator)
      throws Exception {
    String body =
        "<point name='o' x='0' y='0' z='0'/><vector name='z' vx='0' vy='0' vz='1'/><vector name='y'"
            + " vx='0' vy='1' vz='0'/>";
    String text =
        run(formulation, closure, integrator)
            + "<MBSmodel name='cam' massUnits='kg' lengthUnits='mm'><Bodies><body name='Ground'>"
            + body
            + "</body><body name='cam'>"
            + body
            + "<mass value='1'/><inertiaTensor Ixx='1' Iyy='1' Izz='1'/></body><body"
            + " name='follower'>"
            + body
            + "<mass value='1'/></body></Bodies><Joints><joint name='turn' type='R'><body1"
            + " name='Ground' point='o' vector='y'/><body2 name='cam' point='o'"
            + " vector='y'/></joint><joint name='lift' type='P'><body1 name='Ground' point='o'"
            + " vector='z'/><body2 name='follower' point='o'"
            + " vector='z'/></joint></Joints><Constraints><CoordConstraint name='profile'"
            + " expression='follower.o.z - 20 - 8*cos(turn.q)'/></Constraints><topology><root"
            + " name='Ground'/><relCoorVals><jointVal name='turn' driven='3*t'/><jointVal"
            + " name='lift' posVals='28'/></relCoorVals></topology></MBSmodel></MechML>";
    Trajectory rows = of(text).simulate();
    assertThat(rows.rows()).isGreaterThan(1);
    for (int i = 0; i < rows.rows(); i++) {
      double expected = 0.020 + 0.008 * Math.cos(3 * rows.time()[i]);
      assertThat(rows.column("lift.q")[i]).isCloseTo(expected, within(1e-9));
    }
  }
}
