package org.mechservice.cli.clearance;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.distance.RowPaths;

/**
 * Poses of bodies over a run, with rows so close that what lies between them is known: half of the
 * rows foretell the other half to a given accuracy.
 */
final class BodyMotion {
  private static final String[] COLUMNS = {
    ".x", ".y", ".z", ".e0", ".e1", ".e2", ".e3", ".vx", ".vy", ".vz", ".wx", ".wy", ".wz"
  };

  private static final int FEWEST_ROWS = 64;
  private static final int MOST_ROWS = 200_000;

  private final double[] times;
  private final Map<String, double[][]> poses;
  private final double missed;

  private BodyMotion(double[] times, Map<String, double[][]> poses, double missed) {
    this.times = times;
    this.poses = poses;
    this.missed = missed;
  }

  /**
   * Runs a model as often as it takes.
   *
   * @param reach for each moving body the distance of its farthest point from its origin, m
   * @param accuracy by which rows may miss the motion between two others, m
   */
  static BodyMotion of(MechModel model, Map<String, Double> reach, double accuracy) {
    double begin = model.request().settings().tStart();
    double end = model.request().settings().tEnd();
    double step =
        Math.min(Math.abs(model.request().settings().tStep()), Math.abs(end - begin) / FEWEST_ROWS);
    while (true) {
      BodyMotion motion = run(model.every(step), reach);
      if (motion.missed <= accuracy || 2 * motion.times.length > MOST_ROWS) {
        return motion;
      }
      step /= 2;
    }
  }

  private static BodyMotion run(MechModel model, Map<String, Double> reach) {
    Trajectory rows = model.columns(ColumnGroup.BODIES).simulate();
    double[] times = rows.time();
    Map<String, double[][]> poses = new TreeMap<>();
    double missed = 0;
    for (Map.Entry<String, Double> body : reach.entrySet()) {
      double[][] ofBody = new double[times.length][BodyPoses.NUMBERS_PER_BODY];
      for (int c = 0; c < COLUMNS.length; c++) {
        double[] column = rows.column(body.getKey() + COLUMNS[c]);
        for (int row = 0; row < times.length; row++) {
          ofBody[row][c] = column[row];
        }
      }
      poses.put(body.getKey(), ofBody);
      missed = Math.max(missed, RowPaths.missed(times, ofBody, body.getValue()));
    }
    return new BodyMotion(times, poses, missed);
  }

  /** Returns the times of the rows, s. */
  double[] times() {
    return times;
  }

  /** Returns by how much every second row misses the motion at the others, m. */
  double missed() {
    return missed;
  }

  /**
   * Returns the poses of a body at the rows.
   *
   * @param atRest pose of a body that does not move
   */
  double[][] of(String body, double[] atRest) {
    double[][] moving = poses.get(body);
    if (moving != null) {
      return moving;
    }
    double[][] resting = new double[times.length][];
    Arrays.fill(resting, atRest);
    return resting;
  }
}
