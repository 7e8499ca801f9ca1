/**
 * Imported robots beside the programs that their files are written for.
 *
 * <p>{@link org.mechservice.benchmarks.robot.RobotAccelerations} reads a robot as {@code mech
 * import} does and computes its accelerations in given states by articulated bodies over data, from
 * which all formulations and the generated code do not differ by more than rounding ({@code
 * docs/reports/generated-agreement.md}). The script {@code benchmarks/peers/robots.py} draws the
 * states, asks Pinocchio for the robots in URDF and MuJoCo for those in MJCF, and writes {@code
 * docs/reports/robots.md}.
 *
 * <p>States go through files of doubles, because a text of a thousand states of forty joints takes
 * longer to write and read than to compute.
 */
@NullMarked
package org.mechservice.benchmarks.robot;

import org.jspecify.annotations.NullMarked;
