/**
 * Makes the certificates of a service over TLS: an authority of its own, and identities it signs.
 *
 * <p>{@link org.mechservice.server.keys.KeyFolder} is the way in.
 */
@NullMarked
package org.mechservice.server.keys;

import org.jspecify.annotations.NullMarked;
