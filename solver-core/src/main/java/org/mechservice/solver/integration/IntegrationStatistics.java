package org.mechservice.solver.integration;

/**
 * What an integration cost so far.
 *
 * @param steps accepted steps
 * @param rejectedSteps steps that failed the error test or met values that are not finite
 * @param evaluations evaluations of the right-hand side
 */
public record IntegrationStatistics(long steps, long rejectedSteps, long evaluations) {}
