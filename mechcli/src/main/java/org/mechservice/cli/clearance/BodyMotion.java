package org.mechservice.cli.clearance;

import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;

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
  private final double[] atRest;

  private BodyMotion(double[] times, Map<String, double[][]> poses, double[] atRest) {
    this.times = times;
    this.poses = poses;
    this.atRest = atRest;
  }

  /**
   * Runs a model as often as it takes.
   *
   * @param moving the bodies that move, of those whose motion is needed
   * @param atRest pose of the ground
   * @param accuracy by which rows may miss the motion between two others, m
   * @param missed by how much those of a motion do, m
   */
  static BodyMotion of(
      MechModel model,
      Set<String> moving,
      double[] atRest,
      double accuracy,
      ToDoubleFunction<BodyMotion> missed) {
    RunSettings settings = model.request().settings();
    double span = Math.abs(settings.tEnd() - settings.tStart());
    double step = Math.min(settings.tStep(), span / FEWEST_ROWS);
    while (true) {
      BodyMotion motion = run(model.every(step), moving, atRest);
      if (missed.applyAsDouble(motion) <= accuracy || 2 * motion.times.length > MOST_ROWS) {
        return motion;
      }
      step /= 2;
    }
  }

  private static BodyMotion run(MechModel model, Set<String> moving, double[] atRest) {
    Trajectory rows = model.columns(ColumnGroup.BODIES).simulate();
    double[] times = rows.time();
    Map<String, double[][]> poses = new TreeMap<>();
    for (String body : moving) {
      double[][] ofBody = new double[times.length][BodyPoses.NUMBERS_PER_BODY];
      for (int c = 0; c < COLUMNS.length; c++) {
        double[] column = rows.column(body + COLUMNS[c]);
        for (int row = 0; row < times.length; row++) {
          ofBody[row][c] = column[row];
        }
      }
      poses.put(body, ofBody);
    }
    return new BodyMotion(times, poses, atRest);
  }

  /** Returns the times of the rows, s. */
  double[] times() {
    return times;
  }

  /** Returns the poses of a body at the rows. */
  double[][] of(String body) {
    double[][] moving = poses.get(body);
    if (moving != null) {
      return moving;
    }
    double[][] resting = new double[times.length][];
    Arrays.fill(resting, atRest);
    return resting;
  }
}
