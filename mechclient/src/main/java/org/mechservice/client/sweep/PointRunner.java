package org.mechservice.client.sweep;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.client.MechSession;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.LimitExceededException;
import org.mechservice.client.failure.NotFoundException;
import org.mechservice.client.failure.ServerFailureException;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.client.run.RunResult;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Runs points of a sweep, one after the other in one session; opens a new session when one is lost.
 */
final class PointRunner implements AutoCloseable {
  /**
   * Code of a missing name. The model was read without parameters before, so the missing name is
   * one of the grid's parameters.
   */
  private static final String NO_SUCH_NAME = MessageCode.UNKNOWN_NAME.code();

  /** Code of an error in the model, inside a message about an unusable option. */
  private static final Pattern OF_MODEL = Pattern.compile("\\bM-\\d{3}\\b");

  private static final long PAUSE_MILLIS = 500;

  private final Sweep sweep;
  private Optional<MechSession> session;

  PointRunner(Sweep sweep, Optional<MechSession> session) {
    this.sweep = sweep;
    this.session = session;
  }

  /** Stores the latest row. */
  private static final class LastRow implements ResultSink {
    private double[] row = {};

    @Override
    public void begin(List<Variable> columns) {
      row = new double[0];
    }

    @Override
    public void row(double[] values) {
      row = values.clone();
    }
  }

  /**
   * Runs a point.
   *
   * @return its row; empty if the sweep was stopped meanwhile
   * @throws ServiceException if the service is lost after several attempts, or the model has no
   *     such parameter
   */
  Optional<SweepRow> run(int point, int attempts) throws IOException {
    for (int attempt = 1; ; attempt++) {
      try {
        return Optional.of(runOnce(point));
      } catch (ServerLostException | NotFoundException | LimitExceededException e) {
        giveUpSession();
        if (attempt == attempts || !pause(attempt)) {
          if (sweep.isStopped()) {
            return Optional.empty();
          }
          throw e;
        }
      }
    }
  }

  private boolean pause(int attempt) {
    try {
      Thread.sleep(PAUSE_MILLIS * attempt);
      return !sweep.isStopped();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  private SweepRow runOnce(int point) throws IOException {
    if (session.isEmpty()) {
      session = Optional.of(sweep.session());
    }
    RemoteRun run;
    try {
      run = sweep.prepare(session.get(), point);
    } catch (InvalidModelException | InvalidOptionException e) {
      if (codeOf(e).equals(NO_SUCH_NAME)) {
        throw new UnknownParameterException(e);
      }
      return failed(point, e, new LastRow());
    }
    LastRow last = new LastRow();
    try (run) {
      return row(point, run.toEnd(last), last);
    } catch (InvalidStateException e) {
      if (sweep.isStopped()) { // before it began
        return new SweepRow(point, SweepRow.STOPPED, "", "", List.of(), Map.of());
      }
      throw e;
    } catch (InvalidOptionException | ServerFailureException e) {
      return failed(point, e, last);
    } finally {
      sweep.ended(run);
    }
  }

  private static SweepRow failed(int point, ServiceException why, LastRow last) {
    String message = String.valueOf(why.getMessage()).lines().findFirst().orElse("");
    return SweepRow.failed(point, codeOf(why), message, last.row, Map.of());
  }

  private static String codeOf(ServiceException why) {
    Matcher ofModel = OF_MODEL.matcher(String.valueOf(why.getMessage()));
    return ofModel.find() ? ofModel.group() : why.code();
  }

  private static SweepRow row(int point, RunResult result, LastRow last) {
    if (result.outcome() instanceof Outcome.Failed failed) {
      return SweepRow.failed(
          point,
          failed.failure().code().code(),
          failed.failure().message(),
          last.row,
          result.report());
    }
    String outcome =
        result.outcome() instanceof Outcome.Stopped ? SweepRow.STOPPED : SweepRow.COMPLETED;
    return new SweepRow(point, outcome, "", "", SweepRow.boxed(last.row), result.report());
  }

  private void giveUpSession() {
    session.ifPresent(
        lost -> {
          try {
            lost.close();
          } catch (ServiceException e) {
            // It is lost with its host.
          }
        });
    session = Optional.empty();
  }

  @Override
  public void close() {
    giveUpSession();
  }
}
