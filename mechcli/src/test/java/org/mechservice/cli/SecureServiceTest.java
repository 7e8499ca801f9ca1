package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.sim.host.HostOptions;

/** The commands at a server over TLS, with the keys that {@code mech keys} makes. */
@Tag("slow")
class SecureServiceTest {
  private static final String MODEL = "../examples/pendulum/pendulum.xml";

  @TempDir private static Path keys;
  private static MechServerProcess server;

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int mech(String... words) {
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  private static String identity(String name) {
    return keys.resolve(name).toString();
  }

  @BeforeAll
  static void start() {
    PrintWriter nowhere = new PrintWriter(new StringWriter());
    assertThat(Mech.run(nowhere, nowhere, "keys", keys.toString())).isZero();
    server =
        MechServerProcess.start(
            new ServerSettings(
                "127.0.0.1",
                0,
                new HostOptions("secure", 2),
                PlacementPolicy.LEAST_LOADED,
                Optional.of(keys.resolve("server.ior")),
                Optional.empty(),
                Optional.of(TlsIdentity.load(keys.resolve("server")))));
  }

  @AfterAll
  static void stop() {
    server.close();
  }

  private Path simulated(String name, String... more) {
    Path file = folder.resolve(name);
    String[] words = new String[more.length + 5];
    System.arraycopy(
        new String[] {"simulate", MODEL, "--quiet", "--out", file.toString()}, 0, words, 0, 5);
    System.arraycopy(more, 0, words, 5, more.length);
    assertThat(mech(words)).as(err.toString()).isZero();
    return file;
  }

  @Test
  void resultsAreTheSameBytesOverTls() {
    Path plain = simulated("plain.csv");
    String client = identity("client");
    assertThat(simulated("remote.csv", "--server", server.url(), "--tls", client))
        .hasSameBinaryContentAs(plain);
    assertThat(simulated("local.csv", "--server", server.url(), "--tls", client, "--mode", "local"))
        .hasSameBinaryContentAs(plain);
    String ior = keys.resolve("server.ior").toString();
    assertThat(simulated("ior.csv", "--server", ior, "--tls", client))
        .hasSameBinaryContentAs(plain);
  }

  @Test
  void nextServerIsUsedWhereTheFirstIsGone() throws IOException {
    int free;
    try (ServerSocket probe = new ServerSocket(0)) {
      free = probe.getLocalPort();
    }
    String both = "127.0.0.1:" + free + "," + server.url();
    assertThat(simulated("next.csv", "--server", both, "--tls", identity("client")))
        .isNotEmptyFile();
    assertThat(mech("check", MODEL, "--server", "127.0.0.1:" + free + ",127.0.0.1:" + free))
        .isEqualTo(ExitStatus.SERVER);
    assertThat(err.toString()).startsWith("S-161 none of the servers can be used; S-002");
  }

  @Test
  void builtJarIsSignedAndAChangedOneIsFoundOut() throws IOException {
    String jar = folder.resolve("p.jar").toString();
    String certificate = keys.resolve("server/identity.crt").toString();
    assertThat(
            mech("build", MODEL, "-o", jar, "--server", server.url(), "--tls", identity("client")))
        .isZero();
    assertThat(mech("verify", jar, "--key", certificate)).isZero();
    assertThat(out.toString()).contains("p.jar was signed by CN=localhost,OU=server");
    assertThat(mech("verify", jar, "--key", keys.resolve("admin/identity.crt").toString()))
        .isEqualTo(ExitStatus.BAD_INPUT);
    byte[] changed = Files.readAllBytes(Path.of(jar));
    changed[changed.length / 2] ^= 1;
    Files.write(Path.of(jar), changed);
    err.getBuffer().setLength(0);
    assertThat(mech("verify", jar, "--key", certificate)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-154 ");
  }

  @Test
  void whatIsWrongWithCertificatesIsSaid() {
    assertThat(mech("check", MODEL, "--server", server.url())).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-151 ").contains("--tls FOLDER");
    err.getBuffer().setLength(0);
    assertThat(mech("check", MODEL, "--server", server.url(), "--tls", keys.toString()))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-150 ");
    err.getBuffer().setLength(0);
    assertThat(mech("server", "--listen", "0.0.0.0", "--port", "0"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-004 ").contains("mech keys");
  }

  @Test
  void optionsOfServersAreChecked() {
    assertThat(mech("server", "--placement", "random")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-041").contains("order, least-loaded, pinned");
    err.getBuffer().setLength(0);
    assertThat(mech("server", "--limit", "nosuch=1")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-015 there is no limit \"nosuch\"");
  }
}
