/**
 * Import of robots in URDF, SDF and MJCF to MechML, and export to URDF.
 *
 * <p>{@link org.mechservice.mechml.robot.RobotImport} is the main type; {@link
 * org.mechservice.mechml.robot.RobotFormat} tells the formats apart by the outermost element. A
 * reader for each turns the file into one {@link org.mechservice.mechml.robot.Robot}: {@link
 * org.mechservice.mechml.robot.UrdfReader} with {@link
 * org.mechservice.mechml.robot.UrdfJointReader}; {@link org.mechservice.mechml.robot.SdfReader}
 * with the frames of {@link org.mechservice.mechml.robot.SdfFrames}; {@link
 * org.mechservice.mechml.robot.MjcfReader} with {@link
 * org.mechservice.mechml.robot.MjcfJointReader}, the default classes of {@link
 * org.mechservice.mechml.robot.MjcfDefaults} and the inertia of {@link
 * org.mechservice.mechml.robot.MjcfShapes}. {@link org.mechservice.mechml.robot.RobotTree} finds
 * the root, the joints that close loops and the positions at the start. {@link
 * org.mechservice.mechml.robot.MechmlRobot} writes the MechML document, with {@link
 * org.mechservice.mechml.robot.RobotJoints} for the joints and {@link
 * org.mechservice.mechml.robot.TagBuilder} for each element.
 *
 * <p>The import keeps masses, inertias, joints and frames. {@link
 * org.mechservice.mechml.robot.ImportLosses} reports each part of the file that MechML cannot
 * express as a warning M-085 with its position. {@link org.mechservice.mechml.robot.RobotExport}
 * goes the other way: {@link org.mechservice.mechml.robot.UrdfWriter} writes a mechanism as the
 * elements of a robot, with {@link org.mechservice.mechml.robot.UrdfShapes} for what bodies look
 * like and {@link org.mechservice.mechml.robot.UrdfFrames} for poses; {@link
 * org.mechservice.mechml.robot.ExportLosses} reports what URDF lacks. The formats are defined at
 * wiki.ros.org/urdf/XML, sdformat.org and in the XML reference of MuJoCo's documentation.
 */
@NullMarked
package org.mechservice.mechml.robot;

import org.jspecify.annotations.NullMarked;
