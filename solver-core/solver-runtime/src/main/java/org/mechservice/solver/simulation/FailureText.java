package org.mechservice.solver.simulation;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.TrialOutcome;

/** Words the failures of runs in terms of mechanics. */
final class FailureText {
  /** Result of a step whose error was too large. */
  static final String TOO_INACCURATE = "error too large";

  /** Spacing of floating-point times, s, above which steps cannot be short. */
  private static final double COARSE = 1e-10;

  /** The way in which an implicit step on the residual closes loops. */
  enum ImplicitLoops {
    /** There are none, or the equations are explicit. */
    NONE,
    /** It solves for independent coordinates; others are completed from them. */
    PROJECTION,
    /** It solves for all coordinates and multipliers. */
    PENALTY;

    static ImplicitLoops of(Model model) {
      if (!(model instanceof ResidualModel)) {
        return NONE;
      }
      return model instanceof DependentStates
          ? PROJECTION
          : model instanceof ProjectedStates ? PENALTY : NONE;
    }
  }

  private FailureText() {}

  /**
   * Explains a failure of the integrator.
   *
   * @param singularJoint joint at which the inertia was singular in the last evaluation, or {@link
   *     ExplicitModel#REGULAR}
   * @param event the event it may lie at; empty if none can be named
   * @param motion motion of the state that keeps steps short, followed by a space; empty if unknown
   * @param loops how an implicit step on the residual closes loops
   * @param integrator label of the method that runs, which is not advised
   */
  static Failure of(
      IntegrationFailure failure,
      ModelDescription model,
      int singularJoint,
      String event,
      String motion,
      ImplicitLoops loops,
      String integrator) {
    return switch (failure.cause()) {
      case NOT_FINITE ->
          singularJoint == ExplicitModel.REGULAR
              ? failure(
                  MessageCode.NOT_FINITE,
                  "The accelerations are not finite.",
                  failure,
                  state(model, failure.worstComponent()),
                  "Check masses, inertias and forces for values that are zero, huge or opposite.")
              : singularInertia(
                  failure.time(), failure.stepSize(), failure.order(), model, singularJoint);
      case STEP_TOO_SMALL ->
          failure(
              MessageCode.STEP_TOO_SMALL,
              "The error test fails at every step size.",
              failure,
              state(model, failure.worstComponent()),
              Math.ulp(failure.time()) > COARSE
                  ? "The spacing of numbers near this time is too coarse for steps: start the run"
                      + " near t = 0."
                  : motion
                      + (loops == ImplicitLoops.PENALTY
                          ? "By penalty, velocities keep rounding errors of the loops, which shorter"
                              + " steps do not reduce: if the absolute tolerance is finer, loosen it,"
                              + " or use closure projection or DSR. Otherwise check the forces on"
                              + " this joint."
                          : "The motion is singular"
                              + (isExplicit(integrator)
                                  ? " or very stiff there; use ode15s,"
                                  : " there;")
                              + " loosen the tolerances, or check the forces on this joint."));
      case UNBOUNDED ->
          failure(
              MessageCode.STEP_TOO_SMALL,
              "The solution grows beyond every bound within the next step.",
              failure,
              state(model, failure.worstComponent()),
              "A force is divided by a quantity that becomes zero; end the run earlier, or bound"
                  + " the forces on this joint.");
      case TOLERANCE_TOO_TIGHT ->
          failure(
              MessageCode.TOLERANCE_TOO_TIGHT,
              "The tolerances require more digits than double precision has.",
              failure,
              state(model, failure.worstComponent()),
              "Loosen the relative or the absolute tolerance.");
      case NO_CONVERGENCE ->
          failure(
              MessageCode.NEWTON_DIVERGES,
              "The equations of an implicit step cannot be solved at any step size.",
              failure,
              state(model, failure.worstComponent()),
              motion + unsolvable(loops));
      case SINGULAR_MATRIX ->
          failure(
              MessageCode.SINGULAR_ITERATION_MATRIX,
              "The matrix of an implicit step is singular at every step size.",
              failure,
              state(model, failure.worstComponent()),
              "Check the stiffness and damping of the forces on this joint.");
      case INCONSISTENT_START ->
          failure(
              MessageCode.NO_CONSISTENT_INITIAL_VALUES,
              "No accelerations and multipliers satisfy the equations at the start.",
              failure,
              state(model, failure.worstComponent()),
              "Check the initial state, masses and inertias, and contradictory constraints.");
      case NOT_COMPLETED ->
          failure(
              MessageCode.LOOPS_NOT_CLOSED,
              "The loops cannot be closed at any step size: there is no position for the"
                  + " independent coordinates.",
              failure,
              "",
              "The mechanism locks or branches there; check its dimensions, or end the run"
                  + " before.");
      case EVENTS_ACCUMULATE ->
          failure(
              MessageCode.EVENTS_ACCUMULATE,
              "The intervals between events become ever shorter.",
              failure,
              event,
              "End the run before, or stop the changes of the state: a bounce below a certain"
                  + " speed, a switch without hysteresis.");
      case EVENT_NOT_FINITE ->
          failure(
              MessageCode.EVENT_FUNCTION_NOT_FINITE,
              "A quantity whose change of sign is an event is not finite.",
              failure,
              event,
              "Check the expressions of the model's events.");
      case TOO_MANY_STEPS ->
          failure(
              MessageCode.TOO_MANY_STEPS,
              "The number of steps is exhausted: the end is more than 1e11 steps away.",
              failure,
              state(model, failure.worstComponent()),
              motion
                  + "Lower the stiffness or frequency of the forces on this joint, add damping"
                  + (isExplicit(integrator) ? " and use ode15s" : "")
                  + ", allow longer steps, or end the run earlier.");
    };
  }

