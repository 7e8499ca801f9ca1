package org.mechservice.sim.scene;

import java.util.List;

/**
 * A constraint of a mechanism, with what it is at the start of the file.
 *
 * @param name the constraint's or cut joint's name
 * @param kind what it is, such as {@code distance} or {@code joint R}
 * @param bodies the two bodies it joins; empty for a relation between coordinates
 * @param path joints of the tree on the way from the one body to the other
 * @param equations number of its equations
 * @param positionResidual how far the start is from obeying it, in {@code unit}
 * @param velocityResidual the same of its rate, per s
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
