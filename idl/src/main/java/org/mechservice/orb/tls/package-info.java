/**
 * Identities and encryption: keys and certificates of processes, and who calls.
 *
 * <p>{@link org.mechservice.orb.tls.TlsIdentity} is a key with its certificate and the authority
 * that signs all others, read again whenever its files change, and with the certificates that the
 * authority has revoked; {@link org.mechservice.orb.tls.TlsPeers} makes TLS connections with it and
 * remembers the certificates of the peers. {@link org.mechservice.orb.tls.Caller} is the caller of
 * the present thread, with the {@link org.mechservice.orb.tls.Role} that the certificate names;
 * {@code CallerInterceptor} sets it before each call. {@code DetachedSignature} signs JARs, and
 * {@link org.mechservice.orb.tls.TlsProbe} finds out whether an address speaks TLS at all, for the
 * text of a refusal.
 *
 * <p>Depends on {@link org.mechservice.orb.connection}, on JacORB and on the JDK's TLS.
 */
@NullMarked
package org.mechservice.orb.tls;

import org.jspecify.annotations.NullMarked;
