package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.library.DrivenLinkage.Coordinate;
import org.mechservice.library.DrivenLinkage.Drive;
import org.mechservice.solver.api.program.Trajectory;

/** Driven linkages stay on the assembly that they start in, against closed forms. */
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
    return DrivenLinkage.fourBar(
        Drive.TREE_JOINT, 0.8, speed, crank, coupler, rocker, ground, 1);
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

  @Test
  @Tag("soak")
  void thousandRandomLinkagesTurnOnTheirAssembly() {
    long seed = System.nanoTime();
    System.out.println("driven linkages: seed " + seed);
    assertThat(faults(seed, 1_000)).as("seed " + seed).isEmpty();
  }
}
