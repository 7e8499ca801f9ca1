package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.closure.assembly.Assembly;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.StartRole;

/**
 * Starts of seeded mechanisms with joints of all types, in the tree and cut, far from positions
 * that close the loops: turned by multiples of 90 degrees, at which tilts of cut joints have no
 * value, or anyhow. All can be closed. The reference knows neither the derivatives nor the far
 * values of the product: Gauss-Newton steps with differences of Φ and a pseudoinverse by singular
 * values, from many states, each followed by a descent of the distance along the closed positions.
 */
class NearestStartTest {
  /** The rounding of a few turns and displacements of about a length of the mechanism. */
  private static final double CLOSED = 1e-12;

  private static final int SLICE = 32;
  private static final int ALL = 1000;

  /** States from which the reference begins. */
  private static final int STARTS = 24;

  /**
   * Relative difference of the distance from that of the reference, which converges linearly and
   * stops at a hundredth of it.
   */
  private static final double AS_NEAR = 1e-3;

  /** A mechanism whose joints all may move, and which closes somewhere. */
  private static Mechanism mechanism(int seed) {
    Random random = new Random(seed);
    Mechanism loops = RandomLoops.of(seed, 2 + random.nextInt(3), 1 + random.nextInt(2));
    return new Mechanism(
        loops.name(),
        loops.root(),
        loops.gravity(),
        loops.bodies(),
        loops.joints(),
        List.of(),
        loops.joints().stream().map(joint -> StartRole.FREE).toList(),
        loops.closures(),
        List.of(),
        List.of());
  }

  /** Turns the start: by multiples of 90 degrees for even seeds, anyhow for odd ones. */
  private static double[] start(Mechanism mechanism, StateCoordinates coordinates, int seed) {
    Random random = new Random(-seed);
    boolean quarters = seed % 2 == 0;
    double[] y = new double[mechanism.stateCount()];
    mechanism.initialState(y);
    int nv = coordinates.velocityCount();
    double[] move = new double[nv];
    int at = 0;
    for (var joint : mechanism.joints()) {
      JointType type = joint.type();
      int single = random.nextInt(3);
      for (int i = 0; i < type.velocityCount(); i++) {
        boolean turns = type.velocityUnit(i).equals("rad/s");
        boolean ball = type.hasEulerParameters() && i < 3;
        double size = quarters ? random.nextInt(4) * Math.PI / 2 : Math.PI * uniform(random);
        // quarter turns of a ball about one axis; displacements of at most half a metre
        move[at++] = !turns ? 0.5 * uniform(random) : ball && quarters && i != single ? 0 : size;
      }
    }
    coordinates.move(y, 0, move, 0, 1);
    return y;
  }

  private static double uniform(Random random) {
    return 2 * random.nextDouble() - 1;
  }

  /** The reference. */
  private static final class Reference {
    private final TreeMotion motion;
    private final LoopEquations loops;
    private final StateCoordinates coordinates;
    private final double[] unit;
    private final double[] given;

    Reference(Mechanism mechanism, double[] given) {
      TreeGeometry tree = new TreeGeometry(mechanism);
      motion = new TreeMotion(tree);
      loops = new LoopEquations(tree);
      coordinates = new StateCoordinates(mechanism);
      unit = new CoordinateUnits(mechanism, loops.length()).velocities;
      this.given = given;
    }

    private double[] values(double[] y) {
      motion.sweep(0, y);
      loops.place(motion, 0);
      double[] values = new double[loops.count()];
      Arrays.setAll(values, row -> loops.value[row] / loops.size(row));
      return values;
    }

    private double[] moved(double[] y, double[] x, double factor) {
      double[] at = y.clone();
      double[] move = new double[unit.length];
      Arrays.setAll(move, j -> x[j] * unit[j]);
      coordinates.move(at, 0, move, 0, factor);
      return at;
    }

    private RealMatrix inverse(double[] y) {
      double h = 1e-6;
      double[][] jacobian = new double[loops.count()][unit.length];
      for (int j = 0; j < unit.length; j++) {
        double[] one = new double[unit.length];
        one[j] = 1;
        double[] plus = values(moved(y, one, h));
        double[] minus = values(moved(y, one, -h));
        for (int row = 0; row < plus.length; row++) {
          jacobian[row][j] = (plus[row] - minus[row]) / (2 * h);
        }
      }
      SingularValueDecomposition values =
          new SingularValueDecomposition(new Array2DRowRealMatrix(jacobian, false));
      double[] sigma = values.getSingularValues();
      RealMatrix inverse = new Array2DRowRealMatrix(unit.length, loops.count());
      for (int k = 0; k < sigma.length && sigma[k] > 1e-6 * sigma[0]; k++) {
        inverse =
            inverse.add(
                values
                    .getV()
                    .getColumnMatrix(k)
                    .multiply(values.getUT().getRowMatrix(k))
                    .scalarMultiply(1 / sigma[k]));
      }
      this.jacobian = new Array2DRowRealMatrix(jacobian, false);
      return inverse;
    }

    private RealMatrix jacobian = new Array2DRowRealMatrix(1, 1);

