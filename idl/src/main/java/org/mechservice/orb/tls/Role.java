package org.mechservice.orb.tls;

import java.security.cert.X509Certificate;
import java.util.Arrays;

/**
 * The role of a caller, which decides its rights. Certificates name it as the organisational unit
 * of their subject.
 */
public enum Role {
  /** Loads models and runs them. */
  CLIENT("client"),
  /** Serves clients, and registers at servers as a host. */
  SERVER("server"),
  /** Sees everything an administrator sees, and changes nothing. */
  MONITOR("monitor"),
  /** May ask and change everything. */
  ADMIN("admin");

  private final String unit;

  Role(String unit) {
    this.unit = unit;
  }

  /** Returns the organisational unit that means it. */
  public String unit() {
    return unit;
  }

  /**
   * Returns whether this role includes another: administrators see what monitors see, and all but
   * monitors may run simulations.
   */
  public boolean includes(Role other) {
    return switch (other) {
      case CLIENT -> this != MONITOR;
      case MONITOR -> this == MONITOR || this == ADMIN;
      case SERVER, ADMIN -> this == other;
    };
  }

  /** Returns the role a certificate names; a certificate that names none is a client's. */
  public static Role of(X509Certificate certificate) {
    String named = CertificateName.part(certificate, "OU");
    return Arrays.stream(values())
        .filter(role -> role.unit.equals(named))
        .findFirst()
        .orElse(CLIENT);
  }
}
