package org.mechservice.benchmarks.study;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Supplier;
import org.mechservice.client.MechSession;
import org.mechservice.client.SessionBuilds;
import org.mechservice.client.jar.LocalModel;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.stability.ExtremeCase;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MethodNames;

/** Scenes built by the service and runs of them, shared by all studies. */
public final class StudyContext {
  private static final String SCENES = "/org/mechservice/report/extremes/";

  /** The explicit method for open chains. */
  static final SimulationMethod EXPLICIT = new SimulationMethod("DTR", MethodNames.NONE, "ode113");

  /** The implicit method for open chains. */
  static final SimulationMethod IMPLICIT =
      new SimulationMethod("RR-JF", MethodNames.NONE, "ode15sR");

  /** Methods for scenes with loops: both ways to keep them closed, explicit and implicit. */
  static final List<SimulationMethod> WITH_LOOPS =
      List.of(
          new SimulationMethod("DSR", "projection", "ode113"),
          new SimulationMethod("DSR", "penalty", "ode113"),
          new SimulationMethod("RR-JF", "projection", "ode15sR"),
          new SimulationMethod("RR-JF", "penalty", "ode15sR"));

  private final Supplier<MechSession> sessions;
  private final boolean quick;
  private final List<ExtremeCase> cases;
  private final ReportProgress progress;

  /**
   * @param sessions opens one per scene
   * @param quick shorter runs, fewer points
   * @param cases of the suite, for studies that run them all
   */
  public StudyContext(
      Supplier<MechSession> sessions,
      boolean quick,
      List<ExtremeCase> cases,
      ReportProgress progress) {
    this.sessions = sessions;
    this.quick = quick;
    this.cases = List.copyOf(cases);
    this.progress = progress;
  }

  /** Returns the cases of the suite to run. */
  List<ExtremeCase> cases() {
    return cases;
  }

  /** Returns whether the figures are to be few. */
  boolean quick() {
    return quick;
  }

  /** Reports the progress of a study. */
  void at(String what, double done) {
    progress.at(what, done, Double.NaN);
  }

  /** Returns one of the extreme scenes as text. */
  static String scene(String file) {
    try (InputStream in = StudyContext.class.getResourceAsStream(SCENES + file)) {
      if (in == null) {
        throw new IllegalStateException("resource " + file + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Replaces a part of a scene's text that is there. */
  static String replaced(String text, String part, String by) {
    if (!text.contains(part)) {
      throw new IllegalStateException("the scene has no " + part);
    }
    return text.replace(part, by);
  }

  /** Loads a scene and does something with it. */
  <T> T with(String text, Function<MechSession, T> use) {
    return loaded("study.xml", bytes(text), (session, warnings) -> use.apply(session));
  }

  /** Loads a scene of the suite and does something with it. */
  <T> T with(ExtremeCase wanted, Function<MechSession, T> use) {
    return loaded(wanted.file(), wanted.content(), (session, warnings) -> use.apply(session));
  }

  /** Loads a scene and returns the service's warnings. */
  List<String> warnings(String text) {
    return loaded("study.xml", bytes(text), (session, warnings) -> warnings);
  }

  private <T> T loaded(String file, byte[] content, BiFunction<MechSession, List<String>, T> use) {
    try (MechSession session = sessions.get()) {
      List<String> warnings =
          session.loadModel(file, content).stream().map(String::valueOf).toList();
      return use.apply(session, warnings);
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  /** Builds a method for the scene of a session. */
  static Candidate candidate(MechSession session, SimulationMethod method) {
    LocalModel model = session.fetchModel(SessionBuilds.options(method));
    return new Candidate(method, model::newModel, model.solver());
  }

  /** Builds a method's data-driven form, which is there at once: where time is not measured. */
  static Candidate compact(MechSession session, SimulationMethod method) {
    LocalModel model = session.fetchModel(SessionBuilds.options(method).compact());
    return new Candidate(method, model::newModel, model.solver());
  }

  /**
   * Keeps the rows of a run.
   *
   * @param rows emptied when the run begins, then filled
   */
  record KeptRows(List<double[]> rows) implements ResultSink {
    @Override
    public void begin(List<Variable> columns) {
      rows.clear();
    }

    @Override
    public void row(double[] values) {
      rows.add(values.clone());
    }
  }

  /**
   * A run that has ended.
   *
   * @param report the solver's
   * @param seconds processor time, s
   * @param rows time and states at the output times
   */
  record Ran(RunReport report, double seconds, List<double[]> rows) {
    boolean completed() {
      return report.outcome() instanceof Outcome.Completed;
    }

    /** Returns how it ended, in words. */
    String ending() {
      if (report.outcome() instanceof Outcome.Failed failed) {
        String message = failed.failure().message();
        return message.length() > 120 ? message.substring(0, 117) + "…" : message;
      }
      return completed() ? "" : "not finished in time";
    }
  }

  /** Runs a method from the scene's start. */
  static Ran run(Candidate candidate, double end, double step, double tolerance, double limit) {
    return run(
        candidate.solver(),
        candidate.models().get(),
        candidate.method().integrator(),
        end,
        step,
        tolerance,
        limit);
  }

  /**
   * Runs a model.
   *
   * @param limit processor time after which it is stopped, s
   */
  static Ran run(
      Solver solver,
      Model model,
      String integrator,
      double end,
      double step,
      double tolerance,
      double limit) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    double start = model.description().defaults().tStart();
    RunSettings settings =
        new RunSettings(start, end, step, integrator, tolerance, tolerance * 0.01);
    List<double[]> rows = new ArrayList<>();
    long began = threads.getCurrentThreadCpuTime();
    RunControl control =
        new RunControl() {
          @Override
          public boolean proceed(double time, double size, int order, long steps) {
            if ((steps & 63) == 0 && (threads.getCurrentThreadCpuTime() - began) * 1e-9 > limit) {
              stop();
            }
            return super.proceed(time, size, order, steps);
          }
        };
    try {
      RunRequest request = new RunRequest(settings, Set.of(ColumnGroup.JOINTS));
      RunReport report = solver.run(model, request, new KeptRows(rows), control);
      return new Ran(report, (threads.getCurrentThreadCpuTime() - began) * 1e-9, rows);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns a number as it stands in a scene and in tables. */
  static String number(double value) {
    return String.format(Locale.ROOT, "%.0e", value).replace("e-0", "e-").replace("e+0", "e");
  }
}
