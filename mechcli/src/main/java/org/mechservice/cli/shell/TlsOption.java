package org.mechservice.cli.shell;

import java.nio.file.Path;
import java.util.Optional;
import org.mechservice.orb.tls.TlsIdentity;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** The certificate of this process, for TLS. */
public final class TlsOption {
  @Option(
      names = "--tls",
      paramLabel = "FOLDER",
      scope = ScopeType.INHERIT,
      defaultValue = "${env:MECH_TLS}",
      description =
          "Encrypt connections, with the certificates of this folder (see mech keys); MECH_TLS"
              + " names it too.")
  private Optional<Path> folder = Optional.empty();

  /**
   * Returns the identity; empty if connections are not to be encrypted.
   *
   * @throws IllegalArgumentException with code S-150 if the folder holds none that can be used
   */
  public Optional<TlsIdentity> identity() {
    return folder.map(TlsIdentity::load);
  }
}
