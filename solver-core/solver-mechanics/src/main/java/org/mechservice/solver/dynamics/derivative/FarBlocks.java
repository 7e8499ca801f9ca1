package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.add;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.multiply;

import java.util.Arrays;
import java.util.stream.LongStream;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * Terms of forces between any links, or by coordinates of other joints, in the equations of {@link
 * LinkJacobian} and {@link LinksAtRest}: for pairs of links, the change of the wrench on one and of
 * the forces in its joint by the motion of the other and by the coordinates of the other's joint.
 * Workspace of one thread.
 *
 * <p>It takes derivatives of forces, whose sign is the opposite: F = M a + b − τ − Jᵀ w.
 */
final class FarBlocks implements ForceJacobian {
  /** Most velocities of a link. */
  static final int MOST = 3;

  /** Where velocities and places begin in a motion. */
  static final int VELOCITY = 6;

  static final int PLACE = 12;

  private final TreeGeometry tree;

  /** Pairs as on · links + by, ascending. */
  private final long[] key;

  /** Link of the wrench or force and link that moves, for each pair. */
  final int[] on;

  final int[] by;

  /** Wrench by motion, 6 × 18 for each pair. */
  final double[] wrench;

  /** Joint forces by motion, three rows of 18 for each pair. */
  final double[] force;

  /** Wrench by coordinates, three columns of 6: by positions, by velocities, of the matrix. */
  final Columns wrenchBy;

  /** Joint forces by coordinates, three columns of three. */
  final Columns forceBy;

  private final double[] work = new double[6];

  /** Columns by positions and velocities, and those of the matrix of a step. */
  static final class Columns {
    final int height;
    final double[] place;
    final double[] velocity;
    final double[] combined;

    Columns(int pairs, int height) {
      this.height = height;
      place = new double[MOST * height * pairs];
      velocity = new double[MOST * height * pairs];
      combined = new double[MOST * height * pairs];
    }

    private void clear() {
      Arrays.fill(place, 0);
      Arrays.fill(velocity, 0);
    }

    private double sum() {
      return PlacedLinks.sum(place) + PlacedLinks.sum(velocity);
    }

    /** Returns where column k of a pair begins. */
    int at(int pair, int k) {
      return (MOST * pair + k) * height;
    }
  }

  /**
   * @param coupled links coupled by forces, two for each pair, without regard to their order;
   *     further ones between a link and itself are added
   */
  FarBlocks(TreeGeometry tree, int[] coupled) {
    this.tree = tree;
    LongStream.Builder keys = LongStream.builder();
    for (int i = 0; i < coupled.length; i += 2) {
      int a = coupled[i];
      int b = coupled[i + 1];
      if (a != TreeGeometry.ROOT && b != TreeGeometry.ROOT) {
        keys.add(key(a, b)).add(key(b, a)).add(key(a, a)).add(key(b, b));
      }
    }
    key = keys.build().sorted().distinct().toArray();
    on = LongStream.of(key).mapToInt(k -> (int) (k / tree.linkCount)).toArray();
    by = LongStream.of(key).mapToInt(k -> (int) (k % tree.linkCount)).toArray();
    wrench = new double[BLOCK * key.length];
    force = new double[MOST * WIDTH * key.length];
    wrenchBy = new Columns(key.length, 6);
    forceBy = new Columns(key.length, MOST);
  }

  private long key(int a, int b) {
    return (long) a * tree.linkCount + b;
  }

  int count() {
    return key.length;
  }

  /**
   * Returns the index of a pair.
   *
   * @throws IllegalStateException if a force couples links that it was not said to couple
   */
  int find(int a, int b) {
    int pair = Arrays.binarySearch(key, key(a, b));
    if (pair < 0) {
      throw new IllegalStateException(
          "a force on link " + a + " depends on link " + b + ", which was not announced");
    }
    return pair;
  }

