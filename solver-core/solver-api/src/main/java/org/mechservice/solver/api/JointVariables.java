package org.mechservice.solver.api;

/**
 * A joint as the state sees it.
 *
 * @param name the joint's name in the model file
 * @param type decides how many coordinates it has and in which units
 */
public record JointVariables(String name, JointType type) {}
