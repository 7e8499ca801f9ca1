/**
 * Classes that users have written for their forces: the one place where they are admitted ({@link
 * org.mechservice.sim.user.UserClasses#admit}) and the one where they are loaded ({@link
 * org.mechservice.sim.user.UserClasses#loader}).
 */
@NullMarked
package org.mechservice.sim.user;

import org.jspecify.annotations.NullMarked;
