package org.mechservice.solver.closure.equations;

/**
 * What an equation of the loops depends on.
 *
 * @param ways links whose joints it depends on, ascending
 * @param loaded links on which its multiplier puts a wrench, ascending; the root is left out
 * @param velocities extended velocities on which its multiplier puts a force, ascending
 */
public record RowSupport(int[] ways, int[] loaded, int[] velocities) {}
