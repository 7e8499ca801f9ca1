package org.mechservice.sim.service.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.guard.worker.WorkerOrder;
import org.mechservice.guard.worker.WorkerProcess;
import org.mechservice.guard.worker.WorkerResult;
import org.mechservice.sim.user.PushedCart;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.SteppedModel;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.catalogue.MessageCode;

/** A run in a worker that is stepped from outside, and whose classes or process do not go on. */
@Tag("slow")
class ConfinedStepsTest {
  private static final Duration LONG = Duration.ofMinutes(10);

  /** Pushes as before, and never returns after 0.3 s, in the second step. */
  private static final String HANGING =
      PushedCart.harmlessSource()
          .replace(
              "loads.addJointForce(slide, 3);",
              """
              loads.addJointForce(slide, 3);
              double sum = 0;
              while (state.time() > 0.3 && sum >= 0) {
                sum = Math.abs(Math.sin(sum + 1));
              }
              """);

  /** A run that has begun, and its processes. */
  private record Begun(SteppedModel run, List<ProcessHandle> processes) {
    void kill() {
      processes.stream().filter(one -> one.children().findAny().isEmpty()).forEach(Begun::kill);
    }

    private static void kill(ProcessHandle process) {
      process.destroyForcibly();
      process.onExit().join();
    }

    boolean isGone() {
      processes.forEach(one -> one.onExit().join());
      return true;
    }
  }

  private static Set<ProcessHandle> children() {
    return ProcessHandle.current().descendants().collect(Collectors.toSet());
  }

  /** Steps of 0.25 s. */
  private static Begun begun(String source, Duration longest) throws Exception {
    WorkerOrder order = HarmlessRun.order(source);
    Set<ProcessHandle> before = children();
    WorkerProcess worker =
        new WorkerProcess(Confinement.ofThisMachine(), new WorkerBounds(1 << 28, -1));
    int states = worker.describe(order.model()).coordinates();
    SteppedModel run =
        SteppedModel.begin(
            new SteppedModel.Source(
                rows -> worker.steps(order, "hash", rows, longest, told -> report(told, order)),
                states,
                List.of(),
                Set.of()));
    List<ProcessHandle> processes = new ArrayList<>(children());
    processes.removeAll(before);
    return new Begun(run, processes);
  }

  private static RunReport report(WorkerResult told, WorkerOrder order) {
    return new RunReport(
        told.outcome(),
        "pushed",
        "DTR",
        order.request().settings(),
        0,
        0,
        0,
        0,
        0,
        0,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        false,
        "");
  }

  private static RunFailedException failureOf(ThrowingCallable step) {
    RunFailedException failed = catchThrowableOfType(RunFailedException.class, step);
    assertThat(failed).isNotNull();
    return failed;
  }

  /** The run stays failed and says why, whatever is asked. */
  private static void assertLost(Begun begun, String why) {
    SteppedModel run = begun.run();
    assertThat(begun.isGone()).isTrue();
    assertThat(run.isRunning()).isFalse();
    assertThat(run.time()).isEqualTo(0.25);
    assertThat(run.value("slide.q")).isPositive();
    assertThat(run.report().outcome()).isInstanceOf(Outcome.Failed.class);
    assertThatThrownBy(run::step).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(run::state)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining(why);
    assertThatThrownBy(run::save)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining(why);
  }

  @Test
  void stepThatDoesNotReturnEndsAtItsLimit() throws Exception {
    Begun begun = begun(HANGING, Duration.ofSeconds(5));
    begun.run().step();
    assertThat(failureOf(begun.run()::step).failure().code()).isEqualTo(MessageCode.WORKER_ENDED);
    assertLost(begun, "a step has taken more than 5 s");
  }

  @Test
  void interruptEndsAStepThatDoesNotReturn() throws Exception {
    Begun begun = begun(HANGING, LONG);
    begun.run().step();
    Thread caller = Thread.currentThread();
    Thread interrupting =
        new Thread(
            () -> {
              try {
                Thread.sleep(200);
              } catch (InterruptedException e) {
                throw new IllegalStateException(e);
              }
              caller.interrupt();
            });
    interrupting.start();
    RunFailedException failed = failureOf(begun.run()::step);
    assertThat(Thread.interrupted()).isTrue();
    assertThat(failed.failure().code()).isEqualTo(MessageCode.WORKER_ENDED);
    assertLost(begun, "the thread that waited for a step was interrupted");
  }

  @Test
  void stepIsInterruptedFromAnotherThread() throws Exception {
    Begun begun = begun(HANGING, LONG);
    begun.run().step();
    Thread interrupting =
        new Thread(
            () -> {
              while (begun.run().isRunning()) {
                begun.run().interrupt();
                Thread.onSpinWait();
              }
            });
    interrupting.start();
    begun.run().step();
    interrupting.join();
    assertThat(begun.run().report().outcome()).isInstanceOf(Outcome.Stopped.class);
    assertThat(begun.isGone()).isTrue();
  }

  @Test
  void stateIsSetAndTheRunBeginsAgain() throws Exception {
    SteppedModel run = begun(PushedCart.harmlessSource(), LONG).run();
    run.step();
    double[] row = run.row();
    double[] state = run.state();
    state[0] = 2;
    run.state(state);
    assertThat(run.value("slide.q")).isEqualTo(2);
    run.reset();
    assertThat(run.time()).isZero();
    assertThat(run.value("slide.q")).isNotEqualTo(2);
    run.step();
    assertThat(run.row()).isEqualTo(row);
  }

  @Test
  void lossOfTheProcessBetweenTwoStepsIsTold() throws Exception {
    Begun begun = begun(PushedCart.harmlessSource(), LONG);
    begun.run().step();
    begun.kill();
    assertThat(failureOf(begun.run()::step).failure().code()).isEqualTo(MessageCode.WORKER_KILLED);
    assertLost(begun, "killed from outside, with signal 9");
  }

  /** The first call after the loss gives the reason, and so does the next step. */
  @Test
  void lossIsToldByEachCall() throws Exception {
    Begun begun = begun(PushedCart.harmlessSource(), LONG);
    begun.run().step();
    begun.kill();
    assertThatThrownBy(begun.run()::save)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("killed from outside");
    assertThat(failureOf(begun.run()::step).failure().code()).isEqualTo(MessageCode.WORKER_KILLED);
    assertLost(begun, "killed from outside");
  }
}
