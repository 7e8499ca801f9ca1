package org.mechservice.client.jar;

import java.util.Optional;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.guard.UserCode;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;

/**
 * A fetched model with its solver, for callers that run it themselves, any number of times. It no
 * longer needs the server.
 */
public final class LocalModel {
  private final BuiltJar modelJar;
  private final FetchedModel fetched;

  /**
   * Loads a model.
   *
   * @param runtimeJar the solver that came with it; empty: that of this process
   * @param consent whether classes of users may run where they cannot be confined
   * @throws JarRefusedException if the JARs do not fit this client or each other, or a class uses
   *     what it must not (S-232; of a user: S-156)
   */
  public LocalModel(BuiltJar modelJar, Optional<byte[]> runtimeJar, UserCode consent) {
    this.modelJar = modelJar;
    fetched = FetchedModel.load(VerifiedJar.of(modelJar), runtimeJar, consent);
  }

  /** Returns a new instance of the model, for one run. */
  public Model newModel() {
    return fetched.newSource().model();
  }

  /** Returns a source of instances of the model, one for each run. */
  public ModelSource source() {
    return fetched.newSource();
  }

  /** Returns whether forces of it are classes of users. */
  public boolean hasUserClasses() {
    return fetched.userCode().isPresent();
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
