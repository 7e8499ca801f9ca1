/** What goes on, followed as it happens, for the faces that stay open. */
@NullMarked
package org.mechservice.admin.live;

import org.jspecify.annotations.NullMarked;
