/**
 * Import from URDF, the Unified Robot Description Format, to MechML.
 *
 * <p>{@link org.mechservice.mechml.urdf.UrdfImport} is the main type. {@link
 * org.mechservice.mechml.urdf.UrdfReader} reads the file into a {@link
 * org.mechservice.mechml.urdf.UrdfRobot}, with {@link org.mechservice.mechml.urdf.UrdfJointReader}
 * for the joints. {@link org.mechservice.mechml.urdf.UrdfTree} checks that the links form a tree
 * and finds the positions at the start. {@link org.mechservice.mechml.urdf.MechmlRobot} writes the
 * MechML document, with {@link org.mechservice.mechml.urdf.RobotJoints} for the joints and {@link
 * org.mechservice.mechml.urdf.TagBuilder} for each element.
 *
 * <p>The import keeps masses, inertias, joints and frames. {@link
 * org.mechservice.mechml.urdf.ImportLosses} reports each part of the file that MechML cannot
 * express as a warning M-085 with its position. The format is defined at wiki.ros.org/urdf/XML.
 */
@NullMarked
package org.mechservice.mechml.urdf;

import org.jspecify.annotations.NullMarked;