  void clear() {
    Arrays.fill(wrench, 0);
    Arrays.fill(force, 0);
    wrenchBy.clear();
    forceBy.clear();
  }

  @Override
  public void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity) {
    subtract(wrench, BLOCK * find(on, by), 6, byPlace, byVelocity);
  }

  /** Subtracts lines of derivatives by a place and a velocity from those by a motion. */
  static void subtract(
      double[] matrix, int from, int lines, double[] byPlace, double[] byVelocity) {
    for (int r = 0; r < lines; r++) {
      int at = from + WIDTH * r;
      for (int c = 0; c < 6; c++) {
        matrix[at + VELOCITY + c] -= byVelocity[6 * r + c];
        matrix[at + PLACE + c] -= byPlace[6 * r + c];
      }
    }
  }

  @Override
  public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {
    if (by < tree.stateVelocityCount) {
      int link = tree.linkOfVelocity[by];
      int at = wrenchBy.at(find(on, link), by - tree.velocityAt[link]);
      for (int r = 0; r < 6; r++) {
        wrenchBy.place[at + r] -= byPlace[r];
        wrenchBy.velocity[at + r] -= byVelocity[r];
      }
    }
  }

  @Override
  public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {
    if (on < tree.stateVelocityCount) {
      int link = tree.linkOfVelocity[on];
      int line = MOST * find(link, by) + on - tree.velocityAt[link];
      subtract(force, WIDTH * line, 1, byPlace, byVelocity);
    }
  }

  @Override
  public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {
    if (on < tree.stateVelocityCount && by < tree.stateVelocityCount) {
      int link = tree.linkOfVelocity[by];
      int other = tree.linkOfVelocity[on];
      int column = forceBy.at(find(other, link), by - tree.velocityAt[link]);
      int at = column + on - tree.velocityAt[other];
      forceBy.place[at] -= byPlace;
      forceBy.velocity[at] -= byVelocity;
    }
  }

  /** Returns the sum of all derivatives, which is finite if they are. */
  double sum() {
    return PlacedLinks.sum(wrench) + PlacedLinks.sum(force) + wrenchBy.sum() + forceBy.sum();
  }

  /** Returns the number of velocities of a link that vary. */
  private int count(int link) {
    return tree.driven[link] ? 0 : tree.kind[link].velocityCount();
  }

  /**
   * Adds the change of wrenches and of joint forces.
   *
   * @param moved z, 18 for each link
   * @param x change of the velocities
   * @param placeAlone whether the columns by positions count, not those of the matrix
   * @param factor of the joint forces
   * @param wrenches 6 for each link; added to
   * @param sum joint forces; added to
   */
  void addProduct(
      double[] moved,
      double[] x,
      boolean placeAlone,
      double factor,
      double[] wrenches,
      double[] sum) {
    double[] ofWrench = placeAlone ? wrenchBy.place : wrenchBy.combined;
    double[] ofForce = placeAlone ? forceBy.place : forceBy.combined;
    for (int pair = 0; pair < key.length; pair++) {
      multiply(wrench, pair, moved, WIDTH * by[pair], work, 0);
      add(work, 0, 1, wrenches, 6 * on[pair]);
      int first = tree.velocityAt[by[pair]];
      for (int k = 0; k < count(by[pair]); k++) {
        add(ofWrench, wrenchBy.at(pair, k), x[first + k], wrenches, 6 * on[pair]);
      }
      for (int j = 0; j < count(on[pair]); j++) {
        double change = 0;
        for (int c = 0; c < WIDTH; c++) {
          change += force[(MOST * pair + j) * WIDTH + c] * moved[WIDTH * by[pair] + c];
        }
        for (int k = 0; k < count(by[pair]); k++) {
          change += ofForce[forceBy.at(pair, k) + j] * x[first + k];
        }
        sum[tree.velocityAt[on[pair]] + j] += factor * change;
      }
    }
  }
}
