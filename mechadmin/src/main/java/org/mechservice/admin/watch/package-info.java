/** The console as a full screen of a terminal, like top. */
@NullMarked
package org.mechservice.admin.watch;

import org.jspecify.annotations.NullMarked;
