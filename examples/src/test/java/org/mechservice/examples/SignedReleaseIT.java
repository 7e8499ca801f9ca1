package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checksums and detached signatures of what is published, with the commands of the guide. */
class SignedReleaseIT {
  @TempDir private Path folder;

  @Test
  void signedFileIsVerifiedAndAChangedOneIsNot() throws Exception {
    Terminal terminal = new Terminal(folder);
    assumeTrue(terminal.shell("openssl version").exitStatus() == 0, "openssl is not installed");
    terminal.mech("keys", "keys", "--host", "release.example.org").orFail();
    terminal
        .shell(
            "openssl pkcs12 -in keys/release.example.org/identity.p12 -nodes -nocerts"
                + " -passin file:keys/release.example.org/password -out key.pem")
        .orFail();
    Files.writeString(folder.resolve("archive.tar.gz"), "an archive");
    terminal.shell(WorkingTree.TOP.resolve("dist/sign") + " --key key.pem archive.tar.gz").orFail();
    terminal.shell("sha256sum -c archive.tar.gz.sha256").orFail();
    String certificate = "keys/release.example.org/identity.crt";
    terminal.mech("verify", "archive.tar.gz", "--key", certificate).orFail();

    Files.writeString(folder.resolve("archive.tar.gz"), "another one");
    assertThat(terminal.shell("sha256sum -c archive.tar.gz.sha256").exitStatus()).isNotZero();
    Terminal.Ended changed = terminal.mech("verify", "archive.tar.gz", "--key", certificate);
    assertThat(changed.exitStatus()).isEqualTo(2);
    assertThat(changed.stderr()).contains("S-154");
  }
}
