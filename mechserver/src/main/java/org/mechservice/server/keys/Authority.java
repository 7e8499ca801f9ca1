package org.mechservice.server.keys;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.PrivateKey;
import java.security.PublicKey;
import java.security.SecureRandom;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.security.spec.ECGenParameterSpec;
import java.time.Duration;
import java.time.Instant;
import java.util.Date;
import java.util.List;
import java.util.Optional;
import org.bouncycastle.asn1.ASN1Encodable;
import org.bouncycastle.asn1.ASN1ObjectIdentifier;
import org.bouncycastle.asn1.x500.X500Name;
import org.bouncycastle.asn1.x500.X500NameBuilder;
import org.bouncycastle.asn1.x500.style.BCStyle;
import org.bouncycastle.asn1.x509.BasicConstraints;
import org.bouncycastle.asn1.x509.CRLReason;
import org.bouncycastle.asn1.x509.ExtendedKeyUsage;
import org.bouncycastle.asn1.x509.Extension;
import org.bouncycastle.asn1.x509.GeneralName;
import org.bouncycastle.asn1.x509.GeneralNames;
import org.bouncycastle.asn1.x509.KeyPurposeId;
import org.bouncycastle.asn1.x509.KeyUsage;
import org.bouncycastle.cert.X509v2CRLBuilder;
import org.bouncycastle.cert.X509v3CertificateBuilder;
import org.bouncycastle.cert.jcajce.JcaX509CRLConverter;
import org.bouncycastle.cert.jcajce.JcaX509CertificateConverter;
import org.bouncycastle.cert.jcajce.JcaX509ExtensionUtils;
import org.bouncycastle.cert.jcajce.JcaX509v3CertificateBuilder;
import org.bouncycastle.operator.OperatorCreationException;
import org.bouncycastle.operator.jcajce.JcaContentSignerBuilder;
import org.bouncycastle.util.IPAddress;
import org.mechservice.orb.tls.Role;

/** A small certificate authority, RFC 5280, with elliptic keys over P-256. */
final class Authority {
  private static final Duration OWN_LIFE = Duration.ofDays(3650);

  /** Default validity of certificates. */
  static final Duration LIFE = Duration.ofDays(1095);

  /** Clocks of two machines may differ. */
  private static final Duration CLOCK_SKEW = Duration.ofHours(1);

  private static final String SIGNATURE = "SHA256withECDSA";
  private static final int SERIAL_BITS = 127;
  private static final SecureRandom RANDOM = new SecureRandom();

  private final StoredKey key;

  private Authority(StoredKey key) {
    this.key = key;
  }

  /** Makes a new authority. */
  static Authority make() throws IOException {
    KeyPair pair = newKey();
    X500Name name = name("MechService authority", "authority");
    Extensions extensions =
        new Extensions()
            .with(Extension.basicConstraints, true, new BasicConstraints(0))
            .with(Extension.keyUsage, true, new KeyUsage(KeyUsage.keyCertSign | KeyUsage.cRLSign));
    X509Certificate own =
        certificate(name, name, pair.getPublic(), pair.getPrivate(), OWN_LIFE, extensions);
    return new Authority(new StoredKey(pair.getPrivate(), List.of(own)));
  }

  /** Reads an authority that was saved. */
  static Authority load(Path folder) throws IOException {
    return new Authority(StoredKey.load(folder));
  }

  void save(Path folder) throws IOException {
    key.save(folder, certificate());
  }

  X509Certificate certificate() {
    return key.chain().get(0);
  }

  /**
   * Makes an identity.
   *
   * @param addresses names and numeric addresses at which a server is reached
   * @param life how long its certificate is valid
   */
  StoredKey identity(String name, Role role, List<String> addresses, Duration life)
      throws IOException {
    KeyPair pair = newKey();
    boolean serves = role == Role.SERVER;
    KeyPurposeId[] purposes =
        serves
            ? new KeyPurposeId[] {KeyPurposeId.id_kp_serverAuth, KeyPurposeId.id_kp_clientAuth}
            : new KeyPurposeId[] {KeyPurposeId.id_kp_clientAuth};
    Extensions extensions =
        new Extensions()
            .with(Extension.basicConstraints, true, new BasicConstraints(false))
            .with(Extension.keyUsage, true, new KeyUsage(KeyUsage.digitalSignature))
            .with(Extension.extendedKeyUsage, false, new ExtendedKeyUsage(purposes));
    if (!addresses.isEmpty()) {
      extensions.with(Extension.subjectAlternativeName, false, alternatives(addresses));
    }
    X509Certificate own =
        certificate(
            name("MechService authority", "authority"),
            name(name, role.unit()),
            pair.getPublic(),
            key.key(),
            life,
            extensions);
    return new StoredKey(pair.getPrivate(), List.of(own, certificate()));
  }

