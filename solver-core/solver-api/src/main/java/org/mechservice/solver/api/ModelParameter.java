package org.mechservice.solver.api;

/**
 * A parameter of a model file.
 *
 * @param name its name
 * @param unit its unit as the file writes it, {@code 1} for a pure number
 * @param value its value in this unit
 * @param tunable whether it remains an input of the model
 */
public record ModelParameter(String name, String unit, double value, boolean tunable) {}
