package org.mechservice.cli.sweep;

import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.client.HostedModel;
import org.mechservice.client.MechConnection;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.run.RunResult;
import org.mechservice.guard.UserCode;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.study.PointEvaluation;
import org.mechservice.study.PointModel;
import org.mechservice.study.PointOutcome;
import org.mechservice.study.Reducer;
import org.mechservice.study.run.StudyPlan;

/** Runs the points of a study on the hosts of a server, with the bits of this process. */
final class HostsEvaluation implements PointEvaluation, AutoCloseable {
  /** Codes of what a host or its operator has ended: limits, and processes that were killed. */
  private static final String OF_HOST = "S-1[01]\\d|S-157|S-174|S-178";

  private final PointModel model;
  private final HostedModel hosts;
  private final ThreadLocal<Reducer> reducers;

  /**
   * @param userCode the folders whose classes of forces are sent
   */
  HostsEvaluation(StudyPlan plan, MechConnection connection, UserCode userCode) {
    model = plan.model();
    SimulationOptions options = SimulationOptions.asInFile();
    for (Map.Entry<String, String> option : plan.runOptions().entrySet()) {
      options = options.with(option.getKey(), option.getValue());
    }
    options = options.columns(model.model().columns());
    if (plan.simulation().isPresent()) {
      options = options.simulation(plan.simulation().get());
    }
    for (String name : model.tunable()) {
      options = options.tunable(name);
    }
    hosts = new HostedModel(connection, plan.modelFile(), userCode, options);
    reducers = ThreadLocal.withInitial(model::reducer);
  }

  @Override
  public PointOutcome run(Map<String, Double> parameters) throws IOException {
    Map<String, String> settled = new TreeMap<>();
    Map<String, String> inputs = new TreeMap<>();
    for (Map.Entry<String, Double> value : parameters.entrySet()) {
      (model.tunable().contains(value.getKey()) ? inputs : settled)
          .put(value.getKey(), Double.toString(value.getValue()));
    }
    try {
      Reducer reducer = reducers.get();
      RunResult result = hosts.run(settled, inputs, reducer);
      return result.outcome() instanceof Outcome.Failed failed
          ? failed(failed.failure())
          : new PointOutcome.Values(reducer.values());
    } catch (InvalidModelException | InvalidOptionException refused) {
      // The words of its row are those of this process, which refuses the values as well.
      if (model.run(parameters) instanceof PointOutcome.Failed failed) {
        return failed;
      }
      throw refused;
    }
  }

  private static PointOutcome failed(Failure failure) throws IOException {
    if (failure.code().code().matches(OF_HOST)) {
      throw new IOException(failure.code() + " " + failure.message());
    }
    return PointOutcome.Failed.of(failure);
  }

  @Override
  public void close() {
    hosts.close();
  }
}
