package org.mechservice.solver.api.result;

/**
 * A quantity in the results: one column.
 *
 * @param name column name, such as {@code j1.q}
 * @param unit SI unit, {@code 1} for a pure number
 */
public record Variable(String name, String unit) {}
