package org.mechservice.benchmarks.study;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;

/**
 * Cost of an evaluation of a chain with a loop beside that of the same chain open, by code and from
 * data: processor time of the thread, warm, the least of several rounds. With a loop it includes
 * the dependent positions and velocities, from predictions that miss the loops by some 1e-6 for
 * each coordinate. Called by benchmarks/peers/loops.py.
 */
public final class ChainWithLoop {
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "ode113", 1e-6, 1e-6);

  private static final int ROUNDS = 8;

  /** Calls of a round, times the number of states. */
  private static final int CALLS = 400_000;

  private static final double MISS = 1e-6;

  private ChainWithLoop() {}

  /**
   * Prints a line for each pair of models: microseconds of the open chain by code and from data, of
   * the chain with a loop by code and from data.
   *
   * @param args MechML files: an open chain, the same chain with a loop, and so on
   */
  public static void main(String[] args) throws IOException, MechmlException {
    for (int i = 0; i + 1 < args.length; i += 2) {
      MechmlModel open = read(args[i]);
      MechmlModel closed = read(args[i + 1]);
      double[] costs = {
        cost(model(open, "DTR", false)),
        cost(model(open, "DTR", true)),
        cost(model(closed, "DSR", false)),
        cost(model(closed, "DSR", true))
      };
      String[] texts =
          Arrays.stream(costs)
              .mapToObj(cost -> String.format(Locale.ROOT, "%.1f", cost))
              .toArray(String[]::new);
      System.out.println(String.join(" ", texts));
    }
  }

  private static MechmlModel read(String file) throws IOException, MechmlException {
    return MechmlReader.read(file, Files.readAllBytes(Path.of(file)));
  }

  private static Model model(MechmlModel scene, String formulation, boolean compact) {
    String closure = scene.mechanism().closures().isEmpty() ? "none" : "projection";
    BuildOptions options = new BuildOptions(formulation, closure, compact, Set.of(), SETTINGS);
    return ModelFactory.compile(scene, options, ModelFactory.generate(scene, options))
        .newInstance();
  }

  private static double cost(Model model) {
    double[] start = new double[model.description().stateCount()];
    model.initialState(start);
    double[] miss = new double[2 * start.length];
    Arrays.setAll(miss, i -> MISS * Math.sin(i));
    double[] y = new double[start.length];
    double[] yDot = new double[start.length];
    double least = Double.POSITIVE_INFINITY;
    int calls = Math.max(1, CALLS / start.length);
    for (int round = 0; round < ROUNDS; round++) {
      long begun = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
      for (int call = 0; call < calls; call++) {
        for (int i = 0; i < y.length; i++) {
          y[i] = start[i] + (i < y.length / 2 ? miss[i + call % y.length] : 0);
        }
        if (model instanceof DependentStates dependent && !dependent.complete(0, y)) {
          throw new IllegalStateException("the loop does not close");
        }
        ((ExplicitModel) model).derivative(0, y, yDot);
      }
      long taken = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - begun;
      least = Math.min(least, 1e-3 * taken / calls);
    }
    return least;
  }
}
