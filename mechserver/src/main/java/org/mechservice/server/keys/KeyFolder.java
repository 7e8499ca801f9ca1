package org.mechservice.server.keys;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateFactory;
import java.security.cert.CertificateParsingException;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.mechservice.orb.tls.Role;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.FileErrors;

/**
 * The folder of a service's certificates.
 *
 * <pre>
 * keys/
 *   ca/        the authority; its key signs all others and is needed to make more, nowhere else
 *   server/    a folder per identity, which is all that a process needs: --tls keys/server
 *   client/
 *   monitor/
 *   admin/
 * </pre>
 *
 * Existing identities are kept unless they are renewed, so that more can be made later.
 * Certificates that have been taken back stand in {@code revoked.crl}, here and in the folder of
 * each identity.
 */
public final class KeyFolder {
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9._:-]{1,64}");

  private final Path folder;
  private final Authority authority;
  private final List<Path> made = new ArrayList<>();
  private Duration life = Authority.LIFE;

  private KeyFolder(Path folder, Authority authority) {
    this.folder = folder;
    this.authority = authority;
  }

  /**
   * Opens a folder, making it and its authority if need be.
   *
   * @throws IllegalArgumentException with code S-155 if it cannot be used
   */
  public static KeyFolder open(Path folder) {
    try {
      Path ca = folder.resolve("ca");
      if (Files.exists(ca)) {
        return new KeyFolder(folder, Authority.load(ca));
      }
      Authority authority = Authority.make();
      authority.save(ca);
      return new KeyFolder(folder, authority);
    } catch (IOException e) {
      throw unusable(folder.toString(), e);
    }
  }

  /** Sets how long the certificates are valid that are made from now on. */
  public void validFor(Duration duration) {
    life = duration;
  }

  private static IllegalArgumentException unusable(String what, IOException cause) {
    return new IllegalArgumentException(
        MessageCode.KEYS_NOT_MADE
            + " no keys can be made in "
            + what
            + ": "
            + FileErrors.reason(cause),
        cause);
  }

  /**
   * Makes an identity for a server or host, in a folder with the first of its names.
   *
   * @param names names and numeric addresses at which it is reached; what a name resolves to is
   *     added
   * @throws IllegalArgumentException with code S-155 if a name cannot be used
   */
  public void server(List<String> names) {
    make(names.get(0), Role.SERVER, names.get(0), withAddresses(names));
  }

  /** Makes the identity of a server that only this machine reaches, in folder {@code server}. */
  public void localServer() {
    make("server", Role.SERVER, "localhost", List.of("localhost", "127.0.0.1", "::1"));
  }

  /**
   * Makes an identity for a user.
   *
   * @param role of the owner
   * @throws IllegalArgumentException with code S-155 if the name cannot be used
   */
  public void user(String name, Role role) {
    make(name, role, name, List.of());
  }

  private void make(String child, Role role, String name, List<String> addresses) {
    if (!NAME.matcher(child).matches() || child.startsWith(".") || child.equals("ca")) {
      throw new IllegalArgumentException(
          MessageCode.KEYS_NOT_MADE
              + " no keys can be made for \""
              + child
              + "\": a name has 1 to 64 letters, digits, points, hyphens, colons, underscores,"
              + " and is not \"ca\"");
    }
    Path place = folder.resolve(child.replace(':', '-'));
    if (Files.exists(place)) {
      return;
    }
    try {
      authority.identity(name, role, addresses, life).save(place, authority.certificate());
      if (Files.exists(revokedFile())) {
        Files.copy(revokedFile(), place.resolve(TlsIdentity.REVOKED_FILE));
      }
      made.add(place);
    } catch (IOException e) {
      throw unusable(place.toString(), e);
    }
  }

  /**
   * Makes a new key and certificate for an identity that there is, with the same name, role and
   * addresses. The former certificate stays valid until its end.
   *
   * @param child folder of the identity
   * @throws IllegalArgumentException with code S-155 if there is none
   */
  public void renew(String child) {
    Path place = existing(child);
    try {
      X509Certificate former = StoredKey.load(place).certificate();
      List<String> addresses = new ArrayList<>();
      Collection<List<?>> names = former.getSubjectAlternativeNames();
      if (names != null) {
        names.forEach(name -> addresses.add(String.valueOf(name.get(1))));
      }
      authority
          .identity(TlsIdentity.nameOf(former), Role.of(former), addresses, life)
          .replace(place, authority.certificate());
      made.add(place);
    } catch (IOException e) {
      throw unusable(place.toString(), e);
    } catch (CertificateParsingException e) {
      throw unusable(place.toString(), new IOException(e));
    }
  }

  /**
   * Revokes the certificate of an identity: processes with the new {@code revoked.crl} accept it no
   * longer.
   *
   * @param child folder of the identity
   * @return the file
   * @throws IllegalArgumentException with code S-155 if there is none
   */
  public Path revoke(String child) {
    Path place = existing(child);
    try {
      X509CRL list = authority.withRevoked(revokedBefore(), StoredKey.load(place).certificate());
      byte[] text = StoredKey.pem("X509 CRL", list.getEncoded());
      Files.write(revokedFile(), text);
      try (DirectoryStream<Path> children = Files.newDirectoryStream(folder, Files::isDirectory)) {
        for (Path identity : children) {
          if (!identity.endsWith("ca")) {
            Files.write(identity.resolve(TlsIdentity.REVOKED_FILE), text);
          }
        }
      }
      return revokedFile();
    } catch (IOException e) {
      throw unusable(place.toString(), e);
    } catch (GeneralSecurityException e) {
      throw unusable(place.toString(), new IOException(e));
    }
  }

  private Optional<X509CRL> revokedBefore() throws IOException, GeneralSecurityException {
    if (!Files.exists(revokedFile())) {
      return Optional.empty();
    }
    try (InputStream in = Files.newInputStream(revokedFile())) {
      return Optional.of((X509CRL) CertificateFactory.getInstance("X.509").generateCRL(in));
    }
  }

  private Path revokedFile() {
    return folder.resolve(TlsIdentity.REVOKED_FILE);
  }

  private Path existing(String child) {
    Path place = folder.resolve(child.replace(':', '-'));
    if (!NAME.matcher(child).matches()
        || child.equals("ca")
        || !Files.exists(place.resolve(TlsIdentity.KEY_FILE))) {
      throw new IllegalArgumentException(
          MessageCode.KEYS_NOT_MADE + " there is no identity \"" + child + "\" in " + folder);
    }
    return place;
  }

  /** A name that is not known here may be known where it is used. */
  private static List<String> withAddresses(List<String> names) {
    Set<String> all = new LinkedHashSet<>(names);
    for (String name : names) {
      try {
        for (InetAddress address : InetAddress.getAllByName(name)) {
          all.add(address.getHostAddress());
        }
      } catch (UnknownHostException e) {
        all.add(name);
      }
    }
    return List.copyOf(all);
  }

  /** Returns the folders of the identities made since this was opened. */
  public List<Path> made() {
    return List.copyOf(made);
  }
}
