/**
 * Import of robots in URDF, SDF and MJCF to MechML, and export to URDF.
 *
 * <p>{@link org.mechservice.robot.RobotImport} is the main type. A file passes through these
 * stages:
 *
 * <ol>
 *   <li>{@link org.mechservice.robot.RobotFormat} tells the format by the outermost element. {@link
 *       org.mechservice.robot.RobotFiles} finds the files that it names: includes, packages,
 *       meshes.
 *   <li>{@link org.mechservice.robot.FormatTable} holds the world of the format closed: every
 *       element and attribute of its published schema is read, harmless, or left out with a {@link
 *       org.mechservice.robot.LossGrade}. {@link org.mechservice.robot.ImportLosses} collects what
 *       is left out, {@link org.mechservice.robot.LossReport} tells it.
 *   <li>A reader for each format turns the file into one {@link org.mechservice.robot.Robot}:
 *       {@link org.mechservice.robot.UrdfReader}; {@link org.mechservice.robot.SdfReader} with
 *       {@link org.mechservice.robot.SdfIncludes} and {@link org.mechservice.robot.SdfFrames};
 *       {@link org.mechservice.robot.MjcfReader}, which takes a {@link
 *       org.mechservice.robot.MjcfFile} with includes and default classes put in, and leaves
 *       equations, tendons and motors to {@link org.mechservice.robot.MjcfForces} and {@link
 *       org.mechservice.robot.MjcfActuators} (muscles: {@link org.mechservice.robot.MjcfMuscle}),
 *       what MuJoCo refuses to {@link org.mechservice.robot.MjcfRules}, inertias of motors and
 *       tendons to {@link org.mechservice.robot.MjcfArmatures}, masses of shapes to {@link
 *       org.mechservice.robot.MjcfGeometry}, and keyframes to {@link
 *       org.mechservice.robot.MjcfKeyframe}. {@link org.mechservice.robot.ShapeMasses}, {@link
 *       org.mechservice.robot.UniformShape} and {@link org.mechservice.robot.TriangleMesh} compute
 *       inertias.
 *   <li>{@link org.mechservice.robot.RobotRoot} decides whether the root rests, {@link
 *       org.mechservice.robot.RobotTree} finds the root, the joints that close loops and the
 *       positions at the start.
 *   <li>{@link org.mechservice.robot.MechmlRobot} writes the MechML document, with {@link
 *       org.mechservice.robot.RobotJoints} for joints and their stops, whose stiffness follows from
 *       {@link org.mechservice.robot.RobotInertia}, {@link org.mechservice.robot.RobotActions} for
 *       loops and forces, and {@link org.mechservice.robot.RobotLooks} for what bodies look like.
 * </ol>
 *
 * <p>{@link org.mechservice.robot.RobotExport} goes the other way: {@link
 * org.mechservice.robot.UrdfWriter} writes a mechanism as the elements of a robot, with {@link
 * org.mechservice.robot.UrdfShapes} for what bodies look like, {@link
 * org.mechservice.robot.UrdfRoot} for the mass of the root and {@link
 * org.mechservice.robot.UrdfFrames} for poses; {@link org.mechservice.robot.ExportLosses} reports
 * what URDF lacks. The formats are defined at wiki.ros.org/urdf/XML, sdformat.org and in the XML
 * reference of MuJoCo's documentation.
 */
@NullMarked
package org.mechservice.robot;

import org.jspecify.annotations.NullMarked;
