package org.mechservice.sim.service.session;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.ServerFailure;
import org.mechservice.sim.model.ModelClasses;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.library.SetUpTimes;
import org.mechservice.sim.service.results.RunColumns;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.run.RunFactory;
import org.mechservice.sim.service.run.RunPlan;
import org.mechservice.sim.service.run.RunTask;
import org.mechservice.sim.service.run.SimulationRun;
import org.mechservice.sim.service.setup.ModelFiles;
import org.mechservice.sim.service.setup.SetUps;
import org.mechservice.solver.api.run.RunRequest;

/**
 * Creates the simulations of a session: takes the classes of a model, decides whether its classes
 * of users may run, and gives the run its identity, its columns and its messages.
 */
final class RunCreation {
  /**
   * A simulation that was created.
   *
   * @param formulationReason why it has its formulation
   * @param warnings of its set-up, entries of the run report
   */
  record Created(
      SimulationRun run,
      IMechSimRemote reference,
      String formulationReason,
      Map<String, String> warnings) {}

  private final Session session;
  private final ClassLibrary library;
  private final RunFactory runs;
  private final SetUpTimes times;

  /**
   * @param library has the classes of models that were built
   * @param times of the session
   */
  RunCreation(Session session, ClassLibrary library, RunFactory runs, SetUpTimes times) {
    this.session = session;
    this.library = library;
    this.runs = runs;
    this.times = times;
  }

  /**
   * Creates a simulation, which has not begun.
   *
   * @param source the model as the client sent it
   * @param built the model as the request wants it
   * @param client receives events of the run
   * @throws NotAvailable if the host does not run classes of users, or lacks a method
   */
  Created create(ModelFiles source, SetUps.Built built, @Nullable IMechClient client)
      throws InvalidModel, InvalidOption, NotAvailable, LimitExceeded, ServerFailure {
    ModelClasses classes = library.of(built.generated(), built.files());
    if (classes.hasUserClasses()) {
      UserCodeAdmission.require(session.host(), built.files().ofUsers());
    }
    RunRequest request = built.request();
    WorkerBounds bounds = session.limits().ofWorker();
    RunTask task = ContractErrors.build(() -> runs.task(classes, request, bounds));
    RunColumns columns = ContractErrors.build(() -> runs.columns(task, request));
    RunPlan plan =
        new RunPlan(
            identity(task, source, built.earlierIds()), task, columns, setUp(source, built));
    SimulationRun run = runs.create(plan, session);
    IMechSimRemote reference = session.add(run, client);
    session.recordMessages(run, built.messages());
    return new Created(run, reference, built.generated().formulationReason(), built.warnings());
  }

  private RunIdentity identity(RunTask task, ModelFiles source, List<String> earlierIds) {
    return new RunIdentity(
        UUID.randomUUID().toString(),
        session.id(),
        session.host().hostName(),
        session.owner(),
        task.description().name(),
        source.fileName(),
        source.text(),
        System.currentTimeMillis(),
        earlierIds);
  }

  /** Returns the entries of the run report about the set-up. */
  private Map<String, Object> setUp(ModelFiles source, SetUps.Built built) {
    Map<String, Object> entries = new LinkedHashMap<>();
    entries.put("modelSha256", source.sha256());
    entries.put("formulationReason", built.generated().formulationReason());
    entries.putAll(times.asMap());
    entries.remove("t2s"); // a run makes no JAR
    return entries;
  }
}
