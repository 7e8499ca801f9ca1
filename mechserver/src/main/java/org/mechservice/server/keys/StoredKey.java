package org.mechservice.server.keys;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.security.GeneralSecurityException;
import java.security.Key;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.SecureRandom;
import java.security.cert.Certificate;
import java.security.cert.X509Certificate;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.solver.text.OwnerOnly;

/**
 * A key with its certificate, and its folder on disk, which only its owner may read.
 *
 * @param chain the certificate, and those of its signers
 */
record StoredKey(PrivateKey key, List<X509Certificate> chain) {
  private static final String STORE_TYPE = "PKCS12";
  private static final String ALIAS = "mechservice";
  private static final String CERTIFICATE_FILE = "identity.crt";
  private static final int PASSWORD_BYTES = 24;
  private static final int PEM_LINE = 64;

  static StoredKey load(Path folder) throws IOException {
    char[] password =
        Files.readString(folder.resolve(TlsIdentity.PASSWORD_FILE)).strip().toCharArray();
    try (InputStream in = Files.newInputStream(folder.resolve(TlsIdentity.KEY_FILE))) {
      KeyStore store = KeyStore.getInstance(STORE_TYPE);
      store.load(in, password);
      Key key = store.getKey(ALIAS, password);
      if (key instanceof PrivateKey own) {
        return new StoredKey(
            own,
            Arrays.stream(store.getCertificateChain(ALIAS))
                .map(X509Certificate.class::cast)
                .toList());
      }
      throw new IOException(folder.resolve(TlsIdentity.KEY_FILE) + " holds no key");
    } catch (GeneralSecurityException e) {
      throw new IOException(e);
    }
  }

  /**
   * Writes key, certificate and trusted certificates.
   *
   * @param trusted the authority
   */
  void save(Path folder, X509Certificate trusted) throws IOException {
    Files.createDirectories(folder.toAbsolutePath().getParent());
    Files.createDirectory(folder, OwnerOnly.folder());
    byte[] random = new byte[PASSWORD_BYTES];
    new SecureRandom().nextBytes(random);
    String password = Base64.getUrlEncoder().withoutPadding().encodeToString(random);
    try {
      KeyStore keys = empty();
      keys.setKeyEntry(ALIAS, key, password.toCharArray(), chain.toArray(Certificate[]::new));
      KeyStore trust = empty();
      trust.setCertificateEntry("authority", trusted);
      write(
          folder.resolve(TlsIdentity.PASSWORD_FILE),
          (password + "\n").getBytes(StandardCharsets.US_ASCII));
      write(folder.resolve(TlsIdentity.KEY_FILE), bytes(keys, password));
      write(folder.resolve(TlsIdentity.TRUST_FILE), bytes(trust, password));
      write(folder.resolve(CERTIFICATE_FILE), pem("CERTIFICATE", certificate().getEncoded()));
    } catch (GeneralSecurityException e) {
      throw new IOException(e);
    }
  }

  /** Writes them in the place of those that the folder holds. */
  void replace(Path folder, X509Certificate trusted) throws IOException {
    Path fresh = folder.resolveSibling(".new-" + folder.getFileName());
    save(fresh, trusted);
    for (String file :
        List.of(
            TlsIdentity.PASSWORD_FILE,
            TlsIdentity.TRUST_FILE,
            CERTIFICATE_FILE,
            TlsIdentity.KEY_FILE)) {
      Files.move(fresh.resolve(file), folder.resolve(file), StandardCopyOption.REPLACE_EXISTING);
    }
    Files.delete(fresh);
  }

  /** Returns the certificate. */
  X509Certificate certificate() {
    return chain.get(0);
  }

  private static KeyStore empty() throws IOException, GeneralSecurityException {
    KeyStore store = KeyStore.getInstance(STORE_TYPE);
    store.load(null, null);
    return store;
  }

  private static byte[] bytes(KeyStore store, String password)
      throws IOException, GeneralSecurityException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    store.store(out, password.toCharArray());
    return out.toByteArray();
  }

  /** Returns the text form of something encoded, RFC 7468. */
  static byte[] pem(String what, byte[] encoded) {
    String text = Base64.getMimeEncoder(PEM_LINE, new byte[] {'\n'}).encodeToString(encoded);
    return ("-----BEGIN " + what + "-----\n" + text + "\n-----END " + what + "-----\n")
        .getBytes(StandardCharsets.US_ASCII);
  }

  private static void write(Path file, byte[] content) throws IOException {
    Files.createFile(file, OwnerOnly.file());
    Files.write(file, content, StandardOpenOption.WRITE);
  }
}
