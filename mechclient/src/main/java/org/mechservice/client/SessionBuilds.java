package org.mechservice.client;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.NotAvailableException;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.jar.BuiltJar;
import org.mechservice.client.jar.LocalModel;
import org.mechservice.report.ModelReport;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.method.BuildRefusedException;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.MethodBuilds;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MethodNames;

/**
 * Builds the model of a session at a server with any method, for a report that runs all of them in
 * this process. Every refusal that is none of a method is the server's {@link ServiceException}.
 */
public final class SessionBuilds implements MethodBuilds {
  /** Hexadecimal digits of a hash that tell code from other code. */
  private static final int SHOWN_DIGITS = 12;

  private final MechSession session;
  private final SimulationOptions settings;
  private boolean hasBuilt;
  private boolean userClasses;

  /**
   * @param session with the model loaded
   */
  public SessionBuilds(MechSession session) {
    this(session, SimulationOptions.asInFile());
  }

  SessionBuilds(MechSession session, SimulationOptions settings) {
    this.session = session;
    this.settings = settings;
  }

  /** Writes the page about a model. {@link RemoteModel} must be usable without mechreport. */
  Path report(Path file, Path folder, Effort effort, ReportProgress progress)
      throws IOException, InterruptedException {
    return new ModelReport(this, folder, effort, progress).write(file);
  }

  /** Returns the options that choose a method. */
  public static SimulationOptions options(SimulationMethod method) {
    return options(SimulationOptions.asInFile(), method);
  }

  private static SimulationOptions options(SimulationOptions settings, SimulationMethod method) {
    SimulationOptions options =
        settings.formulation(method.formulation()).integrator(method.integrator());
    return method.closure().equals(MethodNames.NONE) ? options : options.closure(method.closure());
  }

  private LocalModel fetched(SimulationOptions options) {
    synchronized (session) {
      LocalModel model = session.fetchModel(options);
      userClasses |= model.hasUserClasses();
      return model;
    }
  }

  private BuiltJar jar(SimulationMethod method, boolean standalone) {
    synchronized (session) {
      return session.build(options(settings, method), standalone);
    }
  }

  @Override
  public String identity() {
    String file;
    synchronized (session) {
      file = session.model().sha256();
    }
    return settings.toNameValues().length == 0 ? file : file + ", " + settings;
  }

  @Override
  public Model chosen() {
    return fetched(settings.formulation(MethodNames.AUTO).integrator(MethodNames.AUTO)).newModel();
  }

  @Override
  public Candidate candidate(SimulationMethod method) throws BuildRefusedException {
    try {
      LocalModel model = fetched(options(settings, method));
      hasBuilt = true;
      return new Candidate(method, model::newModel, model.solver());
    } catch (InvalidOptionException | NotAvailableException e) {
      throw new BuildRefusedException(e);
    } catch (ServerLostException e) {
      // A build that takes too long is no reason to be silent about the other methods.
      if (!hasBuilt) {
        throw e;
      }
      throw new BuildRefusedException(e);
    }
  }

  @Override
  public Model withConstraints(SimulationMethod method) {
    return fetched(options(settings, method).columns(Set.of(ColumnGroup.CONSTRAINTS))).newModel();
  }

  @Override
  public String code(SimulationMethod method) {
    BuiltJar jar = jar(method, false);
    return jar.runtimeSha256().substring(0, SHOWN_DIGITS)
        + " "
        + jar.sha256().substring(0, SHOWN_DIGITS);
  }

  @Override
  public boolean hasUserClasses() {
    return userClasses;
  }

  @Override
  public byte[] standalone(SimulationMethod method) {
    return jar(method, true).bytes();
  }
}
