/** MechServer: where clients connect, where hosts register, what administrators ask. */
@NullMarked
package org.mechservice.server;

import org.jspecify.annotations.NullMarked;
