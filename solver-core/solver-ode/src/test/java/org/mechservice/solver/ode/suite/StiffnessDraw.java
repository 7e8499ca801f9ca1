package org.mechservice.solver.ode.suite;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.OdeSystem;

/**
 * A run drawn at random from a group of problems that are more or less stiff, for methods that
 * change with stiffness. Every third of a group is held out: nothing is chosen by it.
 *
 * @param group what the problems have in common
 * @param index place in the group, from 0
 * @param ode right-hand side
 * @param start state at t = 0
 * @param end of the interval
 * @param tolerance relative
 * @param small size of the state that counts as small: the absolute tolerance over the relative one
 */
@SuppressWarnings("ArrayRecordComponent") // compared by nobody
public record StiffnessDraw(
    String group,
    int index,
    OdeSystem ode,
    double[] start,
    double end,
    double tolerance,
    double small) {
  /** Of the draws by which rules were chosen, with the name of the group added. */
  public static final long SEED = 20261126;

  /** A system in which each component couples with its neighbours. */
  private record Tridiagonal(int dimension, FunctionOde.Equation equation)
      implements OdeSystem, BandedSystem {
    @Override
    public int lowerBandwidth() {
      return 1;
    }

    @Override
    public int upperBandwidth() {
      return 1;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      equation.evaluate(t, y, yDot);
    }
  }

  /** Draws the parameters of one problem. */
  private interface Group {
    StiffnessDraw draw(String name, int index, Random random);
  }

  /**
   * Returns the same draws each time.
   *
   * @param perGroup draws of each group
   */
  public static List<StiffnessDraw> all(int perGroup) {
    return all(perGroup, SEED);
  }

  /**
   * Returns the same draws each time.
   *
   * @param perGroup draws of each group
   * @param seed of the draws, another one for others
   */
  public static List<StiffnessDraw> all(int perGroup, long seed) {
    List<StiffnessDraw> draws = new ArrayList<>();
    add(draws, perGroup, seed, "rotation at 1e5 on its slow circle", StiffnessDraw::rotationAtRest);
    add(draws, perGroup, seed, "rotation off its slow circle", StiffnessDraw::rotationStirred);
    add(draws, perGroup, seed, "decay to a slow motion", StiffnessDraw::decay);
    add(draws, perGroup, seed, "relaxation oscillator", StiffnessDraw::relaxation);
    add(draws, perGroup, seed, "driven mass on a damped spring", StiffnessDraw::spring);
    add(draws, perGroup, seed, "linear system with a wide spectrum", StiffnessDraw::spectrum);
    add(draws, perGroup, seed, "chain of reactions", StiffnessDraw::reactions);
    add(draws, perGroup, seed, "diffusion in a bar, banded", StiffnessDraw::bar);
    add(draws, perGroup, seed, "stiff for a while", StiffnessDraw::forAWhile);
    add(draws, perGroup, seed, "hardly stiff", StiffnessDraw::hardlyStiff);
    return draws;
  }

  private static void add(
      List<StiffnessDraw> draws, int count, long seed, String name, Group group) {
    Random random = new Random(seed + name.hashCode());
    for (int i = 0; i < count; i++) {
      draws.add(group.draw(name, i, random));
    }
  }

  /** Returns whether the run is one by which nothing is chosen. */
  public boolean heldOut() {
    return index % 3 == 2;
  }

  /** Returns 10^x, x uniform. */
  private static double between(Random random, double from, double to) {
    return StrictMath.pow(10, from + (to - from) * random.nextDouble());
  }

  private static double tolerance(Random random) {
    return between(random, -8, -3);
  }

  /** u' = (−d + i r)(u − e^{ist}) + i s e^{ist}. */
  private static FunctionOde rotation(double fast, double decay, double slow) {
    return new FunctionOde(
        2,
        (t, y, yDot) -> {
          double cosine = StrictMath.cos(slow * t);
          double sine = StrictMath.sin(slow * t);
          double u = y[0] - cosine;
          double v = y[1] - sine;
          yDot[0] = -decay * u - fast * v - slow * sine;
          yDot[1] = fast * u - decay * v + slow * cosine;
        });
  }

  private static StiffnessDraw rotationAtRest(String name, int index, Random random) {
    FunctionOde ode = rotation(1e5, between(random, 0, 5), between(random, 0, 1));
    double end = 0.1 + 2 * random.nextDouble();
    return new StiffnessDraw(name, index, ode, new double[] {1, 0}, end, tolerance(random), 1);
  }

  private static StiffnessDraw rotationStirred(String name, int index, Random random) {
    double fast = between(random, 2, 5);
    FunctionOde ode = rotation(fast, fast * between(random, -2.5, 1), between(random, 0, 1));
    double[] start = {1 + between(random, -3, 0), 0};
    return new StiffnessDraw(name, index, ode, start, 1, tolerance(random), 1);
  }

  private static StiffnessDraw decay(String name, int index, Random random) {
    double rate = between(random, 1, 6);
    double slow = between(random, -0.5, 0.5);
    double end = 2 + 10 * random.nextDouble();
    FunctionOde ode =
        new FunctionOde(
            1, (t, y, yDot) -> yDot[0] = -rate * (y[0] - StrictMath.cos(slow * t) / (1 + 0.1 * t)));
    double[] start = {2 * random.nextDouble()};
    return new StiffnessDraw(name, index, ode, start, end, tolerance(random), 1);
  }

  private static StiffnessDraw relaxation(String name, int index, Random random) {
    double mu = between(random, 0.5, 4);
    double periods = 0.2 + 2 * random.nextDouble();
    double push = random.nextDouble() < 0.5 ? 0 : 0.4 * random.nextDouble();
    FunctionOde ode =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              yDot[1] = mu * (1 - y[0] * y[0]) * y[1] - y[0] + push;
            });
    double end = 1.6 * periods * mu;
    return new StiffnessDraw(name, index, ode, new double[] {2, 0}, end, tolerance(random), 1);
  }

  private static StiffnessDraw spring(String name, int index, Random random) {
    double stiffness = between(random, 3, 8);
    double damping = 2 * between(random, -1.3, 1.3) * Math.sqrt(stiffness);
    double[] start = {random.nextBoolean() ? 0 : between(random, -3, -1), 0};
    double end = 1 + 5 * random.nextDouble();
    FunctionOde ode =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              yDot[0] = y[1];
              double apart = y[0] - StrictMath.sin(t);
              yDot[1] = -stiffness * apart - damping * (y[1] - StrictMath.cos(t));
            });
    return new StiffnessDraw(name, index, ode, start, end, tolerance(random), 1);
  }

  /** y' = −H D H (y − g(t)), H a reflection, D with blocks that decay and turn. */
  private static StiffnessDraw spectrum(String name, int index, Random random) {
    int n = 2 * (1 + random.nextInt(4));
    double widest = 1 + 4 * random.nextDouble();
    double[] decay = new double[n / 2];
    double[] turn = new double[n / 2];
    double[] axis = new double[n];
    double square = 0;
    for (int i = 0; i < n / 2; i++) {
      decay[i] = between(random, 0, widest);
      turn[i] = random.nextBoolean() ? 0 : decay[i] * between(random, -1, 0.7);
    }
    for (int l = 0; l < n; l++) {
      axis[l] = random.nextGaussian();
      square += axis[l] * axis[l];
    }
    double scale = 2 / square;
    double[] x = new double[n];
    FunctionOde ode =
        new FunctionOde(
            n,
            (t, y, yDot) -> {
              for (int l = 0; l < n; l++) {
                x[l] = y[l] - StrictMath.cos((1 + 0.3 * l) * t);
              }
              reflect(x, axis, scale);
              for (int i = 0; i < n / 2; i++) {
                double u = x[2 * i];
                double v = x[2 * i + 1];
                yDot[2 * i] = -decay[i] * u - turn[i] * v;
                yDot[2 * i + 1] = turn[i] * u - decay[i] * v;
              }
              reflect(yDot, axis, scale);
            });
    double[] start = new double[n];
    for (int l = 0; l < n; l++) {
      start[l] = random.nextDouble();
    }
    double end = 1 + 9 * random.nextDouble();
    return new StiffnessDraw(name, index, ode, start, end, tolerance(random), 1);
  }

  private static void reflect(double[] x, double[] axis, double scale) {
    double along = 0;
    for (int l = 0; l < x.length; l++) {
      along += axis[l] * x[l];
    }
    for (int l = 0; l < x.length; l++) {
      x[l] -= scale * along * axis[l];
    }
  }

  /** A ⇌ B, B + B ⇌ C + A, C → D, fed with A. */
  private static StiffnessDraw reactions(String name, int index, Random random) {
    double[] k = new double[5];
    for (int i = 0; i < k.length; i++) {
      k[i] = between(random, -1, 5);
    }
    double feed = random.nextBoolean() ? 0 : between(random, -2, 0);
    FunctionOde ode =
        new FunctionOde(
            4,
            (t, y, yDot) -> {
              double first = k[0] * y[0] - k[1] * y[1];
              double second = k[2] * y[1] * y[1] - k[3] * y[2] * y[0];
              double third = k[4] * y[2];
              yDot[0] = feed - first + second;
              yDot[1] = first - 2 * second;
              yDot[2] = second - third;
              yDot[3] = third;
            });
    double end = between(random, -1, 1.5);
    return new StiffnessDraw(
        name, index, ode, new double[] {1, 0, 0, 0}, end, tolerance(random), 1e-4);
  }

  /** u_t = c u_xx + a u (1 − u) on (0, 1), zero at 0, driven at 1; n points. */
  private static StiffnessDraw bar(String name, int index, Random random) {
    int n = 5 + random.nextInt(56);
    double conduction = between(random, -2, 0) * (n + 1) * (n + 1);
    double growth = random.nextBoolean() ? 0 : 5 * random.nextDouble();
    OdeSystem ode =
        new Tridiagonal(
            n,
            (t, y, yDot) -> {
              for (int l = 0; l < n; l++) {
                double left = l == 0 ? 0 : y[l - 1];
                double right = l == n - 1 ? StrictMath.sin(t) : y[l + 1];
                yDot[l] = conduction * (left - 2 * y[l] + right) + growth * y[l] * (1 - y[l]);
              }
            });
    double[] start = new double[n];
    for (int l = 0; l < n; l++) {
      start[l] = StrictMath.sin(Math.PI * (l + 1) / (n + 1));
    }
    double end = 0.5 + 2 * random.nextDouble();
    return new StiffnessDraw(name, index, ode, start, end, tolerance(random), 1);
  }

  /** A rate that rises and falls again by powers of ten. */
  private static StiffnessDraw forAWhile(String name, int index, Random random) {
    double most = 1 + 4 * random.nextDouble();
    double middle = 10 * random.nextDouble();
    double width = between(random, -0.3, 0.7);
    FunctionOde ode =
        new FunctionOde(
            2,
            (t, y, yDot) -> {
              double place = (t - middle) / width;
              double rate = StrictMath.pow(10, most / (1 + place * place));
              yDot[0] = -rate * (y[0] - y[1] * y[1]);
              yDot[1] = StrictMath.cos(3 * t) - 0.1 * y[0];
            });
    return new StiffnessDraw(name, index, ode, new double[] {1, 0}, 10, tolerance(random), 1);
  }

  /** Decays by 5 to 500 over the interval beside an oscillation. */
  private static StiffnessDraw hardlyStiff(String name, int index, Random random) {
    double rate = between(random, 0.7, 2.7);
    double slow = between(random, -0.5, 1);
    double coupling = random.nextDouble();
    FunctionOde ode =
        new FunctionOde(
            3,
            (t, y, yDot) -> {
              yDot[0] = slow * y[1];
              yDot[1] = -slow * y[0] * (1 + 0.2 * y[0] * y[0]);
              yDot[2] = -rate * (y[2] - y[0]) + coupling * y[1];
            });
    double end = 1 + 4 * random.nextDouble();
    return new StiffnessDraw(name, index, ode, new double[] {1, 0, 0}, end, tolerance(random), 1);
  }
}