  /** Returns whether a method takes explicit steps only, which stiff motions keep short. */
  private static boolean isExplicit(String integrator) {
    return IntegrationMethod.find(integrator)
        .filter(method -> method.family() == IntegrationMethod.Family.ADAMS)
        .isPresent();
  }

  /** Returns the advice where an implicit step cannot be solved. */
  private static String unsolvable(ImplicitLoops loops) {
    return switch (loops) {
      case NONE ->
          "Look for a force that jumps or has a vertical slope there; tighten the tolerances if it"
              + " does not.";
      case PROJECTION ->
          "By projection the iteration is over independent coordinates; where the dependent ones"
              + " move far more inertia, as in long chains, it diverges at large forces: use"
              + " closure penalty, or DSR. In short loops look for a force that jumps or has a"
              + " vertical slope there.";
      case PENALTY ->
          "By penalty the iteration may fail on the way to a position in which the loops lose rank,"
              + " and where alpha is below its default of 1e7: use that, closure projection, or"
              + " DSR. Otherwise look for a force that jumps or has a vertical slope there.";
    };
  }

  /** Returns the last attempted steps. */
  static List<Failure.Step> steps(IntegrationFailure failure) {
    return failure.lastSteps().stream()
        .map(
            s ->
                new Failure.Step(
                    s.time(), s.stepSize(), s.order(), s.error(), outcomeText(s.attempt())))
        .toList();
  }

  private static String outcomeText(TrialOutcome attempt) {
    return switch (attempt) {
      case PASSED -> "accepted";
      case TOO_INACCURATE -> TOO_INACCURATE;
      case NOT_CONVERGING -> Failure.Step.UNSOLVED;
      case SINGULAR_MATRIX -> "its matrix was singular";
      case NOT_COMPLETED -> "the loops could not be closed";
      case NOT_FINITE -> "a value was not finite";
      case STOPPED -> "stopped";
    };
  }

  /** Returns whether the steps were short until the failure. */
  static boolean staysShort(IntegrationFailure.Cause cause) {
    return switch (cause) {
      case STEP_TOO_SMALL, NO_CONVERGENCE, TOO_MANY_STEPS -> true;
      default -> false;
    };
  }

