package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.mechservice.client.MechSession;
import org.mechservice.client.SessionBuilds;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.jar.LocalModel;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.MethodList;
import org.mechservice.report.method.ModelProblem;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.PublishedReference;
import org.mechservice.report.solution.ReferenceMaker;
import org.mechservice.report.solution.RunGrid;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.ExplicitModel;

/** Cost of the automatic choice beside that of the best fixed one, on stiff scenes and others. */
final class AutoStudy implements MethodStudy {
  /**
   * With gaps of two decades, an error just missed cost a method two decades more. To 1e-10, for an
   * implicit method may err by some hundred times its tolerance and be the cheapest all the same.
   */
  private static final double[] TOLERANCES = {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

  private static final int REPEATS = 11;

  /** Runs that tell which methods are worth all repeats. */
  private static final int SORTING = 3;

  /**
   * Processor time of each method before it is timed, s. Chains of five bars reach their final cost
   * within 0.6 s; after 5 runs of 5 ms they cost three times as much, and which of two methods with
   * the same steps was compiled first decided between them.
   */
  private static final double WARM = 1;

  /** A cost that another is below by this factor is not the best. */
  private static final double SEVERAL = 2;

  /** A run of this time is timed once, s. */
  private static final double LONG = 0.3;

  private final StudyContext context;
  private final double limit;
  private final WarmTimes warmTimes;

  AutoStudy(StudyContext context) {
    this.context = context;
    warmTimes = new WarmTimes(context.quick() ? WARM / 5 : WARM, LONG);
    limit = context.quick() ? 1 : 2;
  }

  @Override
  public String name() {
    return "auto";
  }

  @Override
  public void measure(StudyPage page) {
    page.title("The automatic choice beside the best fixed one");
    page.notes(
        "Every method that fits, and auto, at tolerances 1e-4, 1e-5 … 1e-10; cost: the least"
            + " processor time, median of %d runs in turns, of a run whose error is at most the one"
            + " wanted. Each method has run for %.1f s before. Runs are stopped after %.0f s.",
        REPEATS, warmTimes.warmSeconds(), limit);
    StudyPage.Table table =
        page.table(
            "Costs",
            "scene",
            "error wanted",
            "auto chose",
            "ms",
            "error",
            "best fixed",
            "ms",
            "error",
            "auto ÷ best");
    Map<String, String> scenes = new TreeMap<>();
    for (String stiff :
        List.of(
            "stiff_1e9_c1e5",
            "spring_1e12_critical",
            "spring_1e12_far_over_critical",
            "spring_1e6_far_over_critical",
            "rtol_1e-2",
            "origin_1e6")) {
      scenes.put(stiff, StudyContext.scene(stiff + ".xml"));
    }
    scenes.put("chain, stiff", new BarChain(5, 1, 1, 1e4, 1e4, 0.05, 1).text());
    scenes.put("chain of 40, stiff", new BarChain(40, 1, 1, 1e4, 1e4, 0.05, 1).text());
    scenes.put("chain, soft", new BarChain(5, 1, 1, 0, 0, 0.3, 1).text());
    scenes.put("chain, undamped", new BarChain(5, 1, 1, 1e4, 0, 0.05, 1).text());
    scenes.putAll(TransientStiffness.scenes());
    double worst = 0;
    String worstScene = "";
    int compared = 0;
    for (Map.Entry<String, String> scene : scenes.entrySet()) {
      context.at(scene.getKey(), (double) compared++ / scenes.size());
      double ratio = context.with(scene.getValue(), s -> compare(table, scene.getKey(), s));
      if (ratio > worst) {
        worst = ratio;
        worstScene = scene.getKey();
      }
    }
    page.finds(
        "auto costs at most %.2f times the best fixed choice (%s); 1.5 is the bound.",
        worst, worstScene);
  }

  /** A method at a tolerance, timed. */
  private record Cost(Candidate candidate, double tolerance, MeasuredRun first, double seconds) {}

  private double compare(StudyPage.Table table, String scene, MechSession session) {
    LocalModel chosen =
        session.fetchModel(
            SimulationOptions.asInFile().formulation("auto").closure("auto").integrator("auto"));
    ModelDescription description = chosen.newModel().description();
    String closure = "auto";
    SimulationMethod name =
        new SimulationMethod(
            description.formulation(), closure, description.defaults().integrator());
    Candidate auto = new Candidate(name, chosen::newModel, chosen.solver());
    List<Candidate> fixed = MethodList.of(new SessionBuilds(session)).candidates();
    Judge judge = judge(fixed);
    if (judge.reference().isEmpty()) {
      table.row(scene, "", judge.doubt(), "", "", "", "", "", "");
      return 0;
    }
    StateDistance distance = new StateDistance(description);
    List<Cost> costs = new ArrayList<>();
    try (MethodRunner runner =
        new MethodRunner(judge.reference().orElseThrow(), distance, judge.grid())) {
      List<Candidate> all = new ArrayList<>(fixed);
      all.add(auto);
      for (Candidate candidate : all) {
        for (double tolerance : TOLERANCES) {
          MeasuredRun run = runner.run(candidate, tolerance, 0, limit);
          if (run.completed()) {
            costs.add(new Cost(candidate, tolerance, run, run.seconds()));
          }
        }
      }
      costs = timed(runner, costs, auto);
    }
    double worst = 0;
    for (double error : new double[] {1e-3, 1e-5, 1e-7}) {
      worst = Math.max(worst, line(table, scene, error, costs, auto));
    }
    return worst;
  }

  private List<Cost> timed(MethodRunner runner, List<Cost> costs, Candidate auto) {
    warmTimes.warm(runs(runner, costs));
    List<Cost> warm = timed(runner, costs, SORTING);
    List<Cost> near = warm.stream().filter(cost -> mayBeBest(cost, warm, auto)).toList();
    return timed(runner, near, REPEATS);
  }

  /**
   * Returns whether a method may be the best one; one that costs several times another of at most
   * its error needs no exact timing.
   */
  private static boolean mayBeBest(Cost cost, List<Cost> all, Candidate auto) {
    double error = cost.first().errors().largest();
    double least =
        all.stream()
            .filter(other -> other.first().errors().largest() <= error)
            .mapToDouble(Cost::seconds)
            .min()
            .orElseThrow();
    return cost.candidate().equals(auto) || cost.seconds() <= SEVERAL * least;
  }

  private List<Cost> timed(MethodRunner runner, List<Cost> costs, int repeats) {
    List<Double> seconds = warmTimes.medians(runs(runner, costs), repeats);
    List<Cost> timed = new ArrayList<>();
    for (int i = 0; i < costs.size(); i++) {
      Cost cost = costs.get(i);
      timed.add(new Cost(cost.candidate(), cost.tolerance(), cost.first(), seconds.get(i)));
    }
    return timed;
  }

  private List<WarmTimes.Run> runs(MethodRunner runner, List<Cost> costs) {
    return costs.stream()
        .map(
            cost ->
                new WarmTimes.Run(
                    cost.candidate(),
                    () -> runner.run(cost.candidate(), cost.tolerance(), 1, limit).seconds()))
        .toList();
  }

  private static double line(
      StudyPage.Table table, String scene, double error, List<Cost> costs, Candidate auto) {
    Optional<Cost> ours = cheapest(costs, error, auto, true);
    Optional<Cost> best = cheapest(costs, error, auto, false);
    if (best.isEmpty()) {
      return 0;
    }
    double ratio =
        ours.map(cost -> cost.seconds() / best.get().seconds()).orElse(Double.POSITIVE_INFINITY);
    table.row(
        scene,
        error,
        auto.method().formulation() + " " + auto.method().integrator(),
        ours.map(cost -> 1e3 * cost.seconds()).orElse(Double.NaN),
        ours.map(cost -> cost.first().errors().largest()).orElse(Double.NaN),
        best.get().candidate().method().name(),
        1e3 * best.get().seconds(),
        best.get().first().errors().largest(),
        ratio);
    return ratio;
  }

  private static Optional<Cost> cheapest(
      List<Cost> costs, double error, Candidate auto, boolean ofAuto) {
    return costs.stream()
        .filter(cost -> cost.candidate().equals(auto) == ofAuto)
        .filter(cost -> cost.first().errors().largest() <= error)
        .min(java.util.Comparator.comparingDouble(Cost::seconds));
  }

  private Judge judge(List<Candidate> candidates) {
    ExplicitModel model = candidates.get(0).equations();
    StateDistance distance = new StateDistance(model.description());
    double end = model.description().defaults().tEnd();
    double[] start = new ModelProblem(model).start();
    Optional<PublishedReference> published =
        PublishedReference.of(model.description().name(), start, end, distance);
    if (published.isPresent() && RunGrid.meeting(published.get().times()).isPresent()) {
      return Judge.trusting(published.get());
    }
    List<ReferenceMaker.Source> sources =
        List.of(new ReferenceMaker.Source("DTR", () -> candidates.get(0).problem()));
    return Judge.of(
        Optional.empty(),
        sources,
        new ReferenceMaker(distance, context.quick() ? 5 : 60),
        distance,
        RunGrid.uniform(0, end, 20));
  }
}
