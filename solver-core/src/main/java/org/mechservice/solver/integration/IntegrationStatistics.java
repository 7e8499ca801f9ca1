package org.mechservice.solver.integration;

/**
 * What an integration cost so far.
 *
 * @param steps accepted steps
 * @param rejectedSteps steps that failed the error test or met values that are not finite
 * @param evaluations evaluations of the right-hand side
 * @param stiffnessSuspected whether the steps look as if stability, not accuracy, limited them: an
 *     implicit method might take far fewer
 */
public record IntegrationStatistics(
    long steps, long rejectedSteps, long evaluations, boolean stiffnessSuspected) {}
