package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.orb.tls.DetachedSignature;
import org.mechservice.orb.tls.Role;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.server.keys.KeyFolder;
import org.mechservice.sim.host.HostOptions;
import org.omg.CORBA.SystemException;

/** Certificates are renewed, taken back and watched while the service runs. */
@Tag("slow")
class CertificatesTest {
  @TempDir private Path folder;

  private Path keys;
  private Path installed;

  @BeforeEach
  void make() throws IOException {
    keys = folder.resolve("keys");
    KeyFolder made = KeyFolder.open(keys);
    made.localServer();
    made.user("alice", Role.CLIENT);
    made.user("bob", Role.CLIENT);
    made.user("root", Role.ADMIN);
    installed = Files.createDirectory(folder.resolve("installed"));
    install("server");
  }

  /** Copies an identity to where the server has its own, as an operator does. */
  private void install(String name) throws IOException {
    try (DirectoryStream<Path> files = Files.newDirectoryStream(keys.resolve(name))) {
      for (Path file : files) {
        Files.copy(
            file, installed.resolve(file.getFileName()), StandardCopyOption.REPLACE_EXISTING);
      }
    }
  }

  private MechServerProcess server() {
    return MechServerProcess.start(
        new ServerSettings(
            "127.0.0.1",
            0,
            new HostOptions("own", 1),
            PlacementPolicy.LEAST_LOADED,
            Optional.empty(),
            Optional.empty(),
            Optional.of(TlsIdentity.load(installed)),
            Optional.of(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0)),
            Optional.empty()),
        Farm.STEADY,
        HostFactory.INSTALLED);
  }

  private ServiceOrb as(String name) {
    return ServiceOrb.client(Optional.of(TlsIdentity.load(keys.resolve(name))));
  }

  private static boolean accepts(MechServer server) {
    try {
      return server.getInfo() != null;
    } catch (SystemException e) {
      return false;
    }
  }

  private boolean connects(String name, MechServerProcess server) {
    try (ServiceOrb orb = as(name)) {
      return accepts(orb.connect(server.url()));
    } catch (ServiceUnreachableException e) {
      return false;
    }
  }

  @Test
  void renewedCertificateIsUsedWithoutARestart() throws Exception {
    try (MechServerProcess server = server();
        ServiceOrb early = as("alice")) {
      MechSim session = early.connect(server.url()).createSession("", "", null);
      assertThat(session.getRuntimeInfo().signature).isNotEmpty();
      var before = TlsIdentity.load(installed).certificate();
      KeyFolder.open(keys).renew("server");
      install("server");
      var after = TlsIdentity.load(installed).certificate();
      assertThat(after.getPublicKey()).isNotEqualTo(before.getPublicKey());
      assertThat(List.copyOf(after.getSubjectAlternativeNames()))
          .isEqualTo(List.copyOf(before.getSubjectAlternativeNames()));
      Eventually.holds(
          () -> {
            try (ServiceOrb late = as("bob")) {
              byte[] jar =
                  late.connect(server.url()).createSession("", "", null).getRuntimeInfo().signature;
              return DetachedSignature.fits(after.getPublicKey(), runtime(late, server), jar);
            }
          });
      // Who has connected before has seen the former certificate, and checks with it.
      byte[] jar = session.fetchRuntime(session.getRuntimeInfo().sha256);
      byte[] signed = session.getRuntimeInfo().signature;
      assertThat(DetachedSignature.fits(before.getPublicKey(), jar, signed)).isTrue();
    }
  }

  private static byte[] runtime(ServiceOrb orb, MechServerProcess server) throws Exception {
    MechSim session = orb.connect(server.url()).createSession("", "", null);
    return session.fetchRuntime(session.getRuntimeInfo().sha256);
  }

  @Test
  void filesThatDoNotFitTogetherChangeNothing() throws Exception {
    try (MechServerProcess server = server()) {
      Files.writeString(installed.resolve(TlsIdentity.PASSWORD_FILE), "another\n");
      Thread.sleep(2100);
      assertThat(connects("alice", server)).isTrue();
      Thread.sleep(1100);
      assertThat(connects("alice", server)).isTrue();
    }
  }

  @Test
  void revokedCertificateOpensNoConnectionAndKeepsNone() throws Exception {
    try (MechServerProcess server = server();
        ServiceOrb alice = as("alice");
        ServiceOrb bob = as("bob")) {
      MechServer ofAlice = alice.connect(server.url());
      MechServer ofBob = bob.connect(server.url());
      assertThat(accepts(ofAlice)).isTrue();
      Path list = KeyFolder.open(keys).revoke("alice");
      Files.copy(list, installed.resolve(TlsIdentity.REVOKED_FILE));
      Eventually.holds(() -> !accepts(ofAlice));
      assertThat(accepts(ofAlice)).isFalse();
      assertThat(connects("alice", server)).isFalse();
      try (ServiceOrb again = as("alice")) {
        assertThatThrownBy(() -> again.connect(server.url()))
            .isInstanceOf(ServiceUnreachableException.class)
            .hasMessageContaining("certificate");
      }
      assertThat(accepts(ofBob)).isTrue();
      assertThat(connects("bob", server)).isTrue();

      // Another one joins it on the list; a new certificate lets its owner in again.
      KeyFolder.open(keys).revoke("root");
      Files.copy(
          list, installed.resolve(TlsIdentity.REVOKED_FILE), StandardCopyOption.REPLACE_EXISTING);
      Eventually.holds(() -> !connects("root", server));
      assertThat(connects("alice", server)).isFalse();
      KeyFolder.open(keys).renew("alice");
      assertThat(connects("alice", server)).isTrue();
    }
  }

  @Test
  void clientTurnsARevokedServerAway() throws Exception {
    try (MechServerProcess server = server()) {
      KeyFolder.open(keys).revoke("server");
      try (ServiceOrb alice = as("alice")) {
        assertThatThrownBy(() -> alice.connect(server.url()))
            .isInstanceOf(ServiceUnreachableException.class)
            .hasMessageStartingWith("S-152")
            .hasMessageEndingWith("its certificate has been revoked");
      }
    }
  }

  @Test
  void listOfAnotherAuthorityIsRefused() throws IOException {
    KeyFolder others = KeyFolder.open(folder.resolve("others"));
    others.user("mallory", Role.CLIENT);
    Files.copy(others.revoke("mallory"), installed.resolve(TlsIdentity.REVOKED_FILE));
    assertThatThrownBy(() -> TlsIdentity.load(installed))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("S-150")
        .hasMessageContaining("revoked.crl");
  }

  @Test
  void endOfTheCertificatesIsAFigureOfServerAndHosts() throws Exception {
    KeyFolder again = KeyFolder.open(keys);
    again.validFor(Duration.ofDays(20));
    again.renew("server");
    install("server");
    long end = TlsIdentity.load(installed).expires().toEpochMilli();
    try (MechServerProcess server = server();
        ServiceOrb root = as("root")) {
      String url = "http://127.0.0.1:" + server.metricsPort().orElseThrow() + "/metrics";
      String metrics =
          HttpClient.newHttpClient()
              .send(
                  HttpRequest.newBuilder(URI.create(url)).build(),
                  HttpResponse.BodyHandlers.ofString())
              .body();
      assertThat(metrics)
          .contains("mechservice_certificate_expiry_seconds " + end * 1e-3)
          .contains("mechservice_host_certificate_expiry_seconds{host=\"own\"} " + end * 1e-3);
      var admin = root.connectAdmin(server.url());
      for (NameValue[] statistics :
          List.of(admin.getStatus().statistics, admin.listHosts()[0].load.statistics)) {
        assertThat(statistics)
            .anyMatch(
                figure ->
                    figure.key.equals("certificateExpires")
                        && figure.text.equals(Long.toString(end)));
      }
    }
  }
}
