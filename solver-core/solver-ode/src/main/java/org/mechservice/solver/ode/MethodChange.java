package org.mechservice.solver.ode;

/**
 * A place at which one method took over from another.
 *
 * @param time where
 * @param stiff whether the method for stiff problems took over: stability had limited the steps of
 *     the other; else an explicit step would have cost no more
 * @param stepSize of the last step before, signed
 */
public record MethodChange(double time, boolean stiff, double stepSize) {}