  /**
   * Returns a list of certificates that are not accepted any more, RFC 5280.
   *
   * @param before earlier list, whose certificates stay on it; empty: none
   * @param revoked the certificate to add
   */
  X509CRL withRevoked(Optional<X509CRL> before, X509Certificate revoked) throws IOException {
    Date now = Date.from(Instant.now());
    X509v2CRLBuilder builder =
        new X509v2CRLBuilder(name("MechService authority", "authority"), now);
    builder.setNextUpdate(certificate().getNotAfter());
    before
        .map(X509CRL::getRevokedCertificates)
        .ifPresent(
            entries ->
                entries.forEach(
                    entry ->
                        builder.addCRLEntry(
                            entry.getSerialNumber(),
                            entry.getRevocationDate(),
                            CRLReason.unspecified)));
    builder.addCRLEntry(revoked.getSerialNumber(), now, CRLReason.unspecified);
    try {
      return new JcaX509CRLConverter()
          .getCRL(builder.build(new JcaContentSignerBuilder(SIGNATURE).build(key.key())));
    } catch (GeneralSecurityException | OperatorCreationException e) {
      throw new IOException(e);
    }
  }

  private static KeyPair newKey() throws IOException {
    try {
      KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
      generator.initialize(new ECGenParameterSpec("secp256r1"), RANDOM);
      return generator.generateKeyPair();
    } catch (GeneralSecurityException e) {
      throw new IOException(e);
    }
  }

  private static X500Name name(String commonName, String unit) {
    return new X500NameBuilder(BCStyle.INSTANCE)
        .addRDN(BCStyle.O, "MechService")
        .addRDN(BCStyle.OU, unit)
        .addRDN(BCStyle.CN, commonName)
        .build();
  }

  private static GeneralNames alternatives(List<String> addresses) {
    return new GeneralNames(
        addresses.stream()
            .map(
                address ->
                    new GeneralName(
                        IPAddress.isValid(address) ? GeneralName.iPAddress : GeneralName.dNSName,
                        address))
            .toArray(GeneralName[]::new));
  }

  private static X509Certificate certificate(
      X500Name issuer,
      X500Name subject,
      PublicKey subjectKey,
      PrivateKey issuerKey,
      Duration life,
      Extensions extensions)
      throws IOException {
    Instant now = Instant.now();
    X509v3CertificateBuilder builder =
        new JcaX509v3CertificateBuilder(
            issuer,
            new BigInteger(SERIAL_BITS, RANDOM),
            Date.from(now.minus(CLOCK_SKEW)),
            Date.from(now.plus(life)),
            subject,
            subjectKey);
    try {
      extensions.addTo(builder, subjectKey);
      return new JcaX509CertificateConverter()
          .getCertificate(builder.build(new JcaContentSignerBuilder(SIGNATURE).build(issuerKey)));
    } catch (GeneralSecurityException | OperatorCreationException e) {
      throw new IOException(e);
    }
  }

  /** The extensions of a certificate. */
  private static final class Extensions {
    private record Entry(ASN1ObjectIdentifier type, boolean critical, ASN1Encodable value) {}

    private final java.util.ArrayList<Entry> entries = new java.util.ArrayList<>();

    Extensions with(ASN1ObjectIdentifier type, boolean critical, ASN1Encodable value) {
      entries.add(new Entry(type, critical, value));
      return this;
    }

    void addTo(X509v3CertificateBuilder builder, PublicKey subjectKey)
        throws IOException, GeneralSecurityException {
      for (Entry entry : entries) {
        builder.addExtension(entry.type(), entry.critical(), entry.value());
      }
      builder.addExtension(
          Extension.subjectKeyIdentifier,
          false,
          new JcaX509ExtensionUtils().createSubjectKeyIdentifier(subjectKey));
    }
  }
}
