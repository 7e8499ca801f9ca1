package org.mechservice.solver.api;

/**
 * A joint with states.
 *
 * @param name the joint's name in the model file
 * @param type its type, which determines number and units of its coordinates
 */
public record JointVariables(String name, JointType type) {}
