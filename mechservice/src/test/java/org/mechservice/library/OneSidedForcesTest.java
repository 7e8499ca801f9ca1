package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Objects;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MessageCode;

/** What acts on one side only pushes and never pulls, in runs of whole models. */
class OneSidedForcesTest {
  private static MechModel model(String name) throws MechmlException {
    try (InputStream in =
        Objects.requireNonNull(OneSidedForcesTest.class.getResourceAsStream("onesided/" + name))) {
      return MechModel.of(name, new String(in.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static double least(Trajectory run, String column) {
    return Arrays.stream(run.column(column)).min().orElseThrow();
  }

  private static double greatest(Trajectory run, String column) {
    return Arrays.stream(run.column(column)).max().orElseThrow();
  }

  /** Asserts that the energy less the work that was done stays, by the largest energy. */
  private static void assertBalanced(Trajectory run, double bound) {
    double[] kinetic = run.column("energy.kinetic");
    double[] potential = run.column("energy.potential");
    double[] work = run.column("energy.work");
    double first = kinetic[0] + potential[0] - work[0];
    double scale = greatest(run, "energy.kinetic") + Math.abs(first);
    for (int i = 0; i < run.rows(); i++) {
      assertThat(kinetic[i] + potential[i] - work[i]).isCloseTo(first, within(bound * scale));
    }
  }

  /** Asserts that work is only lost. */
  private static void assertLoses(Trajectory run, double bound) {
    double[] work = run.column("energy.work");
    for (int i = 1; i < run.rows(); i++) {
      assertThat(work[i]).isLessThanOrEqualTo(work[i - 1] + bound);
    }
  }

  /**
   * The ball leaves the floor with the speed that plain Runge-Kutta steps of 1 microsecond give for
   * m z'' = max(0, k d - c z') - m g: 0.677 m/s. A damper that pulls would leave it 0.411 m/s.
   */
  @ParameterizedTest
  @ValueSource(strings = {"ode113", "ode15s", "auto"})
  void floorOnlyPushesTheBallThatSlidesOverIt(String integrator) throws Exception {
    Trajectory run = model("sliding-ball.xml").integrator(integrator).simulate();
    assertThat(least(run, "touch.normal")).isZero();
    assertThat(greatest(run, "touch.normal")).isGreaterThan(400);
    double[] height = run.column("flight.q[1]");
    double[] speed = run.column("flight.v[1]");
    double rebound = 0;
    for (int i = 1; i < run.rows(); i++) {
      boolean leaves = height[i - 1] < -0.25 && height[i] >= -0.25 && rebound == 0;
      // back to the surface, over the last part of a step of 0.2 ms, against gravity
      rebound = leaves ? speed[i] + 9.81 * (height[i] + 0.25) / speed[i] : rebound;
    }
    assertThat(rebound).isCloseTo(reboundOfTheBall(), within(1e-5));
    assertBalanced(run, 1e-6);
  }

  private static double reboundOfTheBall() {
    double v = -Math.sqrt(2 * 9.81 * 0.25);
    double d = 0;
    double h = 1e-6;
    boolean inside = true;
    while (inside) {
      double a1 = Math.max(0, 5e4 * d - 200 * v) - 9.81;
      double vm = v + 0.5 * h * a1;
      double dm = d - 0.5 * h * v;
      double a2 = Math.max(0, 5e4 * dm - 200 * vm) - 9.81;
      v += h * a2;
      d -= h * vm;
      inside = d > 0;
    }
    return v - 9.81 * d / v;
  }

  /** Three integrators at five tolerances, friction and damper included, give one motion. */
  @Test
  void dampedContactWithFrictionHasOneMotion() throws Exception {
    double[] expected = null;
    for (double tolerance : new double[] {1e-8, 1e-7, 1e-6, 1e-5, 1e-4}) {
      for (String method : new String[] {"DTR ode113", "DTR ode15s", "RR-JF ode15sR"}) {
        String[] names = method.split(" ", -1);
        Trajectory run =
            model("sliding-ball.xml")
                .formulation(names[0])
                .integrator(names[1])
                .tolerances(tolerance, tolerance / 100)
                .simulate();
        double[] end = {
          run.column("flight.q[0]")[run.rows() - 1],
          run.column("flight.q[1]")[run.rows() - 1],
          run.column("flight.v[0]")[run.rows() - 1],
          run.column("flight.v[2]")[run.rows() - 1]
        };
        if (expected == null) {
          expected = end;
        }
        for (int i = 0; i < end.length; i++) {
          // spin and sliding of an impact grow errors of the approach a hundredfold
          assertThat(end[i])
              .as("%s at %s, value %d", method, tolerance, i)
              .isCloseTo(expected[i], within(300 * tolerance * (1 + Math.abs(expected[i]))));
        }
      }
    }
  }

  @Test
  void ropeOnlyPulls() throws Exception {
    Trajectory run = model("bungee.xml").simulate();
    assertThat(least(run, "rope.tension")).isZero();
    assertThat(greatest(run, "rope.tension")).isGreaterThan(700);
    assertBalanced(run, 1e-6);
    assertLoses(run, 1e-6);
  }

  @ParameterizedTest
  @ValueSource(doubles = {60, 150, 220, 400})
  void compressionSpringNeverHoldsTheTappetBack(double speed) throws Exception {
    Trajectory run = model("cam.xml").set("speed", speed).simulate();
    // the tension of a spring that only pushes is never positive
    assertThat(greatest(run, "touch.tension")).isLessThanOrEqualTo(0);
    assertThat(least(run, "touch.tension")).isLessThan(-10);
  }

  @Test
  void stopAndFloorOfTheThrownBallOnlyPush() throws Exception {
    Trajectory run =
        MechModel.read(Path.of("../examples/how-to/thrown-ball.xml"))
            .columns(ColumnGroup.JOINTS, ColumnGroup.FORCES)
            .every(0.0002)
            .simulate();
    assertThat(least(run, "ground.normal")).isGreaterThanOrEqualTo(0);
    assertThat(greatest(run, "ground.normal")).isGreaterThan(300);
    assertThat(greatest(run, "guide.upper.force")).isLessThanOrEqualTo(0);
    assertThat(least(run, "guide.upper.force")).isLessThan(-100);
  }

  /** 0.3 √2 less the depth: the normal force is m g √2, the depth along z √2 times its own. */
  @Test
  void sphereOnASlopeTouchesWithItsSurface() throws Exception {
    double expected = 0.3 * Math.sqrt(2) - 2 * 9.81 / 1e7;
    assertThat(model("sphere-on-slope.xml").equilibrium().column("drop.q")[0])
        .isCloseTo(expected, within(1e-9));
  }

  /**
   * Both edges of the ditch, 0.051 m from its middle, carry half of the weight along the normals
   * there.
   */
  @Test
  void sphereOverADitchLiesOnBothEdges() throws Exception {
    double height = Math.sqrt(0.3 * 0.3 - 0.051 * 0.051);
    double cosine = height / 0.3;
    double depth = 9.81 / (2 * cosine) / 1e6;
    Trajectory rest = model("sphere-in-ditch.xml").columns(ColumnGroup.FORCES).equilibrium();
    assertThat(rest.column("drop.q")[0]).isCloseTo(height - depth / cosine, within(2e-7));
    assertThat(rest.column("touch.normal")[0]).isCloseTo(9.81 / cosine, within(1e-5));
  }

  /** Straight from the eye at (−1, 0) to (1, z) where that clears the pulley. */
  @Test
  void ropeThatHasLeftItsPulleyIsStraight() throws Exception {
    Trajectory run = model("rope-past-pulley.xml").simulate();
    double[] z = run.column("slide.q");
    double[] length = run.column("rope.length");
    int wrapped = 0;
    for (int i = 0; i < run.rows(); i++) {
      double expected = Math.hypot(2, z[i]);
      double angle = Math.asin(0.2) + Math.asin(0.2 / Math.hypot(1, z[i])) - Math.atan(z[i]);
      if (angle > 0) {
        wrapped++;
        expected = Math.sqrt(1 - 0.04) + Math.sqrt(1 + z[i] * z[i] - 0.04) + 0.2 * angle;
      }
      assertThat(length[i]).isCloseTo(expected, within(1e-12));
      assertThat(run.column("rope.tension")[i]).isCloseTo(50 * (expected - 1.5), within(1e-9));
    }
    assertThat(wrapped).isBetween(10, run.rows() - 10);
    assertBalanced(run, 1e-7);
  }

  /** All of them have the restitution 0.5. */
  @Test
  void restitutionIsWhatWasAskedForInEveryElement() throws Exception {
    Trajectory run = MechModel.read(Path.of("../examples/elements/restitution.xml")).simulate();
    for (String joint :
        new String[] {
          "ball_e",
          "sphere_e",
          "coin_e",
          "crate_e",
          "ball_chi",
          "sphere_chi",
          "coin_chi",
          "crate_chi",
          "buffer",
          "geared",
          "tied",
          "stopped"
        }) {
      double[] speed = run.column(joint + ".v");
      assertThat(speed[run.rows() - 1]).as(joint).isCloseTo(-0.5, within(1e-6));
    }
  }

  /** A ball that falls on a floor, or on a buffer, with a random law, again and again. */
  private static String bounce(Random random, String damping) {
    double k = Math.exp(random.nextDouble() * 6 + 7);
    double exponent = random.nextBoolean() ? 1 : 1 + random.nextDouble();
    double smoothing = random.nextBoolean() ? 0 : 1e-5 * (1 + 9 * random.nextDouble());
    double speed = 0.2 + 3 * random.nextDouble();
    String law =
        String.format(
            Locale.ROOT,
            "stiffness='%s' exponent='%s' %s smoothing='%s'",
            k,
            exponent,
            damping,
            smoothing);
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.6' tstep='0.001'/><integrator"
        + " name='auto' relTol='1e-8' absTol='1e-10' maxStep='0.0005'/><output columns='joints;"
        + " energy; forces'/></dynamic></MBSsimulation><MBSmodel name='bounce' massUnits='kg'"
        + " lengthUnits='m'><Bodies><body name='ground'><point name='o' x='0' y='0' z='0'/><vector"
        + " name='z' vx='0' vy='0' vz='1'/></body><body name='ball'><point name='o' x='0' y='0'"
        + " z='0'/><vector name='z' vx='0' vy='0' vz='1'/><mass"
        + " value='0.5'/></body></Bodies><Joints><joint name='fall' type='P'><body1 name='ground'"
        + " point='o' vector='z'/><body2 name='ball' point='o'"
        + " vector='z'/></joint></Joints><Forces><gravity gx='0' gy='0' gz='-9.81'/><contact"
        + " name='touch' radius='0.05' "
        + law
        + "><body1 name='ground' point='o' vector='z'/><body2 name='ball' point='o'/></contact>"
        + "</Forces><topology><root name='ground'/><relCoorVals><jointVal name='fall'"
        + " posVals='0.06' velVals='"
        + -speed
        + "'/></relCoorVals></topology></MBSmodel></MechML>";
  }

  /** Seeds give stiffness, exponent, damping, smoothing and speed. */
  @ParameterizedTest
  @CsvSource({"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"})
  void noReboundGainsEnergyAndNoFloorPulls(long seed) throws Exception {
    Random random = new Random(seed);
    String damping =
        switch (random.nextInt(3)) {
          case 0 -> "damping='" + Math.exp(6 * random.nextDouble()) + "'";
          case 1 -> "dissipation='" + 5 * random.nextDouble() + "'";
          default ->
              "restitution='" + (0.05 + 0.9 * random.nextDouble()) + "' restitutionSpeed='1'";
        };
    Trajectory run = MechModel.of("bounce.xml", bounce(random, damping)).simulate();
    assertThat(least(run, "touch.normal")).isGreaterThanOrEqualTo(0);
    assertThat(greatest(run, "touch.normal")).isGreaterThan(1);
    assertBalanced(run, 1e-5);
    assertLoses(run, 1e-5);
  }

  /**
   * A block on a rope under a hoist that goes down with a drop of 1/2 a t²: for a > g the rope
   * would have to push it.
   */
  private static String hoist(double acceleration) {
    String axis = "<vector name='z' vx='0' vy='0' vz='1'/>";
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.3'"
        + " tstep='0.01'/></dynamic></MBSsimulation><MBSmodel name='hoist' massUnits='kg'"
        + " lengthUnits='m'><Bodies><body name='ground'><point name='o' x='0' y='0' z='0'/><point"
        + " name='low' x='0' y='0' z='-1'/>"
        + axis
        + "</body><body name='hook'><point name='o' x='0' y='0' z='0'/>"
        + axis
        + "<mass value='1'/></body><body name='block'><point name='o' x='0' y='0' z='0'/>"
        + axis
        + "<mass value='2'/></body></Bodies><Joints><joint name='drive' type='P'><body1 name='ground'"
        + " point='o' vector='z'/><body2 name='hook' point='o' vector='z'/></joint><joint"
        + " name='lift' type='P'><body1 name='ground' point='low' vector='z'/><body2 name='block'"
        + " point='o' vector='z'/></joint></Joints><Constraints><Rope name='rope' length='1'><via"
        + " name='hook' point='o'/><via name='block' point='o'/></Rope></Constraints><Forces><gravity"
        + " gx='0' gy='0' gz='-9.81'/></Forces><topology><root name='ground'/><relCoorVals><jointVal"
        + " name='drive' driven='-0.5*"
        + acceleration
        + "*t*t'/></relCoorVals></topology></MBSmodel></MechML>";
  }

  @Test
  void ropeThatWouldPushIsNotedAndFailsUnderStrict() throws Exception {
    assertThat(MechModel.of("slow.xml", hoist(9)).strict().simulate().report().notes())
        .noneMatch(note -> note.code() == MessageCode.CONSTRAINT_PULLS);
    MechModel fast = MechModel.of("fast.xml", hoist(11));
    // 2 kg that fall with 11 m/s² are pushed with 2.38 N
    assertThat(fast.simulate().report().notes())
        .filteredOn(note -> note.code() == MessageCode.CONSTRAINT_PULLS)
        .singleElement()
        .satisfies(note -> assertThat(note.text()).contains("\"rope\"").contains("2.380 N"));
    assertThatThrownBy(() -> fast.strict().simulate()).hasMessageContaining("N-059");
  }
}