  /** Returns whether a failure can come from loops that lock, branch or stay open. */
  static boolean mayLieInLoops(IntegrationFailure.Cause cause) {
    return switch (cause) {
      case NOT_FINITE,
          STEP_TOO_SMALL,
          UNBOUNDED,
          TOLERANCE_TOO_TIGHT,
          NO_CONVERGENCE,
          SINGULAR_MATRIX,
          NOT_COMPLETED ->
          true;
      default -> false;
    };
  }

  /** Explains an output time at which dependent coordinates were not found. */
  static Failure loopsOpen(double t) {
    return new Failure(
        MessageCode.LOOPS_NOT_CLOSED,
        "The loops cannot be closed at this output time.",
        t,
        0,
        0,
        "",
        "Tighten the tolerances; the mechanism may branch there.");
  }

  /** Explains a warning that ends a strict run. */
  static Failure ofStrict(RunNotes.Note warning) {
    return new Failure(
        warning.code(),
        warning.text(),
        warning.time(),
        0,
        0,
        "",
        "The run is strict, so this warning ends it; leave out --strict to continue in spite of"
            + " warnings.");
  }

  /**
   * Explains a run whose energy drifts.
   *
   * @param limiting the state that made steps be rejected most often; empty if none was
   * @param stiff whether stability, not accuracy, keeps the steps small
   */
  static Failure energyDrifts(
      double t,
      Integrator integrator,
      EnergyMonitor energy,
      double bound,
      RunSettings settings,
      Optional<String> limiting,
      boolean stiff) {
    double scale = energy.scale().orElse(0);
    String tighter = "Tighten the tolerances: the relative one is " + settings.relativeTolerance();
    return new Failure(
        MessageCode.ENERGY_DRIFT,
        String.format(
            Locale.ROOT,
            "The energy, less the work put in, has drifted by %.4g J, which is %.4g of the energy"
                + " scale of %.4g J; at most %s is allowed.",
            energy.latestDrift(),
            energy.latestDrift() / scale,
            scale,
            Double.toString(bound)),
        t,
        integrator.stepSize(),
        integrator.order(),
        limiting.map(s -> "state \"" + s + "\", which limits the steps most").orElse(""),
        tighter
            + (stiff && isExplicit(settings.integrator())
                ? "; the motion is stiff, so take an implicit integrator such as ode15s"
                : "")
            + ". A force that jumps needs an event, or a smaller largest step.");
  }

  /** Words a defect of the model. */
  static Failure of(Defects.Defect defect, double t, double stepSize, int order) {
    return new Failure(
        defect.code(), defect.cause(), t, stepSize, order, defect.part(), defect.advice());
  }

  /** Explains a start without accelerations. */
  static Failure singularStart(double t, ModelDescription model, int joint) {
    return singularInertia(t, 0, 0, model, joint);
  }

  /** Explains a row that holds a number that is not finite, although the state was accepted. */
  static Failure notFiniteColumn(double t, String column, String largestState) {
    return new Failure(
        MessageCode.NOT_FINITE,
        "An output is not finite.",
        t,
        0,
        0,
        "column " + column,
        "The largest state is " + largestState + ": check what acts on it.");
  }

  private static Failure singularInertia(
      double t, double stepSize, int order, ModelDescription model, int joint) {
    return new Failure(
        MessageCode.SINGULAR_INERTIA,
        "The inertia at this joint is singular to double precision: when the joints beyond it move"
            + " freely, the bodies there do not resist its motion, or by less than one part in 7e13"
            + " of what hangs on it.",
        t,
        stepSize,
        order,
        "joint \"" + model.joints().get(joint).name() + "\"",
        "If they have no inertia about its axis, give them some, or remove the joint. Other causes"
            + " are two axes that coincide, with bodies without inertia between them, and a light"
            + " body that carries one 1e13 times as heavy.");
  }

  private static Failure failure(
      MessageCode code, String cause, IntegrationFailure failure, String part, String advice) {
    return new Failure(
        code, cause, failure.time(), failure.stepSize(), failure.order(), part, advice);
  }

  private static String state(ModelDescription model, int component) {
    if (component >= model.stateCount()) {
      return "a multiplier of the loops";
    }
    return component < 0 ? "" : "state \"" + model.states().get(component).name() + "\"";
  }
}
