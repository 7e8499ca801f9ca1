package org.mechservice.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.sim.compile.ReusedCode;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.simulation.Simulation;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * A model that runs with many values of its parameters.
 *
 * <p>Code is generated once for all parameters that can be inputs of it ({@link #tunable}).
 * Parameters that masses, points or settings depend on are settled when the file is read: with
 * other values of these the model is resolved and generated again, and its numbers are put into
 * classes that are loaded already ({@link ReusedCode}); models used latest are kept, and those used
 * again have classes of their own.
 *
 * <p>Thread-safe; the bits of an outcome depend on the values of its point only.
 */
public final class PointModel implements PointEvaluation {
  private static final int MOST_VALUES = 20_000;
  private static final int MOST_NAMES = 12;
  private static final int MOST_MODELS = 64;
  private static final Pattern CODE = Pattern.compile("\\b[MNS]-\\d{3}\\b");

  private final MechModel model;
  private final Set<String> factors;
  private final Set<String> tunable;
  private final List<String> names;
  private final List<String> units;
  private final List<Reduction> single;
  private final List<Reduction> origins;
  private final List<String> reduced;
  private final ThreadLocal<Workplace> workplaces;

  /** Models with settled values, those used latest. */
  private final Map<Map<String, Double>, MechModel> models =
      new LinkedHashMap<>(MOST_MODELS, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Map<String, Double>, MechModel> eldest) {
          return size() > MOST_MODELS;
        }
      };

  /** The objects that a thread keeps between points. */
  private final class Workplace {
    final Reducer reducer = reducer();
    final ReusedCode code = new ReusedCode();
    Map<String, Double> settled = Map.of();
    List<TunableParameter> inputs = List.of();
    @Nullable ModelSource source;
    @Nullable RunRequest request;
  }

  private PointModel(
      MechModel model,
      Set<String> factors,
      Set<String> tunable,
      List<Reduction> reductions,
      List<Variable> columns) {
    this.model = model;
    this.factors = factors;
    this.tunable = tunable;
    RunSettings run = model.request().settings();
    single = new ArrayList<>();
    origins = new ArrayList<>();
    names = new ArrayList<>();
    units = new ArrayList<>();
    reduced = new ArrayList<>();
    for (Reduction reduction : reductions) {
      expand(reduction, run, columns);
    }
    if (single.size() > MOST_VALUES) {
      throw new IllegalArgumentException(
          "the outputs have "
              + single.size()
              + " values for each point; at most "
              + MOST_VALUES
              + " are kept: write a distance of the series, such as series(x, 0.1)");
    }
    workplaces = ThreadLocal.withInitial(Workplace::new);
  }

  private void expand(Reduction reduction, RunSettings run, List<Variable> columns) {
    if (!reduction.isOfAll()) {
      expand(reduction, reduction, run, columnOf(reduction, columns));
      return;
    }
    for (Variable column : columns.subList(1, columns.size())) { // the first is the time
      Reduction one = new Reduction(column.name(), reduction.kind(), reduction.argument());
      expand(reduction, one, run, column);
    }
  }

  private void expand(Reduction origin, Reduction reduction, RunSettings run, Variable column) {
    if (!reduction.fits(run.tStart(), run.tEnd())) {
      throw new IllegalArgumentException(
          reduction
              + " is outside the run, which is from "
              + run.tStart()
              + " s to "
              + run.tEnd()
              + " s");
    }
    if (reduction.kind() != Reduction.Kind.SERIES) {
      add(origin, reduction, reduction.toString(), column.unit());
      return;
    }
    double distance = Double.isNaN(reduction.argument()) ? run.tStep() : reduction.argument();
    double count = Math.floor((run.tEnd() - run.tStart()) / distance * (1 + 1e-12));
    for (int i = 0; i <= Math.min(count, MOST_VALUES); i++) {
      double time = Math.min(run.tEnd(), run.tStart() + i * distance);
      Reduction one = new Reduction(reduction.column(), Reduction.Kind.AT, time);
      add(origin, one, reduction.column() + "@" + ShortestDecimal.format(time), column.unit());
    }
  }

  private void add(Reduction origin, Reduction one, String name, String unit) {
    origins.add(origin);
    single.add(one);
    reduced.add(one.column());
    names.add(name);
    units.add(
        switch (one.kind()) {
          case CROSSING -> "s";
          case INTEGRAL -> unit.equals("1") ? "s" : unit + "·s";
          case LAST, AT, MIN, MAX, MEAN, RMS, SERIES -> unit;
        });
  }

  private static Variable columnOf(Reduction reduction, List<Variable> columns) {
    return columns.stream()
        .filter(c -> c.name().equals(reduction.column()))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(unknown(reduction.column(), columns)));
  }

  private static String unknown(String name, List<Variable> columns) {
    List<String> known = columns.stream().map(Variable::name).toList();
    return "the model has no column \""
        + name
        + '"'
        + NearestName.suggestion(name, known)
        + "; it has "
        + known.stream().limit(MOST_NAMES).collect(Collectors.joining(", "))
        + (known.size() > MOST_NAMES ? " and " + (known.size() - MOST_NAMES) + " more" : "");
  }

  /**
   * Takes a model that has been read.
   *
   * @param factors parameters that points set
   * @param reductions what is kept of each run; columns of groups that the simulation does not put
   *     out are added
   * @throws MechmlException if it cannot be used
   * @throws IllegalArgumentException if it has no such parameter or column
   */
  public static PointModel of(MechModel read, List<String> factors, List<Reduction> reductions)
      throws MechmlException {
    List<String> known = read.parameters().stream().map(ModelParameter::name).toList();
    for (String factor : factors) {
      if (!known.contains(factor)) {
        throw new IllegalArgumentException(
            "the model has no parameter \""
                + factor
                + '"'
                + NearestName.suggestion(factor, known)
                + (known.isEmpty() ? "" : "; it has " + String.join(", ", known)));
      }
    }
    ModelInputs inputs = ModelInputs.of(withColumns(read, reductions), factors);
    return new PointModel(
        inputs.model(),
        new LinkedHashSet<>(factors),
        inputs.names(),
        reductions,
        columnsOf(inputs.model()));
  }

  private static MechModel withColumns(MechModel model, List<Reduction> reductions) {
    List<String> shown = columnsOf(model).stream().map(Variable::name).toList();
    if (reductions.stream().allMatch(r -> r.isOfAll() || shown.contains(r.column()))) {
      return model;
    }
    Set<ColumnGroup> groups = new LinkedHashSet<>(model.columns());
    MechModel more = model;
    for (ColumnGroup group : ColumnGroup.values()) {
      groups.add(group);
      more = model.columns(groups.toArray(ColumnGroup[]::new));
      List<String> now = columnsOf(more).stream().map(Variable::name).toList();
      if (reductions.stream().allMatch(r -> r.isOfAll() || now.contains(r.column()))) {
        return more;
      }
    }
    return more;
  }

  private static List<Variable> columnsOf(MechModel model) {
    return Simulation.columns(model.instances().model(), model.request().columns());
  }

  /** Returns the names of the values of an outcome: {@code max(x)}; {@code x@0.5} of a series. */
  public List<String> names() {
    return List.copyOf(names);
  }

  /** Returns the reductions that the values of an outcome belong to: a series has several. */
  public List<Reduction> origins() {
    return List.copyOf(origins);
  }

  /** Returns the columns that the values of an outcome are taken from. */
  public List<String> columns() {
    return List.copyOf(reduced);
  }

  /** Returns the SI units of the values of an outcome, {@code 1} for a pure number. */
  public List<String> units() {
    return List.copyOf(units);
  }

  /** Returns the factors that are inputs of the code; the others cost a build for each value. */
  public Set<String> tunable() {
    return Set.copyOf(tunable);
  }

  /** Returns the model with its file's values of the factors. */
  public MechModel model() {
    return model;
  }

  /** Returns what makes the values of an outcome from the rows of runs, of this model anywhere. */
  public Reducer reducer() {
    return new Reducer(single);
  }

  @Override
  public PointOutcome run(Map<String, Double> parameters) throws IOException {
    for (Map.Entry<String, Double> parameter : parameters.entrySet()) {
      if (!factors.contains(parameter.getKey())) {
        throw new IllegalArgumentException(
            "\"" + parameter.getKey() + "\" is none of the factors " + String.join(", ", factors));
      } else if (!Double.isFinite(parameter.getValue())) {
        return new PointOutcome.Failed(
            MessageCode.PARAMETER_NOT_A_NUMBER.code(),
            "parameter \"" + parameter.getKey() + "\" is " + parameter.getValue(),
            Double.NaN);
      }
    }
    Workplace place = workplaces.get();
    try {
      prepare(place, parameters);
      return simulated(place, parameters);
    } catch (MechmlException e) {
      Diagnostic first =
          e.diagnostics().stream()
              .filter(d -> d.severity() == Severity.ERROR)
              .findFirst()
              .orElse(e.diagnostics().get(0));
      return new PointOutcome.Failed(
          first.code().code(), PointOutcome.Failed.oneLine(first.message()), Double.NaN);
    } catch (IllegalArgumentException e) {
      String text = PointOutcome.Failed.oneLine(String.valueOf(e.getMessage()));
      Matcher code = CODE.matcher(text);
      if (!code.find()) {
        throw e;
      }
      return new PointOutcome.Failed(code.group(), text, Double.NaN);
    }
  }

  private void prepare(Workplace place, Map<String, Double> parameters) throws MechmlException {
    Map<String, Double> settled = Map.of();
    if (!tunable.containsAll(parameters.keySet())) {
      settled = new TreeMap<>(parameters);
      settled.keySet().removeAll(tunable);
    }
    if (place.source == null || !settled.equals(place.settled)) {
      place.source = null;
      Optional<MechModel> known = settled.isEmpty() ? Optional.of(model) : known(settled);
      MechModel here = known.isPresent() ? known.get() : made(settled);
      place.request = here.request();
      place.settled = settled;
      ModelSource source = known.isPresent() ? here.instances() : here.instances(place.code);
      place.inputs = source.parameters();
      place.source = source;
    }
  }

  /**
   * Returns the model with settled values that a point has had before, one of those used latest.
   */
  private Optional<MechModel> known(Map<String, Double> settled) {
    synchronized (models) {
      return Optional.ofNullable(models.get(settled));
    }
  }

  /** Returns the model with settled values. */
  private MechModel made(Map<String, Double> settled) throws MechmlException {
    MechModel made = model.set(settled);
    synchronized (models) {
      models.put(settled, made);
    }
    return made;
  }

  private PointOutcome simulated(Workplace place, Map<String, Double> parameters)
      throws IOException {
    ModelSource source = place.source;
    RunRequest request = place.request;
    if (source == null || request == null) {
      throw new IllegalStateException("prepare comes first");
    }
    List<TunableParameter> inputs = place.inputs;
    double[] values = new double[inputs.size()];
    Arrays.setAll(
        values, i -> parameters.getOrDefault(inputs.get(i).name(), inputs.get(i).value()));
    RunReport report =
        new RuntimeSolver()
            .run(
                values.length == 0 ? source.model() : source.model(values),
                request,
                place.reducer,
                new RunControl());
    if (report.outcome() instanceof Outcome.Failed failed) {
      return PointOutcome.Failed.of(failed.failure());
    }
    return new PointOutcome.Values(place.reducer.values());
  }
}
