package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * What loops keep from one state to the next, because its positions are the same, is what a new
 * workspace computes there: bit for bit.
 */
class PlacedAgainTest {
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void equalsWhatANewWorkspaceComputes(long seed) {
    Mechanism mechanism = RandomLoops.of(seed, 4 + (int) seed, 1 + (int) (seed % 4));
    TreeGeometry tree = new TreeGeometry(mechanism);
    TreeMotion motion = new TreeMotion(tree);
    TreeMotion second = new TreeMotion(tree);
    LoopEquations loops = new LoopEquations(tree);
    StateCoordinates coordinates = new StateCoordinates(mechanism);
    int nq = mechanism.positionCount();
    double[] y = new double[nq + mechanism.velocityCount()];
    mechanism.initialState(y);
    Random random = new Random(seed);
    for (int step = 0; step < 40; step++) {
      double t = 0.1 * random.nextInt(3);
      switch (random.nextInt(4)) {
        case 0 -> coordinates.move(y, 0, velocities(random, y.length - nq), 0, 0.1);
        case 1 -> y[nq + random.nextInt(y.length - nq)] += random.nextDouble();
        case 2 -> {
          motion.sweep(t, y);
          loops.placeFar(motion, t);
          loops.differentiate(motion);
        }
        default -> {
          second.sweep(t, y);
          loops.place(second, t);
          loops.differentiate(second);
        }
      }
      motion.sweep(t, y);
      evaluate(loops, motion, t);
      TreeMotion anew = new TreeMotion(tree);
      anew.sweep(t, y);
      LoopEquations expected = new LoopEquations(tree);
      evaluate(expected, anew, t);
      assertThat(motion.worldRotation).containsExactly(anew.worldRotation);
      assertThat(motion.worldPosition).containsExactly(anew.worldPosition);
      assertThat(motion.linearVelocity).containsExactly(anew.linearVelocity);
      assertThat(loops.value).containsExactly(expected.value);
      assertThat(loops.jacobian.value).containsExactly(expected.jacobian.value);
      assertThat(loops.rate).containsExactly(expected.rate);
      assertThat(loops.acceleration).containsExactly(expected.acceleration);
    }
  }

  private static double[] velocities(Random random, int count) {
    return random.doubles(count, -1, 1).toArray();
  }

  private static void evaluate(LoopEquations loops, TreeMotion motion, double t) {
    loops.place(motion, t);
    loops.differentiate(motion);
    loops.move(motion, t);
    motion.accelerationSweep(new double[motion.tree().stateVelocityCount]);
    loops.accelerate(motion, t);
  }
}
