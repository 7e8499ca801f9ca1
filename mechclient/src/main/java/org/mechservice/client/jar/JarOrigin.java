package org.mechservice.client.jar;

import java.security.PublicKey;
import java.util.Optional;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.orb.tls.DetachedSignature;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Checks that a JAR comes from the host of the connection. Over TLS the host has a certificate, and
 * its JARs are signed with the same key.
 *
 * @param encrypted whether the connection is encrypted; otherwise only the hash of a JAR is checked
 * @param key public key of the host; empty if it has shown none
 */
public record JarOrigin(boolean encrypted, Optional<PublicKey> key) {
  /**
   * Returns a JAR if its signature is valid.
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
