package org.mechservice.orb.tls;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.security.GeneralSecurityException;
import java.security.Key;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.X509Certificate;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManager;
import javax.net.ssl.TrustManagerFactory;
import javax.net.ssl.X509ExtendedTrustManager;

/**
 * The content of the folder of an identity when it was read.
 *
 * @param key own key
 * @param certificate own certificate
 * @param context makes connections with them, to peers whose certificate the authority has signed
 * @param revoked certificates that the authority has taken back
 */
record Credentials(
    PrivateKey key, X509Certificate certificate, SSLContext context, RevocationList revoked) {
  private static final String STORE_TYPE = "PKCS12";
  private static final String ALGORITHM = "PKIX";

  /** Times and sizes of files, by which changes are noticed; a missing file has no size. */
  record Stamp(List<FileTime> times, List<Long> sizes) {
    static Stamp of(Path folder) {
      List<FileTime> times = new ArrayList<>();
      List<Long> sizes = new ArrayList<>();
      for (String name :
          List.of(
              TlsIdentity.PASSWORD_FILE,
              TlsIdentity.KEY_FILE,
              TlsIdentity.TRUST_FILE,
              TlsIdentity.REVOKED_FILE)) {
        try {
          times.add(Files.getLastModifiedTime(folder.resolve(name)));
          sizes.add(Files.size(folder.resolve(name)));
        } catch (IOException e) {
          sizes.add(-1L);
        }
      }
      return new Stamp(times, sizes);
    }
  }

  /**
   * Reads a folder.
   *
   * @throws GeneralSecurityException if what it holds does not fit together or is not valid now
   */
  static Credentials read(Path folder) throws IOException, GeneralSecurityException {
    char[] password =
        Files.readString(folder.resolve(TlsIdentity.PASSWORD_FILE), StandardCharsets.US_ASCII)
            .strip()
            .toCharArray();
    KeyStore keys = store(folder.resolve(TlsIdentity.KEY_FILE), password);
    KeyStore trusted = store(folder.resolve(TlsIdentity.TRUST_FILE), password);
    String alias = keys.aliases().hasMoreElements() ? keys.aliases().nextElement() : "";
    Key key = keys.getKey(alias, password);
    if (!(key instanceof PrivateKey own)
        || !(keys.getCertificate(alias) instanceof X509Certificate certificate)) {
      throw new GeneralSecurityException(TlsIdentity.KEY_FILE + " holds no key with a certificate");
    }
    certificate.checkValidity();
    RevocationList revoked = RevocationList.read(folder.resolve(TlsIdentity.REVOKED_FILE), trusted);
    KeyManagerFactory ownKeys = KeyManagerFactory.getInstance(ALGORITHM);
    ownKeys.init(keys, password);
    TrustManagerFactory others = TrustManagerFactory.getInstance(ALGORITHM);
    others.init(trusted);
    SSLContext context = SSLContext.getInstance("TLS");
    TrustManager[] checked =
        Stream.of(others.getTrustManagers())
            .map(trust -> new RevocationCheck((X509ExtendedTrustManager) trust, revoked))
            .toArray(TrustManager[]::new);
    context.init(ownKeys.getKeyManagers(), checked, null);
    return new Credentials(own, certificate, context, revoked);
  }

  private static KeyStore store(Path file, char[] password)
      throws IOException, GeneralSecurityException {
    KeyStore store = KeyStore.getInstance(STORE_TYPE);
    try (InputStream in = Files.newInputStream(file)) {
      store.load(in, password);
    }
    return store;
  }
}
