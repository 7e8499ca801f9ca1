/** Starting an ORB safely; no service logic. */
@NullMarked
package org.mechservice.orb;

import org.jspecify.annotations.NullMarked;
