package org.mechservice.sim.service.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.guard.worker.WorkerModel;
import org.mechservice.guard.worker.WorkerOrder;
import org.mechservice.guard.worker.WorkerProcess;
import org.mechservice.guard.worker.WorkerResult;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.service.library.LoadedModel;
import org.mechservice.sim.service.library.ModelLibrary;
import org.mechservice.sim.service.library.SetUpTimes;
import org.mechservice.sim.service.library.SimulationRequest;
import org.mechservice.sim.user.PushedCart;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunRequest;

/** A run of a cart that a harmless class of users pushes, in a worker. */
final class HarmlessRun {
  private HarmlessRun() {}

  /** Returns the order of a run with a harmless class. */
  static WorkerOrder order() throws Exception {
    return order(PushedCart.harmlessSource());
  }

  /**
   * Returns the order of a run with a class.
   *
   * @param source of {@code car.Push}
   */
  static WorkerOrder order(String source) throws Exception {
    LoadedModel read =
        LoadedModel.read(
            "pushed.xml", PushedCart.file(), List.of(PushedCart.asSource(source)), true);
    SimulationRequest asked = SimulationRequest.asInFile(read.model());
    try (ModelLibrary library = new ModelLibrary()) {
      CompiledModel compiled =
          library.compiled(read, asked.forRun(read.model().settings()), new SetUpTimes());
      SortedMap<String, byte[]> own = new TreeMap<>(compiled.classFiles());
      own.keySet().removeAll(compiled.userClassFiles().keySet());
      return new WorkerOrder(
          new WorkerModel(compiled.generated().className(), own, compiled.userClassFiles()),
          Map.of(),
          new RunRequest(asked.settings(), asked.columns(), asked.strict(), asked.maxDrift()));
    }
  }

  /** Runs an order in a worker; its rows are not kept. */
  static WorkerResult report(WorkerOrder order, WorkerProcess worker) throws IOException {
    ResultSink forgetting =
        new ResultSink() {
          @Override
          public void begin(List<Variable> columns) {}

          @Override
          public void row(double[] values) {}
        };
    return worker.run(order, forgetting, new RunControl(), Checkpoints.NONE);
  }
}
