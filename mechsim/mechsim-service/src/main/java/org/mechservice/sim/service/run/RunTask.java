package org.mechservice.sim.service.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.mechservice.guard.worker.WorkerLostException;
import org.mechservice.guard.worker.WorkerResult;
import org.mechservice.sim.service.limits.LimitReachedException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunSettings;

/** The computation of one run, in this process or in one of its own; runs once. */
public interface RunTask {
  /** Returns a model that knows names and columns; it may lack what users have written. */
  Model model();

  /**
   * Returns the columns of the rows. Values of users' forces are known only where their classes are
   * loaded, so a process may be started to name them.
   */
  List<Variable> columns();

  /** Returns the description of the model. */
  ModelDescription description();

  /** Returns when the run starts and ends, and how it is integrated. */
  RunSettings settings();

  /** Returns the parameters that may be set before the run, with the values they have. */
  List<TunableParameter> parameters();

  /**
   * Returns the same run with other values of some parameters.
   *
   * @param values numbers by the parameters' names, in their units; those set earlier are not kept
   * @throws IllegalArgumentException S-125 if a parameter cannot be set, S-126 if a value cannot be
   *     used
   */
  RunTask with(Map<String, String> values);

  /**
   * Returns the state at the start.
   *
   * @param y overwritten
   */
  void initialState(double[] y);

  /** Returns the checkpoints of the run, which are those of {@link #with} too. */
  RunCheckpoints checkpoints();

  /** Returns the processor time used so far, ns; negative if it is not known. */
  long cpuNanos();

  /** Lets others come first at the operating system where the run is not in the thread of it. */
  default void lowerPriority() {}

  /**
   * Computes.
   *
   * @param sink takes the rows
   * @param control steers and watches
   * @throws IllegalArgumentException if the settings do not fit the model
   * @throws LimitReachedException if the run needs more than it is allowed
   * @throws IOException if a row cannot be kept
   * @throws WorkerLostException if its process has ended
   */
  WorkerResult run(ResultSink sink, RunControl control) throws IOException;
}
