package org.mechservice.mechml;

import org.mechservice.solver.api.RunSettings;

/**
 * What the file's simulation block asks for.
 *
 * @param run interval, output distance, integrator, tolerances; the integrator as the file names it
 * @param formulation formulation asked for; {@code auto} if the file leaves it open
 */
public record SimulationSettings(RunSettings run, String formulation) {}
