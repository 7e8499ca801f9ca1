package org.mechservice.sim.service;

/**
 * An ended run with its rows, which outlives its session.
 *
 * @param run what is known of it
 * @param rows its rows
 * @param until when it is deleted; UTC, ms since 1970-01-01
 */
record KeptRun(EndedRun run, ResultSpool rows, long until) {}
