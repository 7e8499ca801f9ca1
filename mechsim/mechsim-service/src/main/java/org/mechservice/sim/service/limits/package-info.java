/**
 * What a host allows its clients, and the checks.
 *
 * <p>{@link org.mechservice.sim.service.limits.HostLimit} lists the limits with unit, default and
 * message code; {@link org.mechservice.sim.service.limits.HostLimits} is one immutable set of
 * values; {@link org.mechservice.sim.service.limits.CurrentLimits} holds the set that an operator
 * may replace while the host runs.
 *
 * <p>Three classes check them. {@link org.mechservice.sim.service.limits.AdmissionControl} decides
 * whether one more simulation is created. {@link org.mechservice.sim.service.limits.TimeBudget}
 * measures the time of one run, and {@link org.mechservice.sim.service.limits.SpoolQuota} the disk
 * of all rows; both report a run beyond its limit by {@link
 * org.mechservice.sim.service.limits.LimitReachedException}, with which the run ends.
 *
 * <p>Depends on the IDL stubs alone.
 */
@NullMarked
package org.mechservice.sim.service.limits;

import org.jspecify.annotations.NullMarked;
