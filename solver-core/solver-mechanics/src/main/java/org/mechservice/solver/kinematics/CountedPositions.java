package org.mechservice.solver.kinematics;

import java.util.Arrays;

/**
 * Coordinates of cut joints at the last accepted step. Angles are unwrapped relative to them, so a
 * checkpoint contains them. Workspace of one thread.
 */
public final class CountedPositions {
  private double[] position = new double[0];

  /** Adds a coordinate with its start value; returns its index. */
  public int add(double start) {
    position = Arrays.copyOf(position, position.length + 1);
    position[position.length - 1] = start;
    return position.length - 1;
  }

  /** Returns a coordinate at the last accepted step, rad or m. */
  public double get(int coordinate) {
    return position[coordinate];
  }

  /** Sets a coordinate after an accepted step, rad or m. */
  public void set(int coordinate, double accepted) {
    position[coordinate] = accepted;
  }

  /** Returns the number of coordinates. */
  public int count() {
    return position.length;
  }

  /** Writes all positions from an index of an array. */
  public void save(double[] state, int at) {
    System.arraycopy(position, 0, state, at, position.length);
  }

  /** Restores all positions that {@link #save} wrote, from an index of an array. */
  public void restore(double[] state, int at) {
    System.arraycopy(state, at, position, 0, position.length);
  }
}
