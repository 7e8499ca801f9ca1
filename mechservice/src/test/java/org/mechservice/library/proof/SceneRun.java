package org.mechservice.library.proof;

import java.io.IOException;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.ToDoubleFunction;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.program.RowMemory;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.simulation.RuntimeSolver;

/**
 * A scene, run.
 *
 * @param scene the scene
 * @param verdict what came of it
 * @param error largest error, where 1 is the largest that is right
 * @param said codes of the warnings and of the failure; empty if there is none
 * @param detail the values
 */
record SceneRun(Scene scene, Verdict verdict, double error, String said, String detail) {
  /** Runs a scene. */
  static SceneRun of(Scene scene) throws IOException, MechmlException {
    MechModel model = MechModel.of("m.xml", scene.text());
    TreeSet<String> said = new TreeSet<>();
    Optional<Trajectory> rows;
    try {
      Trajectory motion = scene.method().compact() ? compact(model) : model.simulate();
      rows = Optional.of(motion);
      for (RunNotes.Note note : motion.report().notes()) {
        if (note.warning()) {
          said.add(note.code().toString());
        }
      }
    } catch (RunFailedException e) {
      rows = Optional.empty();
      said.add(e.failure().code().toString());
    }
    Optional<Trajectory> found = rows;
    return judged(
        scene,
        column -> found.map(r -> r.column(column)[r.rows() - 1]).orElse(Double.NaN),
        found.map(r -> r.report().steps()).orElse(0L),
        said);
  }

  /** Judges the end of a run whose steps are not known. */
  static SceneRun judged(Scene scene, ToDoubleFunction<String> ends, SortedSet<String> said) {
    return judged(scene, ends, 0, said);
  }

  /**
   * Judges the end of a run.
   *
   * @param ends values of the last row by column; NaN if there is none
   * @param steps steps of the run, 0 if they are not known
   * @param said codes of warnings and failures
   */
  private static SceneRun judged(
      Scene scene, ToDoubleFunction<String> ends, long steps, SortedSet<String> said) {
    double worst = 0;
    StringBuilder detail = new StringBuilder();
    for (Expected expected : scene.expected()) {
      double actual = ends.applyAsDouble(expected.column());
      double error = expected.error(actual, steps);
      worst = Math.max(worst, error);
      detail.append(
          "%s = %.9g, right %.9g, bound %.1e; "
              .formatted(expected.column(), actual, expected.value(), expected.bound(steps)));
    }
    Verdict verdict = worst <= 1 ? Verdict.RIGHT : said.isEmpty() ? Verdict.SILENT : Verdict.TOLD;
    return new SceneRun(scene, verdict, worst, String.join(" ", said), detail.toString());
  }

  /** Runs a model that consists of data in place of generated code. */
  private static Trajectory compact(MechModel model) throws IOException {
    String formulation = model.content().settings().formulation();
    BuildOptions options =
        new BuildOptions(
            formulation,
            model.content().settings().closure(),
            true,
            CodeForm.AUTO,
            model.columns(),
            model.request().settings(),
            Optional.empty());
    CompiledModel compiled =
        ModelFactory.compile(
            model.content(),
            options,
            ModelFactory.generate(model.content(), options),
            org.mechservice.sim.user.UserClasses.NONE);
    RowMemory rows = new RowMemory();
    RunReport report =
        new RuntimeSolver()
            .run(compiled.newInstance(), model.request(), rows, new RunControl(), Checkpoints.NONE);
    Trajectory trajectory = new Trajectory(rows, report);
    if (report.outcome() instanceof Outcome.Failed) {
      RunFailedException.throwIfFailed(report, Optional.of(trajectory));
    }
    return trajectory;
  }
}
