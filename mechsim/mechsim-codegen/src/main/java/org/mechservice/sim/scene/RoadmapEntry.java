package org.mechservice.sim.scene;

import org.mechservice.solver.api.JointType;

/**
 * The position of a joint in the state.
 *
 * @param joint the joint's name
 * @param type its type
 * @param axis its unit vector in the axes of its inner body (of the file's body 1 for a universal
 *     or planar joint), components separated by blanks; empty if it has none
 * @param positionUnit SI units of its coordinates, separated by blanks
 * @param velocityUnit SI units of its velocities, separated by blanks
 * @param driven whether its coordinates are prescribed and therefore not states
 * @param position index of its first coordinate in q
 * @param velocity index of its first velocity in v
 */
public record RoadmapEntry(
    String joint,
    JointType type,
    String axis,
    String positionUnit,
    String velocityUnit,
    boolean driven,
    int position,
    int velocity) {}
