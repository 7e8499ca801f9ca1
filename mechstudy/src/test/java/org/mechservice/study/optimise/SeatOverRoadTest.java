package org.mechservice.study.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.apache.commons.math3.analysis.interpolation.SplineInterpolator;
import org.apache.commons.math3.analysis.polynomials.PolynomialSplineFunction;
import org.junit.jupiter.api.Test;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.program.Trajectory;

/** The seat over a road from a table, examples/half-car/seat.xml. */
class SeatOverRoadTest {
  private static final Path FOLDER = Path.of("../examples/half-car");
  private static final double SPEED = 5;
  private static final double MASS = 75;
  private static final double STIFFNESS = 6000;
  private static final double DAMPING = 600;

  /** Steps of a row; the knots of the table, 0.05 s apart, are ends of steps. */
  private static final int STEPS = 10;

  private static PolynomialSplineFunction road() throws IOException {
    List<double[]> rows =
        Files.readAllLines(FOLDER.resolve("road.csv")).stream()
            .filter(line -> line.matches("[0-9].*"))
            .map(line -> line.split(",", -1))
            .map(cells -> new double[] {Double.parseDouble(cells[0]), Double.parseDouble(cells[1])})
            .toList();
    return new SplineInterpolator()
        .interpolate(
            rows.stream().mapToDouble(row -> row[0]).toArray(),
            rows.stream().mapToDouble(row -> row[1]).toArray());
  }

  /** m z'' = -k (z - r) - c (z' - r') by the classical Runge and Kutta, r a natural spline. */
  @Test
  void seatMovesAsTheEquationOfOneMassWrittenByHand() throws Exception {
    PolynomialSplineFunction height = road();
    Trajectory rows = MechModel.read(FOLDER.resolve("seat.xml")).simulate();
    double[] seat = rows.column("seat.q");
    assertThat(seat).hasSizeGreaterThan(1);
    double h = 0.01 / STEPS;
    double[] y = {0, 0}; // at rest on the flat begin of the road
    for (int i = 1; i < seat.length; i++) {
      for (int s = 0; s < STEPS; s++) {
        y = step(height, ((i - 1) * STEPS + s) * h, y, h);
      }
      assertThat(seat[i])
          .as("row " + i)
          // the run's tolerance is 1e-8 of places of 1e-2 m
          .isCloseTo(y[0] - height.value(SPEED * i * 0.01), within(1e-7));
    }
  }

  private static double[] step(PolynomialSplineFunction height, double t, double[] y, double h) {
    double[] k1 = rates(height, t, y);
    double[] k2 = rates(height, t + h / 2, moved(y, k1, h / 2));
    double[] k3 = rates(height, t + h / 2, moved(y, k2, h / 2));
    double[] k4 = rates(height, t + h, moved(y, k3, h));
    double[] next = new double[2];
    for (int i = 0; i < 2; i++) {
      next[i] = y[i] + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    return next;
  }

  private static double[] moved(double[] y, double[] rate, double h) {
    return new double[] {y[0] + h * rate[0], y[1] + h * rate[1]};
  }

  private static double[] rates(PolynomialSplineFunction height, double t, double[] y) {
    double place = SPEED * t;
    double r = height.value(place);
    double slope = SPEED * height.derivative().value(place);
    return new double[] {y[1], (-STIFFNESS * (y[0] - r) - DAMPING * (y[1] - slope)) / MASS};
  }
}
