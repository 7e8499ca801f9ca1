package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.program.Trajectory;

/**
 * The tyre against the equations of the book (Rill, Road Vehicle Dynamics, 2012, chapter 3),
 * written a second time in numbers.
 */
class TyreTest {
  private static final double[] X = {120e3, 0.11, 3400, 0.5, 3000};
  private static final double[] X2 = {200e3, 0.12, 6000, 0.8, 5200};
  private static final double[] Y = {55e3, 0.18, 3100, 0.6, 2900};
  private static final double[] Y2 = {80e3, 0.2, 5400, 0.8, 5100};

  /** Returns a number of a curve at a load, by the book: forces quadratic, slips linear. */
  private static double at(double[] once, double[] twice, int i, double share) {
    return i % 2 == 1
        ? once[i] + (twice[i] - once[i]) * (share - 1)
        : share * (2 * once[i] - twice[i] / 2 - (once[i] - twice[i] / 2) * share);
  }

  private static double[] forces(double load, double slipX, double slipY) {
    double[] x = new double[5];
    double[] y = new double[5];
    for (int i = 0; i < 5; i++) {
      x[i] = at(X, X2, i, load / 3200);
      y[i] = at(Y, Y2, i, load / 3200);
    }
    double ratioX = x[2] / x[0];
    double ratioY = y[2] / y[0];
    double normX = x[1] / (x[1] + y[1]) + ratioX / (ratioX + ratioY);
    double normY = y[1] / (x[1] + y[1]) + ratioY / (ratioX + ratioY);
    double s = Math.hypot(slipX / normX, slipY / normY);
    double cos = slipX / normX / s;
    double sin = slipY / normY / s;
    double initial = Math.hypot(x[0] * normX * cos, y[0] * normY * sin);
    double most = Math.hypot(x[1] / normX * cos, y[1] / normY * sin);
    double maximum = Math.hypot(x[2] * cos, y[2] * sin);
    double end = Math.hypot(x[3] / normX * cos, y[3] / normY * sin);
    double slid = Math.hypot(x[4] * cos, y[4] * sin);
    double force = slid;
    if (s <= most) {
      double sigma = s / most;
      force = most * initial * sigma / (1 + sigma * (sigma + initial * most / maximum - 2));
    } else if (s < end) {
      double sigma = (s - most) / (end - most);
      force = maximum - (maximum - slid) * sigma * sigma * (3 - 2 * sigma);
    }
    return new double[] {force * cos, force * sin};
  }

  /** Velocity of the centre, yaw of the wheel, spin, and height of the centre over the road. */
  @ParameterizedTest
  @CsvSource({
    "20, 0, 0, 71, 0.285", "20, 1.5, 0, 68, 0.28", "20, 0, 0.1, 60, 0.285",
    "20, -6, 0, 40, 0.27", "15, 0.5, -0.2, 53, 0.29", "20, 0, 0, 5, 0.285",
    "10, 0, 0.3, 36, 0.283"
  })
  void forcesAreThoseOfTheBook(double vx, double vy, double yaw, double spin, double z)
      throws Exception {
    String wheel =
        String.format(
            Locale.ROOT,
            "posVals='cos(%1$s/2);0;0;sin(%1$s/2);0;0;%2$s' velVals='%3$s;%4$s;0;%5$s;%6$s;0'",
            yaw,
            z,
            -spin * Math.sin(yaw),
            spin * Math.cos(yaw),
            vx,
            vy);
    Trajectory rows = MechModel.of("m.xml", model(wheel)).simulate();
    double load = 2e5 * (0.3 - z);
    double rolling = 2 * 0.3 / 3 + z / 3;
    double along = vx * Math.cos(yaw) + vy * Math.sin(yaw);
    double across = -vx * Math.sin(yaw) + vy * Math.cos(yaw);
    double transport = rolling * spin + 0.01;
    double slipX = -(along - rolling * spin) / transport;
    double slipY = -across / transport;
    double[] expected = forces(load, slipX, slipY);
    // 1e-12 in the square of the slip keeps its direction defined where it is zero
    assertThat(rows.column("tyre.load")[0]).isCloseTo(load, within(1e-6));
    assertThat(rows.column("tyre.slipX")[0]).isCloseTo(slipX, within(1e-12));
    assertThat(rows.column("tyre.slipY")[0]).isCloseTo(slipY, within(1e-12));
    assertThat(rows.column("tyre.longitudinal")[0]).isCloseTo(expected[0], within(1e-4));
    assertThat(rows.column("tyre.lateral")[0]).isCloseTo(expected[1], within(1e-4));
  }

  /**
   * The half car of the examples brakes on its road as its reference does, in the first second: a
   * relative tolerance of 1e-7 leaves 1e-5 after some thousand steps.
   */
  @Test
  void halfCarBrakesAsItsReference(@TempDir Path directory) throws Exception {
    Path folder = Path.of("../examples/half-car");
    String text = Files.readString(folder.resolve("half-car.xml"));
    String shorter =
        text.replace("tend=\"3\"", "tend=\"1\"").replace("relTol=\"1e-8\"", "relTol=\"1e-7\"");
    Files.copy(folder.resolve("road.csv"), directory.resolve("road.csv"));
    Path file = Files.writeString(directory.resolve("half-car.xml"), shorter);
    Trajectory rows = MechModel.read(file).simulate();
    List<String> reference = Files.readAllLines(folder.resolve("reference.csv"));
    String[] names = reference.get(0).split(",", -1);
    assertThat(names).hasSizeGreaterThan(1);
    for (int c = 1; c < names.length; c++) {
      double[] column = rows.column(names[c]);
      for (int i = 0; i <= 20; i++) {
        double expected = Double.parseDouble(reference.get(i + 1).split(",", -1)[c]);
        double bound = 1e-5 * Math.max(1, Math.abs(expected));
        assertThat(column[5 * i]).as(names[c] + " " + i).isCloseTo(expected, within(bound));
      }
    }
  }

  private static String model(String start) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0' tstep='1'/><output"
        + " columns='joints; forces'/></dynamic></MBSsimulation><MBSmodel name='m'"
        + " massUnits='kg' lengthUnits='m'><Bodies><body name='Road'><point name='o' x='0' y='0'"
        + " z='0'/><vector name='z' vx='0' vy='0' vz='1'/></body><body name='wheel'><point"
        + " name='o' x='0' y='0' z='0'/><vector name='y' vx='0' vy='1' vz='0'/><mass"
        + " value='20'/><inertiaTensor Ixx='1' Iyy='2' Izz='1'/></body></Bodies><Joints><joint"
        + " name='j' type='F'><body1 name='Road' point='o'/><body2 name='wheel' point='o'/></joint>"
        + "</Joints><Forces><tyre name='tyre' radius='0.3' stiffness='2e5' load='3200'"
        + " longitudinal='120e3; 0.11; 3400; 0.5; 3000' longitudinal2='200e3; 0.12; 6000; 0.8;"
        + " 5200' lateral='55e3; 0.18; 3100; 0.6; 2900' lateral2='80e3; 0.2; 5400; 0.8; 5100'>"
        + "<body1 name='Road' point='o' vector='z'/><body2 name='wheel' point='o' vector='y'/>"
        + "</tyre></Forces><topology><root name='Road'/><relCoorVals><jointVal name='j' "
        + start
        + "/></relCoorVals></topology></MBSmodel></MechML>";
  }
}
