/**
 * Makes the certificates of a service over TLS, behind {@code mech keys}.
 *
 * <p>{@link org.mechservice.server.keys.KeyFolder} is the entry: in a folder it makes an {@code
 * Authority} of its own and identities that the authority signs, each with a {@link
 * org.mechservice.orb.tls.Role} in its certificate. {@code StoredKey} reads and writes a key with
 * its certificate as PKCS#12, readable by its owner only. Existing files are never overwritten, so
 * that identities can be added later.
 *
 * <p>Depends on Bouncy Castle for certificates (RFC 5280) and on the ORB's identities.
 */
@NullMarked
package org.mechservice.server.keys;

import org.jspecify.annotations.NullMarked;
