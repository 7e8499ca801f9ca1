package org.mechservice.benchmarks.study;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import org.mechservice.benchmarks.LinkChain;
import org.mechservice.solver.dynamics.derivative.ArticulatedIteration;
import org.mechservice.solver.dynamics.derivative.LinkJacobian;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.derivative.StepDerivatives;
import org.mechservice.solver.dynamics.derivative.StepReduction;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Cost of the equations of an implicit step of a chain with stiff joints, eliminated from link to
 * link and with their matrix formed: processor time of the thread, warm, the least of several
 * rounds. Called by benchmarks/peers/loops.py.
 */
public final class StepsOfChains {
  private static final double STEP = 1e-3;
  private static final double STIFFNESS = 1e5;
  private static final double DAMPING = 1e3;

  /** Links above which the matrix is not formed here. */
  private static final int MOST_FORMED = 800;

  private static final int ROUNDS = 12;
  private static final int WARM = 2;

  private StepsOfChains() {}

  /**
   * Prints a line for each chain: microseconds of derivatives, factors and a solution from link to
   * link, then of the same with the matrix formed, 0 where it is not.
   *
   * @param args numbers of links
   */
  public static void main(String[] args) {
    for (int pass = 0; pass < WARM; pass++) {
      for (String links : args) {
        String line = measured(Integer.parseInt(links));
        if (pass == WARM - 1) {
          System.out.println(line);
        }
      }
    }
  }

  private static String measured(int links) {
    TreeGeometry tree = new TreeGeometry(LinkChain.of(links));
    TreeMotion motion = new TreeMotion(tree);
    double[] y = new double[2 * links];
    Arrays.fill(y, 0.1);
    motion.sweep(0, y);
    motion.accelerationSweep(new double[links]);
    LinkJacobian byLinks = new LinkJacobian(motion);
    String costs = costs(byLinks, new ArticulatedIteration(byLinks), y);
    if (links > MOST_FORMED) {
      return costs + " 0 0 0";
    }
    int[] noPairs = {};
    TreePattern pattern = new TreePattern(tree, noPairs);
    ResidualJacobian elements = new ResidualJacobian(motion, pattern);
    return costs + " " + costs(elements, new TreeIteration(tree, pattern, elements), y);
  }

  private static String costs(StepDerivatives derivatives, StepReduction step, double[] y) {
    int links = y.length / 2;
    double[] noWrench = {};
    step.setState(y);
    double derived =
        least(
            () -> {
              derivatives.evaluate(noWrench);
              for (int k = 0; k < links; k++) {
                derivatives.forces().forceByCoordinate(k, k, -STIFFNESS, -DAMPING);
              }
              derivatives.finish();
            });
    double factored = least(() -> step.factor(STEP));
    double solved = least(() -> step.solve(y.clone()));
    return String.format(Locale.ROOT, "%.1f %.1f %.1f", derived, factored, solved);
  }

  private static double least(Runnable work) {
    double least = Double.POSITIVE_INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
      long begun = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
      work.run();
      long done = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
      least = Math.min(least, (done - begun) * 1e-3);
    }
    return least;
  }
}
