/**
 * Administration of a server: its servant, access rights, logs and metrics.
 *
 * <p>{@link org.mechservice.server.admin.MechAdminServant} answers the operations of MechAdmin.
 * {@link org.mechservice.sim.service.contract.AccessRights} lists the operations that each role may
 * call; {@link org.mechservice.sim.service.contract.DenialLog} logs refused calls, repeated ones
 * once a minute. {@link org.mechservice.server.admin.AuditLog} appends all events to a file of JSON
 * lines. {@link org.mechservice.server.admin.Metrics} counts in Prometheus' text format, and {@link
 * org.mechservice.server.admin.MetricsEndpoint} serves it over HTTP.
 *
 * <p>Depends on {@code server.hosts}.
 */
@NullMarked
package org.mechservice.server.admin;

import org.jspecify.annotations.NullMarked;
