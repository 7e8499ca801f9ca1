package org.mechservice.orb.tls;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.PublicKey;
import java.security.Signature;
import java.security.SignatureException;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;

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

  /**
   * Reads the certificate of a machine that signs.
   *
   * @param file its {@code identity.crt}
   * @throws IOException if it cannot be read
   * @throws CertificateException if it is no certificate
   */
  public static X509Certificate signer(Path file) throws IOException, CertificateException {
    try (InputStream in = Files.newInputStream(file)) {
      return (X509Certificate) CertificateFactory.getInstance("X.509").generateCertificate(in);
    }
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
