package org.mechservice.orb.tls;

import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.PublicKey;
import java.security.Signature;
import java.security.SignatureException;

/**
 * Signatures that travel beside what they sign. They are plain ones over SHA-256, so that other
 * tools can check them too, such as {@code openssl dgst -sha256 -verify}.
 */
public final class DetachedSignature {
  private DetachedSignature() {}

  private static Signature algorithm(String keyAlgorithm) throws GeneralSecurityException {
    return Signature.getInstance(
        keyAlgorithm.equals("EC") ? "SHA256withECDSA" : "SHA256with" + keyAlgorithm);
  }

  /** Returns the signature of bytes. */
  static byte[] make(PrivateKey key, byte[] bytes) {
    try {
      Signature signature = algorithm(key.getAlgorithm());
      signature.initSign(key);
      signature.update(bytes);
      return signature.sign();
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("the key cannot sign", e);
    }
  }

  /** Returns whether a signature of bytes was made with the private counterpart of a key. */
  public static boolean fits(PublicKey key, byte[] bytes, byte[] signed) {
    try {
      Signature signature = algorithm(key.getAlgorithm());
      signature.initVerify(key);
      signature.update(bytes);
      return signature.verify(signed);
    } catch (SignatureException e) {
      return false; // it is not even one
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("the key cannot check signatures", e);
    }
  }
}
