package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.library.DrivenLinkage.Coordinate;
import org.mechservice.library.DrivenLinkage.Drive;
import org.mechservice.library.proof.ProofPage;
import org.mechservice.solver.api.program.Trajectory;

/** Driven linkages stay on the assembly that they start in, against closed forms. */
@Tag("slow")
final class DrivenLinkagesTest {
  /**
   * Loops are closed to 1e-11 of their size; positions follow within that over the sine of the
   * transmission angle, at least 0.017, times the number of loops in a row and the turns' rounding.
   */
  private static final double EXACT = 1e-8;

  /** Method and closure: what integrates which formulation. */
  private static final List<List<String>> METHODS =
      List.of(
          List.of("auto", "auto", "auto"),
          List.of("DSR", "projection", "ode113"),
          List.of("DSR", "projection", "DE"),
          List.of("DSR", "projection", "ode15s"),
          List.of("RR", "projection", "ode15sR"),
          List.of("RR-JF", "projection", "ode15sR"),
          List.of("DSR", "penalty", "ode113"),
          List.of("DSR", "penalty", "DE"),
          List.of("DSR", "penalty", "ode15s"),
          List.of("RR", "penalty", "ode15sR"),
          List.of("RR-JF", "penalty", "ode15sR"));

  private static MechModel of(String mechml, List<String> method, double tolerance)
      throws Exception {
    return MechModel.of("linkage.xml", mechml)
        .formulation(method.get(0))
        .closure(method.get(1))
        .integrator(method.get(2))
        .tolerances(tolerance, tolerance / 100);
  }

  /** Returns the largest distance of a row from the closed form; angles count up to turns. */
  private static double error(DrivenLinkage linkage, Trajectory rows) {
    double largest = 0;
    double[] time = rows.column("t");
    for (int i = 0; i < time.length; i++) {
      for (Coordinate expected : linkage.positions(linkage.angle(time[i]))) {
        double difference = rows.column(expected.name() + ".q")[i] - expected.value();
        double distance =
            expected.isAngle() ? 2 * Math.abs(Math.sin(difference / 2)) : Math.abs(difference);
        largest = distance <= largest ? largest : distance;
      }
    }
    return largest;
  }

  private static DrivenLinkage fourBar(
      double speed, double crank, double coupler, double rocker, double ground) {
    return DrivenLinkage.fourBar(Drive.TREE_JOINT, 0.8, speed, crank, coupler, rocker, ground, 1);
  }

  @ParameterizedTest
  @CsvSource({
    // crank, coupler, rocker, ground, speed, end, step
    "0.464, 0.557, 0.926, 1.004, 10, 12, 0.3",
    "0.105, 1.002, 0.676, 1.139, 100, 2, 0.05",
    // a thousandth of the size from a change point
    "0.4, 1, 0.401, 1, 1, 6, 0.05"
  })
  void crankRockersTurnOnTheirAssembly(
      double crank,
      double coupler,
      double rocker,
      double ground,
      double speed,
      double end,
      double step)
      throws Exception {
    for (int side = -1; side <= 1; side += 2) {
      for (List<String> method : METHODS) {
        DrivenLinkage linkage =
            DrivenLinkage.fourBar(
                Drive.TREE_JOINT, 0.8, speed, crank, coupler, rocker, ground, side);
        Trajectory rows = of(linkage.mechml(end, step), method, 1e-6).simulate();
        assertThat(error(linkage, rows)).as(method + " side " + side).isLessThan(EXACT);
      }
    }
  }

