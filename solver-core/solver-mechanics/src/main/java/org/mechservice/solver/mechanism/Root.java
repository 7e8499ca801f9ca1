package org.mechservice.solver.mechanism;

import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The body at rest to which the mechanism is attached.
 *
 * @param name name in the model file
 * @param position its origin in the world, m
 * @param orientation from its axes to world axes
 */
public record Root(String name, Vector3 position, Rotation orientation) {}
