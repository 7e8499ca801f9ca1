package org.mechservice.solver.mechanism;

/**
 * A number that may be changed without building the model anew; expressions refer to it by its
 * index in {@link Mechanism#parameters()}.
 *
 * @param name name in the model file
 * @param value in SI units
 * @param unit SI unit, {@code 1} for a pure number
 */
public record Parameter(String name, double value, String unit) {}
