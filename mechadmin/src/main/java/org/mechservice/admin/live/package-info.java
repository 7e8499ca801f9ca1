/**
 * The state of all servers as it changes.
 *
 * <p>{@link org.mechservice.admin.live.ServerFollower} polls one server and follows its events;
 * {@link org.mechservice.admin.live.LiveView} merges the followers of all servers into one view
 * with its latest events and the load of every host ({@link
 * org.mechservice.admin.live.ReceivedEvent}, {@link org.mechservice.admin.live.LoadSample}). The
 * view is thread-safe; the terminal and the web page read it.
 *
 * <p>Each server is followed by a thread of its own, so that one that hangs delays nothing but its
 * own line, and stays in the view: an operator must see what is missing. A server is read whenever
 * something happened there, and events are asked for from the last one seen on. The view keeps the
 * latest 500 events and ten minutes of load.
 */
@NullMarked
package org.mechservice.admin.live;

import org.jspecify.annotations.NullMarked;
