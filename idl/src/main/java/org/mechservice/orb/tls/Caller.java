package org.mechservice.orb.tls;

import java.security.cert.X509Certificate;
import java.util.Optional;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The caller of the operation that this thread executes.
 *
 * @param certificate of the caller; empty: the connection is not encrypted, so the caller is on
 *     this machine
 * @param seen certificate of this process that the caller has seen when it connected
 * @param address of the other end of the connection, {@code address:port}; empty: this process
 */
public record Caller(
    Optional<X509Certificate> certificate, Optional<X509Certificate> seen, String address) {
  private static final Caller THIS_MACHINE = new Caller(Optional.empty(), Optional.empty(), "");
  private static final ThreadLocal<Caller> CURRENT = ThreadLocal.withInitial(() -> THIS_MACHINE);

  /** Returns the caller of the operation that this thread executes. */
  public static Caller current() {
    return CURRENT.get();
  }

  static void isNow(Caller caller) {
    CURRENT.set(caller);
  }

  static Caller inThisProcess() {
    return THIS_MACHINE;
  }

  /**
   * Returns the caller's name.
   *
   * @param claimed the name that the caller gives; used only without a certificate
   */
  public String name(String claimed) {
    return certificate.map(TlsIdentity::nameOf).orElse(claimed);
  }

  /** Returns the role in the certificate; {@code local} without a certificate. */
  public String roleName() {
    return certificate.map(shown -> Role.of(shown).unit()).orElse("local");
  }

  /** Returns whether the caller may act in a role. A caller on this machine may do everything. */
  public boolean may(Role role) {
    return certificate.map(shown -> Role.of(shown).includes(role)).orElse(true);
  }

  /**
   * Returns whose objects the caller may use: the name in its certificate; empty, anybody's: an
   * administrator, or a caller without a certificate, for whom there are no owners.
   */
  public Optional<String> confinedTo() {
    return certificate.filter(shown -> !may(Role.ADMIN)).map(TlsIdentity::nameOf);
  }

  /**
   * Makes sure that the caller may use what belongs to a user.
   *
   * @param owner the user's name
   * @throws NotAuthorized with code S-167 if it may not
   */
  public void requireOwner(String owner) throws NotAuthorized {
    if (confinedTo().filter(name -> !name.equals(owner)).isPresent()) {
      throw notTheOwner(name(""));
    }
  }

  /** Returns the refusal of a caller who does not own what it wants to use. */
  public static NotAuthorized notTheOwner(String caller) {
    return new NotAuthorized(
        MessageCode.NOT_THE_OWNER.code(),
        "this belongs to another user than \""
            + caller
            + "\"; use the identity that opened the session, or an administrator's");
  }

  /**
   * Makes sure that the caller may act in a role.
   *
   * @throws NotAuthorized with code S-153 if the caller may not
   */
  public void require(Role role) throws NotAuthorized {
    if (!may(role)) {
      throw new NotAuthorized(
          MessageCode.CERTIFICATE_NOT_ALLOWED.code(),
          "the certificate of \""
              + name("")
              + "\" is no "
              + role.unit()
              + "'s; use one that \"mech keys\" made for the "
              + role.unit()
              + " role");
    }
  }
}
