package org.mechservice.sim.scene;

import org.mechservice.solver.api.JointType;

/**
 * Where a joint is in the state.
 *
 * @param joint the joint's name
 * @param type its kind
 * @param axis its unit vector in the axes of its inner body, components separated by blanks
 * @param positionUnit SI unit of its coordinate
 * @param velocityUnit SI unit of its velocity
 * @param position index of its first coordinate in q
 * @param velocity index of its first velocity in v
 */
public record RoadmapEntry(
    String joint,
    JointType type,
    String axis,
    String positionUnit,
    String velocityUnit,
    int position,
    int velocity) {}
