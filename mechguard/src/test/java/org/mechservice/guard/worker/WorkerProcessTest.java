package org.mechservice.guard.worker;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.catalogue.MessageCode;

class WorkerProcessTest {
  private static WorkerLostException lostAfter(String last) throws Exception {
    Process worker = new ProcessBuilder("sh", "-c", "exec 1>&-; " + last).start();
    assertThat(worker.getInputStream().read()).isEqualTo(-1);
    return WorkerProcess.lost(worker, 300_000_000);
  }

  /** On a busy machine seconds pass from the last word of a process to its end. */
  @Test
  void workerWithoutMemoryIsToldFromOthersHoweverLongItTakesToDie() throws Exception {
    assertThat(lostAfter("sleep 3; exit 3"))
        .hasMessageContaining("more than the 300 MB of memory")
        .matches(lost -> lost.code() == MessageCode.OUT_OF_MEMORY);
  }

  @Test
  void workerThatEndsOtherwiseIsReportedWithItsStatus() throws Exception {
    assertThat(lostAfter("exit 7"))
        .hasMessageContaining("with status 7")
        .matches(lost -> lost.code() == MessageCode.WORKER_ENDED);
  }

  @Test
  void workerThatIsKilledFromOutsideIsNotBlamedOnItsClasses() throws Exception {
    assertThat(lostAfter("kill -9 $$"))
        .hasMessageContaining("killed from outside, with signal 9")
        .matches(lost -> lost.code() == MessageCode.WORKER_KILLED);
  }
}
