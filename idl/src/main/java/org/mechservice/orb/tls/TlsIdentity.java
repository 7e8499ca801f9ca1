package org.mechservice.orb.tls;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import javax.net.ssl.SSLContext;
import org.jspecify.annotations.Nullable;
import org.mechservice.orb.tls.Credentials.Stamp;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The identity of a process on the network: its key with the certificate, and the authority that
 * signs the certificates of all others. Stored in a folder that {@code mech keys} makes, with
 * {@code identity.p12}, {@code trust.p12} and {@code password}, and {@code revoked.crl} if
 * certificates have been taken back.
 *
 * <p>Who replaces these files replaces the identity of the running process: new connections use
 * what the folder holds then, and existing ones stay. Files that do not fit together, such as in
 * the middle of their replacement, change nothing.
 */
public final class TlsIdentity {
  /** Holds the key and its certificate, PKCS#12. */
  public static final String KEY_FILE = "identity.p12";

  /** Holds the authority's certificate, PKCS#12. */
  public static final String TRUST_FILE = "trust.p12";

  /** Holds the password of both. */
  public static final String PASSWORD_FILE = "password";

  /** Lists the certificates that are not accepted any more, a CRL; need not be there. */
  public static final String REVOKED_FILE = "revoked.crl";

  /** Before its end by less than this, a certificate is to be renewed. */
  public static final Duration RENEWAL = Duration.ofDays(30);

  private static final Logger LOG = LoggerFactory.getLogger(TlsIdentity.class);
  private static final long CHECK_NANOS = 1_000_000_000L;
  private static final Duration BETWEEN_WARNINGS = Duration.ofDays(1);

  private final Path folder;
  private final Map<X509Certificate, PrivateKey> keys = new ConcurrentHashMap<>();
  private volatile Credentials credentials;
  private Stamp stamp;
  private @Nullable Stamp unusable;
  private boolean unusableSaid;
  private long checkedAt = System.nanoTime();
  private Instant nextWarning = Instant.MIN;

  private TlsIdentity(Path folder, Stamp stamp, Credentials credentials) {
    this.folder = folder;
    this.stamp = stamp;
    this.credentials = credentials;
    keys.put(credentials.certificate(), credentials.key());
    warnOfItsEnd(credentials.certificate());
  }

  /**
   * Reads an identity.
   *
   * @throws IllegalArgumentException with code S-150 if the folder holds none that can be used
   */
  public static TlsIdentity load(Path folder) {
    Stamp stamp = Stamp.of(folder);
    try {
      return new TlsIdentity(folder, stamp, Credentials.read(folder));
    } catch (IOException | GeneralSecurityException e) {
      throw new IllegalArgumentException(
          MessageCode.CERTIFICATES_UNUSABLE
              + " the certificates in "
              + folder
              + " cannot be used: "
              + reason(e),
          e);
    }
  }

  private static String reason(Exception e) {
    return e instanceof NoSuchFileException missing
        ? "there is no file " + missing.getFile()
        : String.valueOf(e.getMessage());
  }

  /** Returns what the folder holds now, or has held last that could be used. */
  private Credentials current() {
    synchronized (this) {
      long now = System.nanoTime();
      if (now - checkedAt >= CHECK_NANOS) {
        checkedAt = now;
        readAgain();
        warnOfItsEnd(credentials.certificate());
      }
    }
    return credentials;
  }

  private void readAgain() {
    Stamp found = Stamp.of(folder);
    if (found.equals(stamp) || (unusableSaid && found.equals(unusable))) {
      return;
    }
    try {
      Credentials read = Credentials.read(folder);
      keys.put(read.certificate(), read.key());
      credentials = read;
      stamp = found;
      unusable = null;
      nextWarning = Instant.MIN;
      LOG.info(
          "the certificates in {} were read again; \"{}\" is valid until {}",
          folder,
          this,
          read.certificate().getNotAfter().toInstant());
    } catch (IOException | GeneralSecurityException e) {
      // Somebody may be about to write the other files.
      unusableSaid = found.equals(unusable);
      unusable = found;
      if (unusableSaid) {
        LOG.warn(
            MessageCode.CERTIFICATES_NOT_REPLACED
                + " the changed certificates in {} cannot be used, and the former go on: {}",
            folder,
            reason(e));
      }
    }
  }

  private void warnOfItsEnd(X509Certificate certificate) {
    Instant now = Instant.now();
    Instant end = certificate.getNotAfter().toInstant();
    if (now.isAfter(nextWarning) && now.isAfter(end.minus(RENEWAL))) {
      nextWarning = now.plus(BETWEEN_WARNINGS);
      LOG.warn(
          MessageCode.CERTIFICATE_EXPIRES + " the certificate of \"{}\" in {} {} on {}",
          nameOf(certificate),
          folder,
          end.isBefore(now) ? "has expired" : "expires",
          end.atZone(ZoneOffset.UTC).toLocalDate());
    }
  }

  /** Returns the certificate others see. */
  public X509Certificate certificate() {
    return current().certificate();
  }

  /** Returns when the certificate expires. */
  public Instant expires() {
    return certificate().getNotAfter().toInstant();
  }

  /** Returns what the certificate allows its holder. */
  public Role role() {
    return Role.of(certificate());
  }

  SSLContext context() {
    return current().context();
  }

  /** Returns whether the authority has taken a certificate back. */
  boolean revoked(X509Certificate other) {
    return current().revoked().contains(other);
  }

  /**
   * Returns a detached signature of bytes, made with the identity's key: the one that the caller of
   * the current operation has seen when it connected, which it checks the signature with.
   */
  public byte[] sign(byte[] bytes) {
    Credentials now = current();
    PrivateKey key = Caller.current().seen().map(keys::get).orElse(now.key());
    return DetachedSignature.make(key, bytes);
  }

  @Override
  public String toString() {
    return nameOf(credentials.certificate());
  }

  /** Returns the name in a certificate; empty without one. */
  public static String nameOf(@Nullable X509Certificate certificate) {
    return certificate == null ? "" : CertificateName.part(certificate, "CN");
  }
}
