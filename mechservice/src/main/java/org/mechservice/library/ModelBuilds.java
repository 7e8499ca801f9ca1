package org.mechservice.library;

import java.util.function.Function;
import org.mechservice.report.method.BuildRefusedException;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.MethodBuilds;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.packaging.ModelJars;
import org.mechservice.sim.packaging.RuntimeJar;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.simulation.RuntimeSolver;

/** Builds a model in this process with any method, for its report. */
final class ModelBuilds implements MethodBuilds {
  /** Hexadecimal digits of a hash that tell code from other code. */
  private static final int SHOWN_DIGITS = 12;

  private final String identity;
  private final String sourceSha256;
  private final boolean userClasses;
  private final Function<SimulationMethod, CompiledModel> compiler;
  private final Function<SimulationMethod, CompiledModel> constrained;

  /**
   * @param identity of the model with its settings
   * @param sourceSha256 of what was read
   * @param userClasses whether forces are classes of users
   * @param compiler builds with a method
   * @param constrained builds with a method and the columns of the constraints
   */
  ModelBuilds(
      String identity,
      String sourceSha256,
      boolean userClasses,
      Function<SimulationMethod, CompiledModel> compiler,
      Function<SimulationMethod, CompiledModel> constrained) {
    this.identity = identity;
    this.sourceSha256 = sourceSha256;
    this.userClasses = userClasses;
    this.compiler = compiler;
    this.constrained = constrained;
  }

  @Override
  public String identity() {
    return identity;
  }

  @Override
  public Model chosen() {
    return compiler
        .apply(new SimulationMethod(MethodNames.AUTO, MethodNames.NONE, MethodNames.AUTO))
        .newInstance();
  }

  @Override
  public Candidate candidate(SimulationMethod method) throws BuildRefusedException {
    try {
      CompiledModel model = compiler.apply(method);
      return new Candidate(method, model::newInstance, new RuntimeSolver());
    } catch (ModelBuildException e) {
      if (e.code() == MessageCode.FORMULATION_NOT_AVAILABLE
          || e.code() == MessageCode.INTEGRATOR_NOT_AVAILABLE) {
        throw new BuildRefusedException(e);
      }
      throw e;
    }
  }

  @Override
  public Model withConstraints(SimulationMethod method) {
    return constrained.apply(method).newInstance();
  }

  @Override
  public String code(SimulationMethod method) {
    String model = ModelJars.model(compiler.apply(method), sourceSha256).sha256();
    return RuntimeJar.sha256().substring(0, SHOWN_DIGITS) + " " + model.substring(0, SHOWN_DIGITS);
  }

  @Override
  public boolean hasUserClasses() {
    return userClasses;
  }

  @Override
  public byte[] standalone(SimulationMethod method) {
    return ModelJars.standalone(compiler.apply(method), sourceSha256).bytes();
  }
}