  /** Positions a turn apart close the loop alike, however far the crank turns between rows. */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.3, 0.7, 1.3, 4})
  void kinematicsCountsTheTurns(double step) throws Exception {
    DrivenLinkage linkage = fourBar(10, 0.464, 0.557, 0.926, 1.004);
    String text = linkage.mechml(12, step);
    Trajectory rows = MechModel.of("linkage.xml", text).kinematics();
    assertThat(rows.rows()).isGreaterThan(1);
    double[] time = rows.column("t");
    double angle = linkage.angle(time[0]);
    List<Coordinate> before = linkage.positions(angle);
    double[] turned = before.stream().mapToDouble(Coordinate::value).toArray();
    for (int i = 0; i < time.length; i++) {
      // in parts of the crank's way over which no angle turns by more than 0.2 rad
      double from = angle;
      int parts = 1 + (int) ((linkage.angle(time[i]) - from) / 0.05);
      for (int part = 1; part <= parts; part++) {
        angle = from + (linkage.angle(time[i]) - from) * part / parts;
        List<Coordinate> here = linkage.positions(angle);
        for (int k = 0; k < turned.length; k++) {
          turned[k] += Math.IEEEremainder(here.get(k).value() - turned[k], 2 * Math.PI);
        }
      }
      for (int k = 0; k < turned.length; k++) {
        String name = before.get(k).name() + ".q";
        assertThat(rows.column(name)[i])
            .as("%s at %s s", name, time[i])
            .isCloseTo(turned[k], within(EXACT));
      }
    }
  }

  /**
   * Dependent velocities carry the rounding errors of the fastest ones, also where they pass
   * through zero: tolerances relative to their own size would be out of reach there.
   */
  @ParameterizedTest
  @CsvSource({
    "CONSTRAINT, 2.22722, -25.6308, 0.350081, 0.363684, 0.39248, 0.394515, 0.85",
    "CUT_JOINT, 3.6139, 8.70755, 0.323297, 0.729667, 0.72016, 0.249325, 6.5"
  })
  void velocitiesThatPassThroughZeroDoNotEndARun(
      Drive drive,
      double start,
      double speed,
      double crank,
      double coupler,
      double rocker,
      double ground,
      double end)
      throws Exception {
    DrivenLinkage linkage =
        DrivenLinkage.fourBar(drive, start, speed, crank, coupler, rocker, ground, 1);
    List<String> method = List.of("DSR", "projection", "ode15s");
    Trajectory rows = of(linkage.mechml(end, end / 100), method, 1e-10).simulate();
    assertThat(error(linkage, rows)).isLessThan(EXACT);
  }

  /** A drive that begins after a rest moves its passenger, wherever it stands. */
  @ParameterizedTest
  @CsvSource({
    "CUT_JOINT, 1",
    "CUT_JOINT, 0.05",
    "CONSTRAINT, 1",
    "CONSTRAINT, 0.05",
  })
  void driveThatBeginsAfterARestMovesThePassenger(Drive drive, double duration) throws Exception {
    String motion = "0.1*smoothStep((t-7)/" + duration + ")";
    for (List<String> method : METHODS) {
      Trajectory rows = of(passenger(drive, motion), method, 1e-6).simulate();
      assertThat(rows.rows()).isGreaterThan(1);
      double[] time = rows.column("t");
      for (int i = 0; i < time.length; i++) {
        assertThat(rows.column("y.q")[i])
            .as(method + " t = " + time[i])
            // a hundred times the relative tolerance of the largest elongation, 0.1 m
            .isCloseTo(passenger(time[i] - 7, duration), within(1e-5));
      }
    }
  }

  /** A mass on a spring of 100 N/m with 1 N s/m on a carriage that is driven. */
  private static String passenger(Drive drive, String motion) {
    String axes = "<point name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/>";
    String ends =
        "<body1 name='%s' point='o' vector='x'/><body2 name='%s' point='o' vector='x'/></joint>";
    boolean cut = drive == Drive.CUT_JOINT;
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='10' tstep='0.5'/></dynamic>"
        + "</MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m'"
        + " silence='no-gravity'><Bodies><body name='G'>"
        + axes
        + "</body><body name='b'>"
        + axes
        + "<mass value='1'/></body><body name='a'>"
        + axes
        + "<mass value='1'/></body></Bodies><Joints><joint name='x' type='P'>"
        + ends.formatted("G", "b")
        + "<joint name='y' type='P' stiffness='100' damping='1'>"
        + ends.formatted("b", "a")
        + (cut ? "<joint name='c' type='P' cut='true'>" + ends.formatted("G", "b") : "")
        + "</Joints>"
        + (cut
            ? ""
            : "<Constraints><CoordConstraint name='c' expression='x.q-("
                + motion
                + ")'/></Constraints>")
        + "<topology><root name='G'/><relCoorVals>"
        + (cut ? "<jointVal name='c' driven='" + motion + "'/>" : "")
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  /**
   * y'' + y' + 100 y = −a(t) with the acceleration a = 0.6 (1 − 2 s/T)/T² of smoothStep for 0 ≤ s ≤
   * T: y = A + B s, plus a free vibration from the start, and a free vibration after T.
   */
  private static double passenger(double s, double duration) {
    if (s <= 0) {
      return 0;
    }
    double b = 1.2 / Math.pow(duration, 3) / 100;
    double a = (-0.6 / (duration * duration) - b) / 100;
    double until = Math.min(s, duration);
    double[] state = free(-a, -b, until);
    state[0] += a + b * until;
    state[1] += b;
    return s <= duration ? state[0] : free(state[0], state[1], s - duration)[0];
  }

  /** Returns y and y' of the free vibration after a time. */
  private static double[] free(double y, double v, double s) {
    double w = Math.sqrt(100 - 0.25);
    double c = (v + 0.5 * y) / w;
    double decay = Math.exp(-0.5 * s);
    double cos = Math.cos(w * s);
    double sin = Math.sin(w * s);
    double position = decay * (y * cos + c * sin);
    return new double[] {position, -0.5 * position + decay * w * (c * cos - y * sin)};
  }

  /** At a change point the drive does not say which assembly follows; elsewhere the loop locks. */
  @ParameterizedTest
  @CsvSource({"0.4, 1, 0.4, 1, Both continue beyond", "0.6, 1, 0.5, 1, Neither continues beyond"})
  void whereAssembliesMeetTheRunEndsWithTrueWords(
      double crank, double coupler, double rocker, double ground, String words) throws Exception {
    for (List<String> method : METHODS.subList(0, 6)) {
      DrivenLinkage linkage = fourBar(1, crank, coupler, rocker, ground);
      String text = linkage.mechml(7, 0.05);
      assertThatThrownBy(() -> of(text, method, 1e-6).simulate())
          .as(method.toString())
          .hasMessageContaining("N-020")
          .hasMessageContaining("Two assemblies of this loop meet")
          .hasMessageContaining("coupler.q")
          .hasMessageContaining(words)
          .hasMessageContaining("\"pin0\"");
    }
  }

  /** At a distance from a change point, as a part of the size; by projection at smaller ones. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-2, 1e-3, 1e-5, 1e-7})
  void nearAChangePointTheAssemblyIsKept(double gap) throws Exception {
    for (List<String> method : gap < 1e-6 ? METHODS.subList(0, 6) : METHODS) {
      DrivenLinkage linkage = fourBar(1, 0.4, 1, 0.4 + gap, 1);
      Trajectory rows = of(linkage.mechml(7, 0.05), method, 1e-6).simulate();
      // errors of 1e-14 are divided by the distance of the assemblies, the root of the gap
      assertThat(error(linkage, rows)).as(method.toString()).isLessThan(EXACT);
    }
  }

  /** Returns what went wrong in some random linkages; empty lines are not among them. */
  private static List<String> faults(long seed, int count) {
    RandomGenerator random = new SplittableRandom(seed);
    List<String> faults = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      DrivenLinkage linkage = DrivenLinkage.random(random);
      List<String> method = METHODS.get(i % METHODS.size());
      double tolerance = Math.pow(10, -random.nextInt(3, 11));
      double turn = 2 * Math.PI / Math.abs(linkage.speed());
      double step = turn * Math.pow(10, random.nextDouble(-2, 0.5));
      double end = Math.min(200 * step, turn * random.nextInt(1, 10));
      String run = i + " " + method + " rtol " + tolerance + " end " + end + " step " + step;
      try {
        double error = error(linkage, of(linkage.mechml(end, step), method, tolerance).simulate());
        if (!(error <= EXACT)) {
          faults.add("error " + error + ": " + run + " " + linkage);
        }
      } catch (Exception e) {
        faults.add(e.getMessage() + ": " + run + " " + linkage);
      }
    }
    return faults;
  }

  @Test
  void randomLinkagesTurnOnTheirAssembly() {
    assertThat(faults(20261128, 33)).isEmpty();
  }

  /** A run that ends with a message has told; the page counts them. */
  @Test
  @Tag("soak")
  void noneOfThousandRandomLinkagesIsWrongInSilence() throws Exception {
    long seed = 20_261_128L;
    List<String> faults = faults(seed, 1_000);
    List<String> silent = faults.stream().filter(fault -> fault.startsWith("error ")).toList();
    int told = faults.size() - silent.size();
    ProofPage.write(
        Path.of("../docs/reports/nothing-passed-over.md"),
        "driven loops",
        """
        Written on %s by `DrivenLinkagesTest` under `mvn verify -Psoak`, seed %d: crank-rockers, \
        slider-cranks and six-bars with the drive in a joint of the tree, a cut joint or a \
        constraint, eleven pairs of methods, tolerances from 1e-3 to 1e-10, steps of output of a \
        hundredth to three turns, against the closed form. Right is an error below %s of the size.

        | linkages | right | told | wrong in silence | before: wrong in silence |
        |---|---|---|---|---|
        | 1000 | %d | %d | %d | 2 of 180, 12 more refused |
        """
            .formatted(
                LocalDate.now(ZoneOffset.UTC),
                seed,
                EXACT,
                1_000 - faults.size(),
                told,
                silent.size()));
    assertThat(silent).isEmpty();
  }
}
