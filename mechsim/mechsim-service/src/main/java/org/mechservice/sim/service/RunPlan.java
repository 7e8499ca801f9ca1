package org.mechservice.sim.service;

/**
 * A run that is asked for.
 *
 * @param identity what it is called and whose it is
 * @param task computes it
 * @param columns of its rows
 * @param facts what the service knows beyond the solver's report
 */
record RunPlan(RunIdentity identity, RunTask task, RunColumns columns, RunFacts facts) {}
