package org.mechservice.solver.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.LinearisedResidualModel.Mode;
import org.mechservice.solver.force.RandomForces;
import org.mechservice.solver.force.RandomUserForces;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;

/** The four formulations as models, on trees of all joints under one force of every kind. */
class OpenTreeModelTest {
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "ode15sR", 1e-6, 1e-6);
  private static final double TIME = 0.3;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 20);
  }

  private static Mechanism tree(long seed) {
    Mechanism bare = RandomTrees.ofAllJoints(seed, 2 + (int) (seed % 9));
    return new RandomForces(seed, bare).withAll();
  }

  private static UserForceSource userForces() {
    return RandomUserForces::create;
  }

  private static LinearisedResidualModel linearised(Mechanism tree, Mode mode) {
    return new LinearisedResidualModel(tree, SETTINGS, userForces(), mode);
  }

  private static double[] start(ExplicitModel model) {
    double[] y = new double[model.description().stateCount()];
    model.initialState(y);
    return y;
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void formulationsGiveTheSameDerivative(long seed) {
    Mechanism tree = tree(seed);
    DataDrivenModel dtr = new DataDrivenModel(tree, SETTINGS, userForces());
    SemiRecursiveModel dsr = new SemiRecursiveModel(tree, SETTINGS, userForces());
    double[] y = start(dtr);
    double[] first = new double[y.length];
    double[] second = new double[y.length];
    assertThat(dtr.derivative(TIME, y, first)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(dsr.derivative(TIME, y, second)).isEqualTo(ExplicitModel.REGULAR);
    double scale = 1 + Evaluation.largest(first);
    for (int i = 0; i < y.length; i++) {
      // M of trees of this size is conditioned better than 1e5
      assertThat(second[i]).isCloseTo(first[i], within(1e-10 * scale));
    }
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void residualOfTheDerivativeIsZero(long seed) {
    Mechanism tree = tree(seed);
    DataDrivenModel dtr = new DataDrivenModel(tree, SETTINGS, userForces());
    RecursiveResidualModel rr = new RecursiveResidualModel(tree, SETTINGS, userForces());
    double[] y = start(dtr);
    double[] yDot = new double[y.length];
    double[] residual = new double[y.length];
    dtr.derivative(TIME, y, yDot);
    assertThat(rr.residual(TIME, y, yDot, residual)).isEqualTo(ExplicitModel.REGULAR);
    double scale = 1 + Evaluation.largest(yDot);
    // forces and inertias of size 1 to 100
    assertThat(Evaluation.largest(residual)).isLessThan(1e-11 * scale);
  }

  /**
   * d = solve(r) moves the residual by r: the change of F along (hγ d, d) by central differences
   * with Richardson's extrapolation. User forces without derivatives bring differences of their
   * own, good to 1e-7.
   */
  @MethodSource("seeds")
  @ParameterizedTest
  void solutionOfAnImplicitStepMovesTheResidualAsAsked(long seed) {
    LinearisedResidualModel model = linearised(tree(seed), Mode.FULL);
    double[] y = start(model);
    double[] yDot = new double[y.length];
    model.derivative(TIME, y, yDot);
    Random random = new Random(seed);
    for (int i = 0; i < yDot.length; i++) {
      yDot[i] += random.nextGaussian();
    }
    double hGamma = 0.02;
    double[] r = random.doubles(y.length, -1, 1).toArray();
    double[] d = r.clone();
    assertThat(model.linearise(TIME, y, yDot)).isTrue();
    assertThat(model.factor(hGamma)).isTrue();
    model.solve(d);
    double[] coarse = change(model, y, yDot, d, hGamma, 2e-3);
    double[] fine = change(model, y, yDot, d, hGamma, 1e-3);
    double scale = 1 + Evaluation.largest(d);
    for (int i = 0; i < r.length; i++) {
      double change = fine[i] + (fine[i] - coarse[i]) / 3;
      assertThat(change).as("equation %d", i).isCloseTo(r[i], within(1e-6 * scale));
    }
  }

  private static double[] change(
      LinearisedResidualModel model,
      double[] y,
      double[] yDot,
      double[] d,
      double hGamma,
      double h) {
    double step = h / (1 + Evaluation.largest(d));
    double[] ahead = moved(model, y, yDot, d, hGamma, step);
    double[] behind = moved(model, y, yDot, d, hGamma, -step);
    for (int i = 0; i < ahead.length; i++) {
      ahead[i] = (ahead[i] - behind[i]) / (2 * step);
    }
    return ahead;
  }

  private static double[] moved(
      LinearisedResidualModel model,
      double[] y,
      double[] yDot,
      double[] d,
      double hGamma,
      double step) {
    double[] movedY = y.clone();
    double[] movedDot = yDot.clone();
    for (int i = 0; i < y.length; i++) {
      movedY[i] += step * hGamma * d[i];
      movedDot[i] += step * d[i];
    }
    double[] residual = new double[y.length];
    model.residual(TIME, movedY, movedDot, residual);
    return residual;
  }

  @Test
  void forcesAloneGiveNearlyTheSameShortStep() {
    Mechanism tree = tree(4);
    LinearisedResidualModel full = linearised(tree, Mode.FULL);
    LinearisedResidualModel forces = linearised(tree, Mode.FORCES_ONLY);
    double[] y = start(full);
    double[] yDot = new double[y.length];
    double[] d = new Random(4).doubles(y.length).toArray();
    double[] e = d.clone();
    full.linearise(TIME, y, yDot);
    forces.linearise(TIME, y, yDot);
    assertThat(full.factor(1e-4)).isTrue();
    assertThat(forces.factor(1e-4)).isTrue();
    full.solve(d);
    forces.solve(e);
    double scale = Evaluation.largest(d);
    for (int i = 0; i < d.length; i++) {
      // what is left out is of the order of hγ against M
      assertThat(e[i]).isCloseTo(d[i], within(1e-2 * scale));
    }
  }

  @Test
  void evaluationsAllocateNothing() {
    Mechanism bare = RandomTrees.ofAllJoints(9, 20);
    LinearisedResidualModel model =
        new LinearisedResidualModel(bare, SETTINGS, UserForceSource.NONE, Mode.FULL);
    double[] y = start(model);
    double[] yDot = new double[y.length];
    double[] residual = new double[y.length];
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long thread = Thread.currentThread().getId();
    long before = 0;
    for (int i = 0; i < 600; i++) {
      if (i == 300) {
        before = threads.getThreadAllocatedBytes(thread);
      }
      model.derivative(0, y, yDot);
      model.residual(0, y, yDot, residual);
      model.linearise(0, y, yDot);
      model.factor(0.01);
      model.solve(residual);
    }
    // The measurement itself may allocate a little; one object per evaluation would be 4800 bytes.
    assertThat(threads.getThreadAllocatedBytes(thread) - before).isLessThan(1000);
  }

  @Test
  void mechanismWithLoopsIsRefusedNamingThem() {
    Mechanism loops = RandomTrees.withRods(1, 3, 2);
    assertThatThrownBy(() -> new DataDrivenModel(loops, SETTINGS))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "S-081 DTR without closure is for open chains; the scene closes loops at rod0, rod1;"
                + " use DSR, RR or RR-JF");
  }
}
