package org.mechservice.sim.scene;

import java.util.List;

/**
 * A constraint of a mechanism, with its residuals at the start.
 *
 * @param name the constraint's or cut joint's name
 * @param kind its kind, such as {@code distance} or {@code joint R}
 * @param bodies the two bodies that it connects; empty for a coupling of coordinates
 * @param path joints of the tree on the path between the two bodies
 * @param equations number of its equations
 * @param positionResidual largest residual at the start, in {@code unit}
 * @param velocityResidual largest residual of its rate, per s
 * @param unit SI unit of the residual: {@code m}, {@code rad} or {@code 1}
 */
public record LoopEntry(
    String name,
    String kind,
    List<String> bodies,
    List<String> path,
    int equations,
    double positionResidual,
    double velocityResidual,
    String unit) {

  public LoopEntry {
    bodies = List.copyOf(bodies);
    path = List.copyOf(path);
  }
}
