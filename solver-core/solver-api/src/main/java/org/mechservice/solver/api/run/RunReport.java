package org.mechservice.solver.api.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.mechservice.solver.catalogue.Accuracy;

/**
 * The report of a run: its outcome, its counts and its notes.
 *
 * @param outcome its outcome
 * @param model name of the model
 * @param formulation formulation of the equations, such as {@code DTR}
 * @param settings the settings used, with all automatic choices resolved
 * @param steps accepted steps
 * @param rejectedSteps steps that failed the error test
 * @param evaluations evaluations of the right-hand side
 * @param rows result rows written
 * @param timeReached simulated time at the end of the run, s
 * @param wallTime wall-clock time of the run, s
 * @param energyDrift largest |E(t) − E(0)| at the output times, J; empty if the energy is not
 *     constant or not known
 * @param energyScale the largest of kinetic energy, change of potential energy, and the mean of
 *     added and removed energy, J; the reference of the drift
 * @param stiffnessSuspected whether stability, not accuracy, kept many successive steps small, and
 *     {@link Stiffness} calls the motion stiff
 * @param jacobians Jacobians formed; 0, like the next, for explicit integrators
 * @param factorisations matrices factored
 * @param limits states that caused rejected steps, most frequent first
 * @param notes notes about the run
 * @param solverVersion version of the solver that ran
 */
public record RunReport(
    Outcome outcome,
    String model,
    String formulation,
    RunSettings settings,
    long steps,
    long rejectedSteps,
    long evaluations,
    long rows,
    double timeReached,
    double wallTime,
    OptionalDouble energyDrift,
    OptionalDouble energyScale,
    boolean stiffnessSuspected,
    long jacobians,
    long factorisations,
    List<Limit> limits,
    List<RunNotes.Note> notes,
    String solverVersion) {

  /** Largest number of states named in the report. */
  private static final int MOST_LIMITS = 5;

  public RunReport {
    limits = List.copyOf(limits);
    notes = List.copyOf(notes);
  }

  /**
   * Number of steps rejected because of a state.
   *
   * @param state its name
   * @param inaccurate number of steps in which its error was the largest
   * @param unsolved number of steps in which the implicit equations failed because of it, or it was
   *     not finite
   */
  public record Limit(String state, long inaccurate, long unsolved) {
    @Override
    public String toString() {
      String error = inaccurate == 0 ? "" : " error " + inaccurate;
      return state + error + (unsolved == 0 ? "" : " equations " + unsolved);
    }
  }

  /** Creates the report of a run with an explicit integrator and without notes. */
  public RunReport(
      Outcome outcome,
      String model,
      String formulation,
      RunSettings settings,
      long steps,
      long rejectedSteps,
      long evaluations,
      long rows,
      double timeReached,
      double wallTime,
      OptionalDouble energyDrift,
      OptionalDouble energyScale,
      boolean stiffnessSuspected,
      String solverVersion) {
    this(
        outcome,
        model,
        formulation,
        settings,
        steps,
        rejectedSteps,
        evaluations,
        rows,
        timeReached,
        wallTime,
        energyDrift,
        energyScale,
        stiffnessSuspected,
        0,
        0,
        List.of(),
        List.of(),
        solverVersion);
  }

  /** Returns the report with a note after its others. */
  public RunReport with(RunNotes.Note note) {
    List<RunNotes.Note> all = new ArrayList<>(notes);
    all.add(note);
    return with(outcome, all);
  }

  /** Returns the report with another outcome and other notes. */
  public RunReport with(Outcome other, List<RunNotes.Note> notes) {
    return new RunReport(
        other,
        model,
        formulation,
        settings,
        steps,
        rejectedSteps,
        evaluations,
        rows,
        timeReached,
        wallTime,
        energyDrift,
        energyScale,
        stiffnessSuspected,
        jacobians,
        factorisations,
        limits,
        notes,
        solverVersion);
  }

  /**
   * Returns the report as ordered key and value pairs, values being {@link String}, {@link Long} or
   * {@link Double}; entries that do not apply to the run are absent; each note is on one line.
   * Times in s, energies in J. This is the content of the report's JSON form.
   */
  public Map<String, Object> asMap() {
    Map<String, Object> map = new LinkedHashMap<>();
    map.put("scene", model);
    if (outcome instanceof Outcome.Failed failed) {
      map.put("outcome", "failed");
      map.put("failure", failed.failure().message());
      List<Failure.Step> steps = failed.failure().lastSteps();
      if (!steps.isEmpty()) {
        map.put(
            "lastSteps", String.join("\n", steps.stream().map(Failure.Step::toString).toList()));
      }
    } else {
      map.put("outcome", outcome instanceof Outcome.Stopped ? "stopped" : "completed");
    }
    map.put("formulation", formulation);
    map.put("integrator", settings.integrator());
    map.put("relativeTolerance", settings.relativeTolerance());
    map.put("absoluteTolerance", settings.absoluteTolerance());
    if (!settings.hasOneTolerance()) {
      map.put("angleTolerance", settings.angleTolerance());
      map.put("velocityTolerance", settings.velocityTolerance());
      map.put("angularVelocityTolerance", settings.angularVelocityTolerance());
    }
    if (settings.accuracy() != Accuracy.STANDARD) {
      map.put(Accuracy.OPTION, settings.accuracy().label());
    }
    map.put("steps", steps);
    map.put("rejectedSteps", rejectedSteps);
    map.put("evaluations", evaluations);
    if (factorisations > 0) {
      map.put("jacobians", jacobians);
      map.put("factorisations", factorisations);
    }
    map.put("rows", rows);
    map.put("simulatedTime", timeReached - settings.tStart());
    map.put("wallTime", wallTime);
    if (wallTime > 0) {
      map.put("realTimeFactor", (timeReached - settings.tStart()) / wallTime);
    }
    energyDrift.ifPresent(drift -> map.put("energyDrift", drift));
    energyScale.ifPresent(scale -> map.put("energyScale", scale));
    if (stiffnessSuspected) {
      map.put("stiffness", "suspected");
    }
    if (!limits.isEmpty()) {
      map.put(
          "rejectedBy",
          String.join(", ", limits.stream().limit(MOST_LIMITS).map(Limit::toString).toList()));
    }
    if (!notes.isEmpty()) {
      map.put("notes", String.join("\n", notes.stream().map(RunNotes.Note::message).toList()));
    }
    map.put("solverVersion", solverVersion);
    return map;
  }
}
