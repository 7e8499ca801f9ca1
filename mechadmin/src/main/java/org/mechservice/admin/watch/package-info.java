/**
 * {@code mech admin watch}: a table in the terminal that updates itself.
 *
 * <p>{@link org.mechservice.admin.watch.Watch} reads keys and draws; {@link
 * org.mechservice.admin.watch.WatchKey} decodes a key, {@link
 * org.mechservice.admin.watch.WatchState} holds selection, filter and order and says which action a
 * key means, {@link org.mechservice.admin.watch.WatchScreen} turns state and view into lines of
 * text without any terminal. Calls to servers run in the background, so that keys are always
 * answered.
 */
@NullMarked
package org.mechservice.admin.watch;

import org.jspecify.annotations.NullMarked;
