/**
 * {@code mech admin web}: the administration page, served on the loopback interface.
 *
 * <p>{@link org.mechservice.admin.web.AdminWeb} is the HTTP server. It checks host name and origin
 * of every {@link org.mechservice.orb.http.Request}, and the token against {@link
 * org.mechservice.admin.web.AccessTokens}: a {@link org.mechservice.admin.web.Right} to see or to
 * steer. {@link org.mechservice.orb.http.PageFiles} and {@link
 * org.mechservice.admin.web.ErrorPages} serve the files, {@link org.mechservice.admin.web.Api}
 * answers the page's requests, and {@link org.mechservice.admin.web.Streams} sends updates as
 * server-sent events.
 *
 * <p>{@link org.mechservice.admin.web.Overview} and {@link org.mechservice.admin.web.RowTable}
 * compute the changes since a page's last update. An {@link
 * org.mechservice.admin.web.ActionRequest} is a change that the page requests; {@link
 * org.mechservice.admin.web.AdminAuditLog} records every change and every refusal.
 */
@NullMarked
package org.mechservice.admin.web;

import org.jspecify.annotations.NullMarked;
