package org.mechservice.report.method;

/**
 * A method the scene cannot be run with.
 *
 * @param method the method
 * @param reason the service's, with its code
 */
public record OmittedMethod(SimulationMethod method, String reason) {}
