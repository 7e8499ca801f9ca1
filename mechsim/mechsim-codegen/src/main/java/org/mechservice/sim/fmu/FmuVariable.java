package org.mechservice.sim.fmu;

/**
 * A variable of an FMU.
 *
 * @param name its name, unique among those of its kind
 * @param unit its unit, as a product of powers such as {@code kg*m^2/s}; empty without dimension
 * @param description one line for people; may be empty
 * @param start its value at the start; of no meaning for outputs
 */
public record FmuVariable(String name, String unit, String description, double start) {}
