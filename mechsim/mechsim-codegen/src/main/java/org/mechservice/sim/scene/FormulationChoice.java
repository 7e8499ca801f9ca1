package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.ClosureMethod;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.UserForceElement;

/**
 * The formulation of a scene's equations and the closure of its loops.
 *
 * @param formulation {@code DTR}, {@code DSR}, {@code RR} or {@code RR-JF}
 * @param closure {@code none} for open chains, else {@code projection} or {@code penalty}, with its
 *     parameters if there are any
 * @param reason reason of the choice
 */
public record FormulationChoice(String formulation, String closure, String reason) {
  private static final String DTR = Formulation.DTR.label();
  private static final String DSR = Formulation.DSR.label();
  private static final String RESIDUAL_DERIVED = Formulation.RR_JF.label();
  private static final String PROJECTION = ClosureMethod.PROJECTION.label();

  /** Largest number of loops that a reason names. */
  private static final int MOST_NAMED = 20;

  /**
   * Chooses formulation and closure for a request.
   *
   * @param formulation {@code auto} or the name of a formulation
   * @param closure {@code auto} or the name of a closure
   * @param settings settings of the run: its integrator, and its start, at which loops are examined
   * @throws ModelBuildException S-081 if one of them is unknown, not in this version, or does not
   *     fit the others or the scene
   */
  public static FormulationChoice of(
      String formulation, String closure, RunSettings settings, MechmlModel model) {
    Mechanism mechanism = model.mechanism();
    String asked = canonical(formulation);
    if (!asked.equals(MethodNames.AUTO) && Formulation.find(asked).isEmpty()) {
      throw refused(
          "there is no formulation \""
              + formulation
              + "\"; use "
              + String.join(", ", Formulation.labels())
              + " or auto");
    }
    return mechanism.closures().isEmpty()
        ? open(asked, closure, settings.integrator(), mechanism)
        : closed(asked, closure, settings, model);
  }

  /** Returns the canonical spelling of a formulation, which users may write in any case. */
  private static String canonical(String formulation) {
    return formulation.equalsIgnoreCase(MethodNames.AUTO)
        ? MethodNames.AUTO
        : formulation.toUpperCase(Locale.ROOT);
  }

  /** Returns the same choice with a further reason. */
  public FormulationChoice because(String more) {
    return new FormulationChoice(formulation, closure, reason + more);
  }

  /**
   * Returns the same choice; its reason also names the forces that are user classes. Generated code
   * calls such classes and does not contain them.
   */
  public FormulationChoice callingForcesOf(Mechanism mechanism) {
    List<String> names = new ArrayList<>();
    for (ForceElement force : mechanism.forces()) {
      if (force instanceof UserForceElement) {
        names.add("\"" + force.name() + "\"");
      }
    }
    return names.isEmpty()
        ? this
        : because("; every evaluation calls the classes of forces " + String.join(", ", names));
  }

  private static FormulationChoice open(
      String asked, String closure, String integrator, Mechanism mechanism) {
    if (!closure.equals(MethodNames.AUTO) && !closure.equals(MethodNames.NONE)) {
      throw refused(
          "closure \""
              + closure
              + "\" is for loops, which model \""
              + mechanism.name()
              + "\" does not have: its joints form a tree; use auto");
    }
    String chosen = asked;
    String reason = "asked for; it fits: the joints form a tree";
    if (asked.equals(MethodNames.AUTO)) {
      boolean residual = takesResidual(integrator);
      chosen = residual ? RESIDUAL_DERIVED : DTR;
      reason =
          residual
              ? "auto: ode15sR takes the residual form, with its derivatives by recursion"
              : "auto: the scene is an open chain, which articulated bodies solve in O(n)";
    } else if (asked.equals(DTR)) {
      reason =
          "asked for; it fits: the scene is an open chain, which articulated bodies solve in O(n)";
    }
    requireIntegrator(chosen, integrator);
    return new FormulationChoice(chosen, MethodNames.NONE, reason);
  }

  private static FormulationChoice closed(
      String asked, String closure, RunSettings settings, MechmlModel model) {
    Mechanism mechanism = model.mechanism();
    if (!asked.equals(MethodNames.AUTO) && !Formulation.of(asked).takesLoops()) {
      throw refused(
          asked
              + " is for open chains; the scene closes loops at "
              + loops(mechanism)
              + "; use DSR, RR or RR-JF");
    }
    boolean automatic = closure.equals(MethodNames.AUTO);
    boolean penalty = PenaltySettings.isPenalty(closure);
    if (!automatic && !closure.equals(PROJECTION) && !penalty) {
      throw refused("there is no closure \"" + closure + "\"; use projection, penalty or auto");
    }
    if (penalty) {
      requireUsable(closure);
    }
    String why = "the scene closes loops at " + loops(mechanism);
    String chosen = asked;
    if (asked.equals(MethodNames.AUTO)) {
      chosen = takesResidual(settings.integrator()) ? RESIDUAL_DERIVED : DSR;
      why = "auto: " + why;
    } else {
      requireIntegrator(asked, settings.integrator());
      why = "asked for; it fits: " + why;
    }
    Optional<String> against =
        automatic ? model.closedStart(settings.tStart()).againstProjection() : Optional.empty();
    String closedBy =
        automatic ? against.isPresent() ? PenaltySettings.CLOSURE : PROJECTION : closure;
    String reason =
        automatic
            ? "auto: " + against.orElse("independent coordinates can be chosen")
            : "asked for";
    return new FormulationChoice(chosen, closedBy, why + "; closure " + closedBy + ", " + reason);
  }

  private static void requireUsable(String penalty) {
    try {
      PenaltySettings.of(penalty);
    } catch (IllegalArgumentException e) {
      throw refused("closure \"" + penalty + "\": " + e.getMessage());
    }
  }

  private static void requireIntegrator(String formulation, String integrator) {
    if (Formulation.of(formulation).isResidual() && !takesResidual(integrator)) {
      throw refused(
          "formulation "
              + formulation
              + " is a residual F(t, y, y') = 0, which integrator "
              + integrator
              + " does not take; use ode15sR, or DTR or DSR");
    }
  }

  private static boolean takesResidual(String integrator) {
    return IntegrationMethod.find(integrator).filter(IntegrationMethod::takesResidual).isPresent();
  }

  private static String loops(Mechanism mechanism) {
    int count = mechanism.closures().size();
    String named =
        mechanism.closures().stream()
            .limit(MOST_NAMED)
            .map(FormulationChoice::label)
            .collect(Collectors.joining(", "));
    return count <= MOST_NAMED ? named : named + " and " + (count - MOST_NAMED) + " more";
  }

  private static String label(LoopClosure closure) {
    boolean rod = closure instanceof DistanceClosure distance && distance.hasRod();
    return closure.name() + (rod ? " (a rod with mass)" : "");
  }

  private static ModelBuildException refused(String why) {
    return new ModelBuildException(MessageCode.FORMULATION_NOT_AVAILABLE, why);
  }
}
