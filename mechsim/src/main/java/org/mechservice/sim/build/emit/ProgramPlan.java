package org.mechservice.sim.build.emit;

import java.util.List;
import org.mechservice.sim.symbolic.Scalar;

/**
 * How a program becomes code.
 *
 * @param angles the angles whose sines and cosines the program needs, computed first: sine of angle
 *     i in slot 2 i of the workspace, cosine in slot 2 i + 1
 * @param methods what follows, in order
 * @param slots length of workspace it needs
 */
record ProgramPlan(List<Scalar> angles, List<MethodPlan> methods, int slots) {}
