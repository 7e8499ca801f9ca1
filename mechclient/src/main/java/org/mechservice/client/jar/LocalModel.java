package org.mechservice.client.jar;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;

/**
 * A fetched model with its solver, for callers that run it themselves, any number of times. It no
 * longer needs the server.
 */
public final class LocalModel {
  private final BuiltJar modelJar;
  private final FetchedModel fetched;

  public LocalModel(BuiltJar modelJar, FetchedModel fetched) {
    this.modelJar = modelJar;
    this.fetched = fetched;
  }

  /** Returns a new instance of the model, for one run. */
  public Model newModel() {
    return fetched.newSource().model();
  }

  /** Returns the server's solver. */
  public Solver solver() {
    return fetched.solver();
  }

  /** Returns the JAR the model came in. */
  public BuiltJar jar() {
    return modelJar;
  }
}
