package org.mechservice.orb.tls;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.Key;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.X509Certificate;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The identity of a process on the network: its key with the certificate, and the authority that
 * signs the certificates of all others. Stored in a folder that {@code mech keys} makes, with
 * {@code identity.p12}, {@code trust.p12} and {@code password}.
 */
public final class TlsIdentity {
  /** Holds the key and its certificate, PKCS#12. */
  public static final String KEY_FILE = "identity.p12";

  /** Holds the authority's certificate, PKCS#12. */
  public static final String TRUST_FILE = "trust.p12";

  /** Holds the password of both. */
  public static final String PASSWORD_FILE = "password";

  private static final String STORE_TYPE = "PKCS12";
  private static final String ALGORITHM = "PKIX";

  private final PrivateKey key;
  private final X509Certificate certificate;
  private final SSLContext context;

  private TlsIdentity(PrivateKey key, X509Certificate certificate, SSLContext context) {
    this.key = key;
    this.certificate = certificate;
    this.context = context;
  }

  /**
   * Reads an identity.
   *
   * @throws IllegalArgumentException with code S-150 if the folder holds none that can be used
   */
  public static TlsIdentity load(Path folder) {
    try {
      char[] password =
          Files.readString(folder.resolve(PASSWORD_FILE), StandardCharsets.US_ASCII)
              .strip()
              .toCharArray();
      return of(
          store(folder.resolve(KEY_FILE), password),
          store(folder.resolve(TRUST_FILE), password),
          password);
    } catch (NoSuchFileException e) {
      throw unusable(folder, "there is no file " + e.getFile(), e);
    } catch (IOException | GeneralSecurityException e) {
      throw unusable(folder, String.valueOf(e.getMessage()), e);
    }
  }

  private static IllegalArgumentException unusable(Path folder, String why, Exception cause) {
    return new IllegalArgumentException(
        MessageCode.CERTIFICATES_UNUSABLE
            + " the certificates in "
            + folder
            + " cannot be used: "
            + why,
        cause);
  }

  private static KeyStore store(Path file, char[] password)
      throws IOException, GeneralSecurityException {
    KeyStore store = KeyStore.getInstance(STORE_TYPE);
    try (InputStream in = Files.newInputStream(file)) {
      store.load(in, password);
    }
    return store;
  }

  private static TlsIdentity of(KeyStore keys, KeyStore trusted, char[] password)
      throws GeneralSecurityException {
    String alias = keys.aliases().hasMoreElements() ? keys.aliases().nextElement() : "";
    Key key = keys.getKey(alias, password);
    if (!(key instanceof PrivateKey own)
        || !(keys.getCertificate(alias) instanceof X509Certificate certificate)) {
      throw new GeneralSecurityException(KEY_FILE + " holds no key with a certificate");
    }
    certificate.checkValidity();
    KeyManagerFactory ownKeys = KeyManagerFactory.getInstance(ALGORITHM);
    ownKeys.init(keys, password);
    TrustManagerFactory others = TrustManagerFactory.getInstance(ALGORITHM);
    others.init(trusted);
    SSLContext context = SSLContext.getInstance("TLS");
    context.init(ownKeys.getKeyManagers(), others.getTrustManagers(), null);
    return new TlsIdentity(own, certificate, context);
  }

  /** Returns the certificate others see. */
  public X509Certificate certificate() {
    return certificate;
  }

  /** Returns what the certificate allows its holder. */
  public Role role() {
    return Role.of(certificate);
  }

  SSLContext context() {
    return context;
  }

  /** Returns a detached signature of bytes, made with the identity's key. */
  public byte[] sign(byte[] bytes) {
    return DetachedSignature.make(key, bytes);
  }

  @Override
  public String toString() {
    return nameOf(certificate);
  }

  static String nameOf(@Nullable X509Certificate certificate) {
    return certificate == null ? "" : CertificateName.part(certificate, "CN");
  }
}
