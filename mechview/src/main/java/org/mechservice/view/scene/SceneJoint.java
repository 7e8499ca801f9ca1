package org.mechservice.view.scene;

import org.mechservice.solver.api.JointType;

/**
 * A joint of a picture, of the tree or cut.
 *
 * @param name name in the model file
 * @param type its kind
 * @param cut whether it closes a loop instead of leading to a body
 * @param driven whether its coordinates follow a prescribed motion
 * @param first its point on the body nearer the root
 * @param second its point on the other body
 * @param axis unit vector in the axes of the first body: the axis of a turn or slide, the normal of
 *     a planar joint, the first axis of a universal joint; zero for a joint without one
 * @param axis2 unit vector in the axes of the second body: the other axis of a universal joint;
 *     zero for every other joint
 */
public record SceneJoint(
    String name,
    JointType type,
    boolean cut,
    boolean driven,
    Anchor first,
    Anchor second,
    Point3 axis,
    Point3 axis2) {}
