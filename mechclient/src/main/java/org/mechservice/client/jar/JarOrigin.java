package org.mechservice.client.jar;

import java.security.PublicKey;
import java.util.Optional;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.orb.tls.DetachedSignature;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Makes sure that a JAR comes from the host a client is connected with. Over TLS the host has shown
 * its certificate, and what it sends is signed with the same key.
 *
 * @param encrypted whether the connection is encrypted; if not, nobody has a key, and the hash of a
 *     JAR is all there is
 * @param key the host's; empty: it has shown none
 */
public record JarOrigin(boolean encrypted, Optional<PublicKey> key) {
  /**
   * Returns a JAR whose signature fits.
   *
   * @param what names it in the message
   * @throws JarRefusedException with code S-154 if it does not
   */
  byte[] verified(byte[] jar, byte[] signature, String what) {
    if (encrypted && !key.map(own -> DetachedSignature.fits(own, jar, signature)).orElse(false)) {
      throw new JarRefusedException(
          MessageCode.JAR_SIGNATURE.code(),
          what
              + (signature.length == 0
                  ? " is not signed"
                  : " is not signed with the key of the server it came from")
              + "; it was not loaded");
    }
    return jar;
  }
}
