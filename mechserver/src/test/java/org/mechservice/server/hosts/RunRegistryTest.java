package org.mechservice.server.hosts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.idl.StepTried;
import org.mechservice.sim.service.contract.Journal;

class RunRegistryTest {
  private final List<ServiceEvent> journal = new ArrayList<>();
  private final RunRegistry book = new RunRegistry(new Journal("server", journal::add));
  private long clock = System.nanoTime();

  private static ServiceEvent event(String kind, String simId) {
    return new ServiceEvent(
        1, 5000, kind, Severity.SEV_INFO, "", "h", "session", simId, "ann", kind.substring(4));
  }

  private static SimSummary summary(String simId, SimState state, double time) {
    return new SimSummary(
        simId,
        "session",
        "h",
        "Crane",
        "ann",
        new Progress(simId, state, 0, time, 0, 10, 7, 0.1, 5, 1, 3),
        1000,
        2000,
        state == SimState.SIM_DONE ? 4000 : 0,
        9000,
        "as listed");
  }

  private void listed(SimSummary... runs) {
    clock++;
    book.listed("h", runs, clock);
  }

  private static SimDetail detail(SimSummary summary) {
    return new SimDetail(
        summary,
        "<MechML/>",
        "{}",
        "{\"outcome\":\"reached the end\"}",
        new FailureRecord("", "", 0, 0, 0, "", "", new StepTried[0]),
        new CurveSample[] {new CurveSample(1, 2, 3, 4, 5, 6)},
        new SimEvent[0]);
  }

  @Test
  void runThatHadEndedOnALostHostStaysAsItWas() {
    SimSummary done = summary("a", SimState.SIM_DONE, 10);
    listed(done);
    book.read(detail(done));
    book.removeHost("h", "was lost");
    assertThat(book.ofGoneHosts()).containsExactly(done);
    SimDetail shown = book.lastKnown("a").orElseThrow();
    assertThat(shown.reportJson).contains("reached the end");
    assertThat(shown.modelText).isEqualTo("<MechML/>");
    assertThat(shown.failed.code).isEmpty();
    assertThat(journal).isEmpty();
  }

  @Test
  void runThatWentOnWithALostHostHasFailedWithTheTimeItHadReached() {
    SimSummary running = summary("a", SimState.SIM_RUNNING, 4);
    listed(running);
    book.read(detail(running));
    book.removeHost("h", "was lost");
    SimSummary lost = book.ofGoneHosts().iterator().next();
    assertThat(lost.info.state).isEqualTo(SimState.SIM_FAILED);
    assertThat(lost.info.simTime).isEqualTo(4);
    assertThat(lost.modelName).isEqualTo("Crane");
    assertThat(lost.text).isEqualTo("S-113 the simulation ended with host h, which was lost");
    assertThat(lost.endedAt).isPositive();
    SimDetail shown = book.lastKnown("a").orElseThrow();
    assertThat(shown.failed.code).isEqualTo("S-113");
    assertThat(shown.failed.simTime).isEqualTo(4);
    assertThat(shown.curves).hasSize(1);
    assertThat(journal)
        .singleElement()
        .satisfies(
            event -> {
              assertThat(event.kind).isEqualTo("sim-lost");
              assertThat(event.simId).isEqualTo("a");
              assertThat(event.owner).isEqualTo("ann");
            });
  }

  @Test
  void eventsTellWhatBecameOfARunBeforeItIsListedAgain() {
    listed(summary("a", SimState.SIM_RUNNING, 4));
    book.follow(event("sim-done", "a"));
    assertThat(book.of("h").get(0).info.state).isEqualTo(SimState.SIM_DONE);
    assertThat(book.of("h").get(0).endedAt).isEqualTo(5000);
    book.removeHost("h", "was lost");
    assertThat(book.ofGoneHosts().iterator().next().info.state).isEqualTo(SimState.SIM_DONE);
  }

  @Test
  void runOnlyHeardOfIsKnownToo() {
    book.follow(event("sim-queued", "a"));
    book.follow(event("sim-running", "a"));
    assertThat(book.of("h").get(0).info.state).isEqualTo(SimState.SIM_RUNNING);
    assertThat(book.hostOf("a")).contains("h");
    assertThat(book.outdated("h", 0, Long.MAX_VALUE)).isTrue();
    assertThat(book.takeUnread("h")).contains("a");
    assertThat(book.takeUnread("h")).isEmpty();
    book.notRead("h", "a");
    assertThat(book.takeUnread("h")).contains("a");
  }

  @Test
  void checkReportThatAnAdministratorHasSeenStaysWithTheRun() {
    listed(summary("a", SimState.SIM_RUNNING, 4));
    SimDetail seen = detail(summary("a", SimState.SIM_RUNNING, 4));
    seen.checkReportJson = "{\"loops\":1}";
    book.read(seen);
    SimDetail noted = detail(summary("a", SimState.SIM_DONE, 10));
    noted.checkReportJson = "";
    book.read(noted);
    assertThat(book.lastKnown("a").orElseThrow().checkReportJson).isEqualTo("{\"loops\":1}");
  }

  @Test
  void answerToAnEarlierQuestionIsLeftOut() {
    book.listed("h", new SimSummary[] {summary("a", SimState.SIM_DONE, 10)}, 2);
    book.listed("h", new SimSummary[] {summary("a", SimState.SIM_RUNNING, 9)}, 1);
    assertThat(book.of("h").get(0).info.state).isEqualTo(SimState.SIM_DONE);
  }

  @Test
  void runsOfAHostThatIsBackAreItsOwnAgain() {
    listed(summary("a", SimState.SIM_RUNNING, 4));
    book.removeHost("h", "was lost");
    assertThat(book.endOf("a")).contains("the simulation ended with host h, which was lost");
    book.listed("h2", new SimSummary[] {summary("a", SimState.SIM_DONE, 10)}, System.nanoTime());
    assertThat(book.ofGoneHosts()).isEmpty();
    assertThat(book.endOf("a")).isEmpty();
    assertThat(book.hostOf("a")).contains("h2");
  }

  @Test
  void oldestRunsOfGoneHostsAreForgottenFirst() {
    for (int i = 0; i < 2500; i++) {
      book.listed("h" + i, new SimSummary[] {summary("r" + i, SimState.SIM_DONE, 1)}, 1);
      book.removeHost("h" + i, "was lost");
    }
    assertThat(book.ofGoneHosts()).hasSize(2000);
    assertThat(book.lastKnown("r0")).isEmpty();
    assertThat(book.lastKnown("r2499")).isPresent();
  }
}
