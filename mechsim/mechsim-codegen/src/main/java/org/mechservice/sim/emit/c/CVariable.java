package org.mechservice.sim.emit.c;

/**
 * An element of one of the arrays of a model in C.
 *
 * @param name its name, as in results
 * @param unit SI unit
 * @param description what it is, in a few words
 * @param start its value at the start, SI; 0 for outputs
 */
public record CVariable(String name, String unit, String description, double start) {}
