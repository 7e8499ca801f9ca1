package org.mechservice.sim.service.session;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.ServerFailure;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedFacts;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.library.LoadedModel;
import org.mechservice.sim.service.library.ModelLibrary;
import org.mechservice.sim.service.library.ModelWarnings;
import org.mechservice.sim.service.library.SetUpTimes;
import org.mechservice.sim.service.library.SimulationRequest;
import org.mechservice.sim.service.results.RunColumns;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.run.RunFactory;
import org.mechservice.sim.service.run.RunPlan;
import org.mechservice.sim.service.run.RunTask;
import org.mechservice.sim.service.run.SimulationRun;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Creates the simulations of a session: compiles the model as the request wants it, decides whether
 * its classes of users may run, and gives the run its identity, its columns and its messages.
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
  private final ModelLibrary library;
  private final RunFactory runs;
  private final SetUpTimes times;

  /**
   * @param times of the session; compiling adds to them
   */
  RunCreation(Session session, ModelLibrary library, RunFactory runs, SetUpTimes times) {
    this.session = session;
    this.library = library;
    this.runs = runs;
    this.times = times;
  }

  /**
   * Creates a simulation, which has not begun.
   *
   * @param source the model as the request reads it
   * @param client receives events of the run
   * @throws NotAvailable if the host does not run classes of users, or lacks a method
   */
  Created create(LoadedModel source, SimulationRequest asked, @Nullable IMechClient client)
      throws InvalidModel, InvalidOption, NotAvailable, LimitExceeded, ServerFailure {
    SimulationSettings ofFile = source.model().settings();
    CompiledModel compiled =
        ContractErrors.build(() -> library.compiled(source, asked.forRun(ofFile), times));
    if (compiled.hasUserClasses()) {
      UserCodeAdmission.require(session.host(), source);
    }
    RunRequest request =
        new RunRequest(
            asked.settings(),
            asked.columns(),
            asked.strict(),
            asked.maxDrift(),
            source.model().silenced());
    WorkerBounds bounds = session.limits().ofWorker();
    RunTask task = ContractErrors.build(() -> runs.task(compiled, request, bounds));
    RunColumns columns = ContractErrors.build(() -> runs.columns(task, request));
    RunPlan plan =
        new RunPlan(
            identity(task, source, asked), task, columns, setUp(source, compiled.generated()));
    SimulationRun run = runs.create(plan, session);
    IMechSimRemote reference = session.add(run, client);
    session.recordMessages(run, messages(source, compiled.generated(), asked));
    return new Created(
        run,
        reference,
        compiled.generated().formulationReason(),
        ModelWarnings.ofSetUp(source, asked.formulation(), asked.closure(), asked.settings()));
  }

  private RunIdentity identity(RunTask task, LoadedModel source, SimulationRequest asked) {
    return new RunIdentity(
        UUID.randomUUID().toString(),
        session.id(),
        session.host().hostName(),
        session.owner(),
        task.description().name(),
        source.fileName(),
        source.text(),
        System.currentTimeMillis(),
        asked.earlierIds());
  }

  /** Returns the entries of the run report about the set-up. */
  private Map<String, Object> setUp(LoadedModel source, GeneratedFacts generated) {
    Map<String, Object> entries = new LinkedHashMap<>();
    entries.put("modelSha256", source.sha256());
    entries.put("formulationReason", generated.formulationReason());
    entries.putAll(times.asMap());
    entries.remove("t2s"); // a run makes no JAR
    return entries;
  }

  private static Diagnostic[] messages(
      LoadedModel source, GeneratedFacts generated, SimulationRequest asked) {
    Diagnostic[] warnings = ContractTypes.diagnostics(source.model().warnings());
    Diagnostic[] all = new Diagnostic[warnings.length + 1];
    System.arraycopy(warnings, 0, all, 0, warnings.length);
    all[warnings.length] =
        ContractTypes.information(
            MessageCode.SERVER_CHOICE,
            "formulation "
                + generated.formulation()
                + " ("
                + generated.formulationReason()
                + "), integrator "
                + asked.settings().integrator());
    return all;
  }
}
