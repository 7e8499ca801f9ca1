package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.RunSetUp;
import org.mechservice.load.ServiceJvm.Inside;
import org.mechservice.orb.ServiceOrb;

/** What is created and destroyed leaves nothing behind in the server. */
@Tag("slow")
class CyclesTest {
  private static final NameValue[] SHORT = {new NameValue("t-end", "0.02")};

  /** Java's own bookkeeping goes up and down by this much. */
  private static final long NOISE_BYTES = 2_000_000;

  @Test
  void someCyclesLeaveNothing() throws Exception {
    try (ServiceJvm server = ServiceJvm.server(128)) {
      cycles(server, 20, 10);
      Inside before = settled(server);
      cycles(server, 60, 20);
      assertNothingIsLeft(before, settled(server));
    }
  }

  @Tag("soak")
  @Test
  void tenThousandCyclesLeaveNothing() throws Exception {
    SoakPage page =
        new SoakPage(
            "Ten thousand times created and destroyed",
            "A server with `-Xmx128m`. A cycle: open a session, load the pendulum, create a"
                + " simulation with its cursor, start it, take its rows to the end, destroy the"
                + " session; every hundredth cycle the client opens a new connection and closes the"
                + " old one. The first 2000 cycles fill what the server remembers on purpose (its"
                + " last 1000 runs and events for operators); from there on nothing grows. Counted"
                + " in the server's process after a full collection.",
            0);
    page.line("| cycles | heap in use | CORBA objects | threads | open files |");
    page.line("|---|---|---|---|---|");
    try (ServiceJvm server = ServiceJvm.server(128)) {
      Inside before = null;
      for (int done = 2000; done <= 12_000; done += 2000) {
        cycles(server, 2000, 100);
        Inside now = settled(server);
        before = before == null ? now : before;
        page.line(
            "| %d | %.2f MB | %d | %d | %d |",
            done, now.heapBytes() * 1e-6, now.objects(), now.threads(), now.files());
        assertNothingIsLeft(before, now);
        assertThat(now.heapBytes()).isLessThan(before.heapBytes() + NOISE_BYTES);
      }
    }
    page.write("service-cycles.md");
  }

  /**
   * Idle threads of pools end after a while, connections are seen to be closed, and the objects of
   * the last session go.
   */
  private static Inside settled(ServiceJvm server) throws Exception {
    Inside last = server.inside();
    for (int i = 0; i < 10; i++) {
      Thread.sleep(1000);
      Inside next = server.inside();
      if (next.threads() >= last.threads()
          && next.files() >= last.files()
          && next.objects() >= last.objects()) {
        return next;
      }
      last = next;
    }
    return last;
  }

  private static void assertNothingIsLeft(Inside before, Inside after) {
    assertThat(before.objects()).isPositive();
    assertThat(after.objects()).as("CORBA objects").isEqualTo(before.objects());
    assertThat(after.threads()).as("threads").isLessThanOrEqualTo(before.threads() + 2);
    assertThat(after.files()).as("open files").isLessThanOrEqualTo(before.files() + 2);
  }

  private static void cycles(ServiceJvm server, int count, int perConnection) throws Exception {
    byte[] model = Files.readAllBytes(Runs.PENDULUM);
    for (int done = 0; done < count; done += perConnection) {
      try (ServiceOrb orb = ServiceOrb.client()) {
        MechServer service = orb.connect(server.address());
        for (int i = 0; i < perConnection; i++) {
          cycle(service, model);
        }
      }
    }
  }

  private static void cycle(MechServer service, byte[] model) throws Exception {
    MechSim session = service.createSession("cycles", "", null);
    session.loadModel(new ModelFile("pendulum.xml", model), new ModelFile[0]);
    RunSetUp run = session.prepareSimulation(SHORT, null);
    run.simulation.start();
    ResultBlockHolder block = new ResultBlockHolder();
    long rows = 0;
    do {
      run.rows.nextBlock(0, 1000, block);
      rows += block.value.rowCount;
    } while (!block.value.endOfData);
    assertThat(rows).isEqualTo(3);
    session.destroy();
  }
}
