package org.mechservice.orb;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.ServerFailure;
import org.slf4j.LoggerFactory;

/** Ending an ORB while calls are on their way to it, which is when ORBs lose count and hang. */
class ClosingTest {
  /** Nothing here takes longer than a few milliseconds; what takes this long hangs. */
  private static final long HANGS_MILLIS = 60_000;

  private static final int SEED = 20261;
  private static final Path DESCRIPTORS = Path.of("/proc/self/fd");

  /** The ORB warns of every request that a closed client no longer takes: tens of thousands. */
  private static final Logger REFUSED =
      (Logger) LoggerFactory.getLogger("org.jacorb.poa.controller");

  @BeforeAll
  static void expectRefusedRequests() {
    REFUSED.setLevel(Level.ERROR);
  }

  @AfterAll
  static void tellRefusedRequestsAgain() {
    REFUSED.setLevel(null);
  }

  @Test
  void clientClosesAmidCallbacksAndTheServerServesOn() throws Exception {
    closeAmidCallbacks(60);
  }

  @Test
  @Tag("soak")
  void clientsCloseAmidCallbacksThousandsOfTimes() throws Exception {
    closeAmidCallbacks(5000);
  }

  private static void closeAmidCallbacks(int times) throws Exception {
    Random random = new Random(SEED);
    try (TalkativeServer server = TalkativeServer.start()) {
      for (int i = 0; i < times; i++) {
        ServiceOrb client = ServiceOrb.client();
        MechServer service = client.connect(server.address());
        try {
          service.createSession("me", "", client.export(new CountingClient()));
        } catch (ServerFailure calledBack) {
          assertThat(calledBack.code).isEqualTo("called back");
        }
        Thread.sleep(random.nextInt(15));
        assertThat(endsInTime(client::close)).as("closing %d of %d", i, times).isTrue();
      }
      awaitSilence(server);
    }
  }

  private static void awaitSilence(TalkativeServer server) throws InterruptedException {
    long deadline = System.nanoTime() + HANGS_MILLIS * 1_000_000;
    while (server.talking() > 0 && System.nanoTime() < deadline) {
      Thread.sleep(10);
    }
    assertThat(server.talking()).as("threads still calling clients that are gone").isZero();
  }

  private static boolean endsInTime(Runnable closing) throws InterruptedException {
    Thread thread = new Thread(closing);
    thread.start();
    thread.join(HANGS_MILLIS);
    return !thread.isAlive();
  }

  @Test
  void serverClosesAmidCallsAndEveryCallComesBack() throws Exception {
    closeServersAmidCalls(20);
  }

  @Test
  @Tag("soak")
  void serversCloseAmidCallsThousandsOfTimes() throws Exception {
    closeServersAmidCalls(3000);
  }

  private static void closeServersAmidCalls(int times) throws Exception {
    Random random = new Random(SEED);
    for (int i = 0; i < times; i++) {
      EchoServer server = EchoServer.start();
      Thread[] callers = new Thread[4];
      try (ServiceOrb client = ServiceOrb.client()) {
        MechServer service = client.connect(server.address());
        for (int k = 0; k < callers.length; k++) {
          callers[k] = new Thread(() -> askUntilRefused(service));
          callers[k].start();
        }
        Thread.sleep(random.nextInt(20));
        assertThat(endsInTime(server::close)).as("closing server %d", i).isTrue();
        for (Thread caller : callers) {
          caller.join(HANGS_MILLIS);
          assertThat(caller.isAlive()).isFalse();
        }
      }
    }
  }

  @Test
  void nothingStaysOpenAfterClosing() throws Exception {
    assumeTrue(Files.isDirectory(DESCRIPTORS), "no /proc here");
    closeServersAmidCalls(1); // loads what stays loaded
    long before = openDescriptors();
    closeServersAmidCalls(20);
    // Two ORBs each; a leak of one descriptor per ORB would show as 40.
    assertThat(openDescriptors()).isLessThan(before + 20);
  }

  private static long openDescriptors() throws IOException {
    try (Stream<Path> open = Files.list(DESCRIPTORS)) {
      return open.count();
    }
  }

  private static void askUntilRefused(MechServer service) {
    try {
      while (true) {
        service.getInfo();
      }
    } catch (org.omg.CORBA.SystemException closed) {
      assertThat(closed).isNotNull();
    }
  }
}
