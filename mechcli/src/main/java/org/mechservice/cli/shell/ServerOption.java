package org.mechservice.cli.shell;

import java.io.IOException;
import java.nio.file.Path;
import java.security.PublicKey;
import java.security.cert.CertificateException;
import java.util.List;
import java.util.Optional;
import org.mechservice.orb.tls.DetachedSignature;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The service that a command uses. */
public final class ServerOption {
  @Option(
      names = "--server",
      paramLabel = "URL[,URL...]",
      description =
          "Server as host:port or URL, the next where one is gone; this process does the work if"
              + " left out.")
  private Optional<String> address = Optional.empty();

  @Option(
      names = "--trust-solver",
      paramLabel = "CERT",
      description =
          "Certificate of a server or host whose solver may run here with all your rights, where a"
              + " local run needs another one than this program has.")
  private List<Path> trusted = List.of();

  @Mixin private TlsOption tls = new TlsOption();

  /**
   * Returns the server's address; empty if none is given.
   *
   * @throws UsageException S-041 if it is blank, as from a variable of a script that is not set:
   *     the server meant is not this process
   */
  public String address() {
    if (address.isPresent() && address.get().isBlank()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --server lacks its value; leave it out to run here");
    }
    return address.orElse("");
  }

  /**
   * Returns the keys whose solvers may run in this process.
   *
   * @throws UsageException S-041 if a file is no certificate
   */
  public List<PublicKey> trustedSolvers() {
    return trusted.stream().map(ServerOption::keyOf).toList();
  }

  private static PublicKey keyOf(Path certificate) {
    try {
      return DetachedSignature.signer(certificate).getPublicKey();
    } catch (IOException | CertificateException e) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --trust-solver "
              + certificate
              + " is no certificate: "
              + e.getMessage()
              + "; name the identity.crt of the server or host");
    }
  }

  public Optional<TlsIdentity> identity() {
    return tls.identity();
  }
}
