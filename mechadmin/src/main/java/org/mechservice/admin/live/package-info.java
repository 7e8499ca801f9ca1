/**
 * The state of all servers as it changes.
 *
 * <p>{@link org.mechservice.admin.live.ServerFollower} polls one server and follows its events;
 * {@link org.mechservice.admin.live.LiveView} merges the followers of all servers into one view
 * with its latest events and the load of every host ({@link org.mechservice.admin.live.SeenEvent},
 * {@link org.mechservice.admin.live.LoadSample}). The view is thread-safe; the terminal and the web
 * page read it.
 */
@NullMarked
package org.mechservice.admin.live;

import org.jspecify.annotations.NullMarked;
