package org.mechservice.orb.tls;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.CRL;
import java.security.cert.CertificateFactory;
import java.security.cert.X509CRL;
import java.security.cert.X509CRLEntry;
import java.security.cert.X509Certificate;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.Set;
import javax.security.auth.x500.X500Principal;
import org.jspecify.annotations.Nullable;

/**
 * The certificates that authorities have revoked, RFC 5280: one or several lists in a file, PEM or
 * DER. A list goes on to count after the time of its next update, since what is revoked stays
 * revoked.
 */
final class RevocationList {
  /** A certificate by its issuer and number. */
  private record Revoked(X500Principal issuer, BigInteger serial) {}

  /** Nothing is revoked. */
  static final RevocationList EMPTY = new RevocationList(Set.of());

  private final Set<Revoked> revoked;

  private RevocationList(Set<Revoked> revoked) {
    this.revoked = revoked;
  }

  /**
   * Reads a file; there is none if nothing has been revoked.
   *
   * @param trusted authorities whose lists count
   * @throws GeneralSecurityException if it is no list, or not signed by one of the authorities
   */
  static RevocationList read(Path file, KeyStore trusted)
      throws IOException, GeneralSecurityException {
    if (!Files.exists(file)) {
      return EMPTY;
    }
    Set<Revoked> revoked = new HashSet<>();
    Collection<? extends CRL> lists =
        CertificateFactory.getInstance("X.509")
            .generateCRLs(new ByteArrayInputStream(Files.readAllBytes(file)));
    if (lists.isEmpty()) {
      throw new GeneralSecurityException(file.getFileName() + " holds no revocation list");
    }
    for (CRL list : lists) {
      X509CRL checked = checked((X509CRL) list, trusted, file);
      Set<? extends X509CRLEntry> entries = checked.getRevokedCertificates();
      if (entries != null) {
        entries.forEach(
            entry ->
                revoked.add(
                    new Revoked(checked.getIssuerX500Principal(), entry.getSerialNumber())));
      }
    }
    return new RevocationList(revoked);
  }

  private static X509CRL checked(X509CRL list, KeyStore trusted, Path file)
      throws GeneralSecurityException {
    for (String alias : Collections.list(trusted.aliases())) {
      if (trusted.getCertificate(alias) instanceof X509Certificate authority
          && authority.getSubjectX500Principal().equals(list.getIssuerX500Principal())) {
        try {
          list.verify(authority.getPublicKey());
          return list;
        } catch (GeneralSecurityException e) {
          throw otherAuthority(file, e);
        }
      }
    }
    throw otherAuthority(file, null);
  }

  private static GeneralSecurityException otherAuthority(
      Path file, @Nullable GeneralSecurityException cause) {
    return new GeneralSecurityException(
        file.getFileName() + " is not signed by the authority in " + TlsIdentity.TRUST_FILE, cause);
  }

  /** Returns whether a certificate has been taken back. */
  boolean contains(X509Certificate certificate) {
    return revoked.contains(
        new Revoked(certificate.getIssuerX500Principal(), certificate.getSerialNumber()));
  }
}
