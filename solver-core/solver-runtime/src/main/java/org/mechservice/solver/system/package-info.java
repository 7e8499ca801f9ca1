/**
 * Linear time-invariant systems x' = A x + B u, y = C x + D u, as the linearisation of a mechanism
 * with inputs and outputs gives them.
 *
 * <p>{@link org.mechservice.solver.system.LinearSystem} holds the four matrices with the names and
 * units of states, inputs and outputs. {@link org.mechservice.solver.system.FrequencyResponse}
 * evaluates the transfer functions C (iω − A)⁻¹ B + D along the imaginary axis, and {@link
 * org.mechservice.solver.system.TransmissionZeros} finds the complex frequencies at which inputs
 * have no effect on the outputs.
 *
 * <p>The package knows no mechanics. It is used once per analysis, not in a run, and allocates as
 * it likes.
 */
package org.mechservice.solver.system;
