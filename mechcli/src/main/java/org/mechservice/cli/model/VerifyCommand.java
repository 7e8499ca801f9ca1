package org.mechservice.cli.model;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.orb.tls.DetachedSignature;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech verify}: whether a JAR is the one a server has signed. */
@Command(
    name = "verify",
    description = "Checks the signature of a JAR that mech build wrote over TLS.",
    footer = "mech verify model.jar --key server/identity.crt",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class VerifyCommand implements Callable<Integer> {
  /** Follows the name of the JAR. */
  public static final String SIGNATURE_SUFFIX = ".sig";

  @Parameters(paramLabel = "FILE.jar", description = "The JAR.")
  private Path jar = Path.of("");

  @Option(
      names = "--key",
      required = true,
      paramLabel = "CERT",
      description = "Certificate of the server or host that built it (its identity.crt).")
  private Path key = Path.of("");

  @Option(
      names = "--signature",
      paramLabel = "FILE",
      description = "The signature (default: FILE.jar.sig).")
  private Optional<Path> signature = Optional.empty();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    Path beside = jar.resolveSibling(jar.getFileName() + SIGNATURE_SUFFIX);
    X509Certificate signer = certificate();
    boolean fits =
        DetachedSignature.fits(
            signer.getPublicKey(),
            Files.readAllBytes(jar),
            Files.readAllBytes(signature.orElse(beside)));
    if (!fits) {
      spec.commandLine()
          .getErr()
          .println(
              MessageCode.JAR_SIGNATURE
                  + " "
                  + jar
                  + " is not what the holder of "
                  + key
                  + " has signed: it was changed, or somebody else built it");
      return ExitStatus.BAD_INPUT;
    }
    spec.commandLine()
        .getOut()
        .println(jar + " was signed by " + signer.getSubjectX500Principal().getName());
    return ExitStatus.DONE;
  }

  private X509Certificate certificate() throws IOException {
    try {
      return DetachedSignature.signer(key);
    } catch (CertificateException e) {
      throw new UsageException(
          MessageCode.CERTIFICATES_UNUSABLE
              + " "
              + key
              + " is no certificate; name the identity.crt of the machine that built it");
    }
  }
}