    /** Closes the loops near a state; returns whether it could. */
    private boolean close(double[] y) {
      for (int i = 0; i < 40; i++) {
        double[] values = values(y);
        double size = norm(values);
        if (size < 1e-10) {
          return true;
        }
        if (!Double.isFinite(size)) {
          return false;
        }
        double[] step = inverse(y).operate(values);
        double longest = Arrays.stream(step).map(Math::abs).max().orElse(0);
        if (!Double.isFinite(longest)) {
          return false;
        }
        System.arraycopy(moved(y, step, -Math.min(1, 0.3 / longest)), 0, y, 0, y.length);
      }
      return false;
    }

    double distance(double[] y) {
      return norm(displacement(y));
    }

    private double[] displacement(double[] y) {
      double[] d = new double[unit.length];
      coordinates.moveBetween(given, y, d);
      Arrays.setAll(d, j -> d[j] / unit[j]);
      return d;
    }

    private void descend(double[] y) {
      double size = 1;
      for (int i = 0; i < 200 && size > 1e-6; i++) {
        double[] d = displacement(y);
        double[] back = inverse(y).operate(jacobian.operate(d));
        double[] downhill = new double[d.length];
        Arrays.setAll(downhill, j -> back[j] - d[j]);
        if (norm(downhill) < 1e-3 * norm(d)) {
          return;
        }
        double[] tried = moved(y, downhill, size);
        if (close(tried) && distance(tried) < norm(d)) {
          System.arraycopy(tried, 0, y, 0, y.length);
          size = Math.min(1, 2 * size);
        } else {
          size /= 4;
        }
      }
    }

    /** Returns the least distance found, infinite if nothing closes the loops. */
    double nearest(int seed) {
      Random random = new Random(seed);
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < STARTS; i++) {
        double size = Math.PI * i / STARTS;
        double[] move = new double[unit.length];
        Arrays.setAll(move, j -> uniform(random));
        double[] y = moved(given, move, size + 1e-3);
        if (close(y)) {
          descend(y);
          least = Math.min(least, distance(y));
        }
      }
      return least;
    }

    private static double norm(double[] x) {
      return Math.sqrt(Arrays.stream(x).map(part -> part * part).sum());
    }
  }

  /**
   * What became of starts.
   *
   * @param open how many neither way closed
   * @param farther how many were closed up to 2 % farther away than by the reference
   */
  private record Count(int open, int farther) {}

  /** Checks the seeds up to a number. */
  private static Count of(int count) {
    Set<JointType> inTree = EnumSet.noneOf(JointType.class);
    Set<JointType> cut = EnumSet.noneOf(JointType.class);
    int open = 0;
    int farther = 0;
    for (int seed = 1; seed <= count; seed++) {
      Mechanism mechanism = mechanism(seed);
      if (mechanism.velocityCount() == 0) {
        continue;
      }
      mechanism.joints().forEach(joint -> inTree.add(joint.type()));
      for (LoopClosure closure : mechanism.closures()) {
        if (closure instanceof JointClosure joint) {
          cut.add(joint.joint().type());
        }
      }
      double[] given = start(mechanism, new StateCoordinates(mechanism), seed);
      double[] y = given.clone();
      List<LoopFinding> findings = new Assembly(new TreeGeometry(mechanism)).assemble(0, y);
      Reference reference = new Reference(mechanism, given);
      double least = reference.nearest(seed);
      boolean closed =
          findings.stream().noneMatch(one -> one.kind() == LoopFinding.Kind.NOT_CLOSED);
      assertThat(closed || least == Double.POSITIVE_INFINITY).as("closed, seed %d", seed).isTrue();
      assertThat(findings).as("seed %d", seed).allMatch(one -> Double.isFinite(one.amount()));
      if (closed) {
        for (double residual : reference.values(y)) {
          assertThat(residual).as("residual, seed %d", seed).isCloseTo(0, within(CLOSED));
        }
        double distance = reference.distance(y);
        assertThat(distance).as("distance, seed %d", seed).isLessThanOrEqualTo(1.02 * least);
        farther += distance > (1 + AS_NEAR) * least ? 1 : 0;
      } else {
        open++;
      }
    }
    // joints of type F forbid nothing and are never cut
    assertThat(inTree).containsAll(EnumSet.allOf(JointType.class));
    assertThat(cut).containsAll(EnumSet.complementOf(EnumSet.of(JointType.F)));
    return new Count(open, farther);
  }

  @Test
  void startsCloseAtTheNearestPositions() {
    assertThat(of(SLICE)).isEqualTo(new Count(0, 0));
  }

  /**
   * Six of the thousand close at single points, with no freedom left, that neither way finds among
   * its starts. One ends in a local minimum of the distance, 0.7 % farther away than another.
   */
  @Tag("soak")
  @Test
  void aThousandStartsCloseAtTheNearestPositions() {
    Count count = of(ALL);
    assertThat(count.open).isLessThanOrEqualTo(6);
    assertThat(count.farther).isLessThanOrEqualTo(1);
  }
}
