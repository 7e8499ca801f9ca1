package org.mechservice.solver.kinematics;

import java.util.Arrays;

/**
 * Where coordinates of cut joints were at the last accepted step: their angles count whole turns
 * from there, so a run that is taken up needs them. Workspace of one thread.
 */
public final class CountedPositions {
  private double[] position = new double[0];

  /** Adds a coordinate; returns its index. */
  public int add(double start) {
    position = Arrays.copyOf(position, position.length + 1);
    position[position.length - 1] = start;
    return position.length - 1;
  }

  /** Returns where a coordinate was, rad or m. */
  public double get(int coordinate) {
    return position[coordinate];
  }

  /** Takes note of where a coordinate is after an accepted step, rad or m. */
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

  /** Takes all positions from an index of an array, as {@link #save} wrote them. */
  public void restore(double[] state, int at) {
    System.arraycopy(state, at, position, 0, position.length);
  }
}
