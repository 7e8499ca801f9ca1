package org.mechservice.report.measure;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import org.mechservice.report.method.Candidate;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;

/**
 * The division of a run's time: a proxy times the model's methods; its own cost per call is
 * measured and deducted.
 *
 * @param parts part of the run's time, of 1
 * @param tolerance at which
 */
public record TimeShares(Map<Part, Double> parts, double tolerance) {
  public TimeShares {
    parts = Map.copyOf(parts);
  }

  /** Parts of a run's time. */
  public enum Part {
    START_UP("start-up", ""),
    EVALUATIONS("evaluations", "derivative residual consistent"),
    JACOBIAN("Jacobian", "linearise"),
    FACTORISATION("factorisation", "factor"),
    SOLUTION("linear solution", "solve"),
    PROJECTION("closing loops", "complete project accepted"),
    OUTPUT("output", "energy power poses"),
    INTEGRATOR("integrator", "");

    private final String label;
    private final String methods;

    Part(String label, String methods) {
      this.label = label;
      this.methods = methods;
    }

    /** Returns the part's colour on the page. */
    public String css() {
      return "-" + name().toLowerCase(java.util.Locale.ROOT).replace('_', '-');
    }

    /** Returns the part's name on the page. */
    public String label() {
      return label;
    }

    static Part of(String method) {
      for (Part part : values()) {
        if (Set.of(part.methods.split(" ", -1)).contains(method)) {
          return part;
        }
      }
      return INTEGRATOR;
    }
  }

  /** Number of runs, of which the least disturbed one is used. */
  private static final int RUNS = 11;

  /** Runs a method with its model watched, several times unless that takes long. */
  public static TimeShares of(
      MethodRunner runner, Candidate candidate, double tolerance, double limitSeconds) {
    Watched best = new Watched(candidate.models().get());
    double least = Double.POSITIVE_INFINITY;
    double spent = 0;
    for (int i = 0; i < RUNS && spent < limitSeconds; i++) {
      Watched watched = new Watched(candidate.models().get());
      runner.run(watched.timed(candidate), watched.watched(), watched, tolerance, 1, limitSeconds);
      spent += watched.seconds;
      if (watched.seconds < least) {
        least = watched.seconds;
        best = watched;
      }
    }
    return new TimeShares(best.shares(least), tolerance);
  }

  /** Returns the interfaces of the solver's API, in any of its packages, that a model has. */
  static Set<Class<?>> interfaces(Class<?> model) {
    Set<Class<?>> found = new LinkedHashSet<>();
    for (Class<?> type = model; type != null; type = type.getSuperclass()) {
      collect(type, found);
    }
    return found;
  }

  private static void collect(Class<?> type, Set<Class<?>> into) {
    String api = Model.class.getPackageName() + '.';
    for (Class<?> implemented : type.getInterfaces()) {
      if (implemented.getName().startsWith(api)) {
        into.add(implemented);
      }
      collect(implemented, into);
    }
  }

  private static final class Watched extends RunControl {
    private final Model model;
    private final Map<Part, Long> nanos = new EnumMap<>(Part.class);
    private long calls;
    private int depth;
    private boolean underWay;
    private long began;
    private double seconds;

    Watched(Model model) {
      this.model = model;
    }

    /** The model, the calls of its equations timed. */
    Model watched() {
      ModelParts parts = ModelParts.of(model);
      return new ModelParts(proxy(parts.equations()), parts.events(), parts.columns());
    }

    /** A model with the same interfaces of the solver's API. */
    private Model proxy(Model inner) {
      return (Model)
          Proxy.newProxyInstance(
              Model.class.getClassLoader(),
              interfaces(inner.getClass()).toArray(Class<?>[]::new),
              (self, method, arguments) -> call(inner, method, arguments));
    }

    /**
     * The candidate with its solver timed, without what the report itself does before and after.
     * Wall-clock time, as of the parts: to ask for processor time in every call would cost more.
     */
    Candidate timed(Candidate candidate) {
      return new Candidate(
          candidate.method(),
          candidate.models(),
          (watched, request, sink, control) -> {
            began = System.nanoTime();
            RunReport report = candidate.solver().run(watched, request, sink, control);
            seconds = (System.nanoTime() - began) * 1e-9;
            return report;
          });
    }

    /** What comes before the first step is start-up, whatever is called in it. */
    @Override
    public boolean proceed(double time, double stepSize, int order, long steps) {
      if (!underWay) {
        underWay = true;
        nanos.clear();
        nanos.put(Part.START_UP, System.nanoTime() - began);
      }
      return super.proceed(time, stepSize, order, steps);
    }

    private Object call(Model inner, Method method, Object[] arguments) throws Throwable {
      long started = System.nanoTime();
      depth++;
      try {
        return method.invoke(inner, arguments);
      } catch (InvocationTargetException e) {
        throw e.getCause();
      } finally {
        if (--depth == 0) {
          calls++;
          nanos.merge(Part.of(method.getName()), System.nanoTime() - started, Long::sum);
        }
      }
    }

    Map<Part, Double> shares(double taken) {
      double perCall = costOfWatching();
      double total = Math.max(taken - calls * perCall, 0.1 * taken);
      Map<Part, Double> shares = new EnumMap<>(Part.class);
      double rest = 1;
      for (Map.Entry<Part, Long> part : nanos.entrySet()) {
        if (part.getKey() != Part.INTEGRATOR) {
          double share = Math.min(part.getValue() * 1e-9 / total, rest);
          shares.put(part.getKey(), share);
          rest -= share;
        }
      }
      shares.put(Part.INTEGRATOR, rest);
      return shares;
    }

    /** Most of the cost of a timed call lies outside the interval that it measures. */
    private double costOfWatching() {
      int trials = 20_000;
      Model watched = watched();
      long before = calls;
      Map<Part, Long> kept = new EnumMap<>(nanos);
      long started = System.nanoTime();
      for (int i = 0; i < trials; i++) {
        watched.description();
      }
      double cost = (System.nanoTime() - started) * 1e-9 / trials;
      calls = before;
      nanos.clear();
      nanos.putAll(kept);
      return 0.5 * cost;
    }
  }
}
