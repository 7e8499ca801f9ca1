package org.mechservice.mechml.resolve;

import org.mechservice.mechml.AbsoluteTolerances;

/**
 * An integrator and its settings, as {@link org.mechservice.solver.api.RunSettings} defines them.
 *
 * @param name as the file gives it
 * @param relativeTolerance between 0 and 1
 * @param absoluteTolerances positive, SI
 * @param maxStep s; infinite if the file leaves it open
 * @param initialStep s; 0 if the file leaves it open
 * @param maxOrder 0 if the file leaves it open
 */
record IntegratorChoice(
    String name,
    double relativeTolerance,
    AbsoluteTolerances absoluteTolerances,
    double maxStep,
    double initialStep,
    int maxOrder) {}
