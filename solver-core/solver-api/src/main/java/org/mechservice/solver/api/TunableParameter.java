package org.mechservice.solver.api;

/**
 * A parameter of a model that may be changed before a run.
 *
 * @param name name in the model file
 * @param unit its unit in the model file, used for values; {@code 1} for a pure number
 * @param value its value, in this unit
 */
public record TunableParameter(String name, String unit, double value) {}
