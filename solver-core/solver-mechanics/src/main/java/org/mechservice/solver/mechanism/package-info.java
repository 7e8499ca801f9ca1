/**
 * The immutable description of a mechanism: bodies, joints, where they start, what drives them,
 * what closes loops, what acts. SI units throughout.
 *
 * <p>Descriptions are shared freely between threads; whatever computes with one keeps its own
 * workspace.
 */
package org.mechservice.solver.mechanism;
