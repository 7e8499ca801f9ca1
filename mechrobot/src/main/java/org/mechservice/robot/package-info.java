/**
 * Import of robots in URDF, SDF and MJCF to MechML, and export to URDF.
 *
 * <p>{@link org.mechservice.robot.RobotImport} is the main type; {@link
 * org.mechservice.robot.RobotFormat} tells the formats apart by the outermost element. A reader for
 * each turns the file into one {@link org.mechservice.robot.Robot}: {@link
 * org.mechservice.robot.UrdfReader} with {@link org.mechservice.robot.UrdfJointReader}; {@link
 * org.mechservice.robot.SdfReader} with the frames of {@link org.mechservice.robot.SdfFrames};
 * {@link org.mechservice.robot.MjcfReader} with {@link org.mechservice.robot.MjcfJointReader}, the
 * default classes of {@link org.mechservice.robot.MjcfDefaults} and the inertia of {@link
 * org.mechservice.robot.MjcfShapes}. {@link org.mechservice.robot.RobotTree} finds the root, the
 * joints that close loops and the positions at the start. {@link org.mechservice.robot.MechmlRobot}
 * writes the MechML document, with {@link org.mechservice.robot.RobotJoints} for the joints and
 * {@link org.mechservice.robot.TagBuilder} for each element.
 *
 * <p>The import keeps masses, inertias, joints and frames. {@link
 * org.mechservice.robot.ImportLosses} reports each part of the file that MechML cannot express as a
 * warning M-085 with its position. {@link org.mechservice.robot.RobotExport} goes the other way:
 * {@link org.mechservice.robot.UrdfWriter} writes a mechanism as the elements of a robot, with
 * {@link org.mechservice.robot.UrdfShapes} for what bodies look like and {@link
 * org.mechservice.robot.UrdfFrames} for poses; {@link org.mechservice.robot.ExportLosses} reports
 * what URDF lacks. The formats are defined at wiki.ros.org/urdf/XML, sdformat.org and in the XML
 * reference of MuJoCo's documentation.
 */
@NullMarked
package org.mechservice.robot;

import org.jspecify.annotations.NullMarked;
