package org.mechservice.sim.service.library;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.OPT_ABS_TOL;
import org.mechservice.idl.OPT_CLOSURE;
import org.mechservice.idl.OPT_CODE;
import org.mechservice.idl.OPT_COLUMNS;
import org.mechservice.idl.OPT_COMPACT;
import org.mechservice.idl.OPT_CONTINUES;
import org.mechservice.idl.OPT_FORMULATION;
import org.mechservice.idl.OPT_INTEGRATOR;
import org.mechservice.idl.OPT_MAX_DRIFT;
import org.mechservice.idl.OPT_REL_TOL;
import org.mechservice.idl.OPT_SOURCE_PART;
import org.mechservice.idl.OPT_STANDALONE;
import org.mechservice.idl.OPT_STRICT;
import org.mechservice.idl.OPT_TEXT_PART;
import org.mechservice.idl.OPT_T_END;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelColumns;
import org.mechservice.sim.scene.IntegratorSelection;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.catalogue.SourceLanguage;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A validated request to build or run a model: the settings of its file, overridden by the options
 * of the request. {@link #forRun} and {@link #forJar} are what the generator needs of it, {@link
 * #settings} is what the solver needs.
 *
 * @param formulation formulation requested, {@code auto} or a name
 * @param closure closure requested, {@code auto} or a name
 * @param compact whether the model is data-driven instead of generated code
 * @param code layout of generated code
 * @param columns column groups wanted
 * @param settings of the run, with the integrator resolved
 * @param standalone whether a JAR is to carry the solver
 * @param strict whether warnings are errors
 * @param automatic whether the integrator is chosen by the service
 * @param integratorReason why it was chosen; empty if the request names it
 * @param maxDrift drift of the energy balance, over the energy scale, that ends a run
 * @param earlierIds ids of the runs that the run continues
 */
public record SimulationRequest(
    String formulation,
    String closure,
    boolean compact,
    CodeForm code,
    Set<ColumnGroup> columns,
    RunSettings settings,
    boolean standalone,
    boolean strict,
    boolean automatic,
    Optional<String> integratorReason,
    OptionalDouble maxDrift,
    List<String> earlierIds) {
  /** Integrator for {@code auto} with explicit formulations: ode113, and ode15s when stiff. */
  private static final String EXPLICIT_INTEGRATOR = IntegrationMethod.SWITCHING.label();

  /** Integrator for {@code auto} with residual formulations. */
  private static final String RESIDUAL_INTEGRATOR = IntegrationMethod.ODE15SR.label();

  public SimulationRequest {
    columns = Set.copyOf(columns);
    earlierIds = List.copyOf(earlierIds);
  }

  /**
   * Reads the options of a request, and chooses the integrator if the request leaves it to us.
   *
   * @param model the model, read as the request wants it
   * @throws InvalidOption if the value of an option cannot be used
   */
  public static SimulationRequest of(RequestOptions given, MechmlModel model) throws InvalidOption {
    return parse(given, model.settings()).suiting(model.mechanism());
  }

  /** Returns a run of a model with the settings of its file. */
  public static SimulationRequest asInFile(MechmlModel model) throws InvalidOption {
    return of(RequestOptions.of(new NameValue[0]), model);
  }

  static SimulationRequest parse(RequestOptions given, SimulationSettings ofFile)
      throws InvalidOption {
    boolean integrated = ofFile.task() instanceof SimulationTask.Dynamic;
    if (!integrated) {
      refuseMethods(given, ofFile.task());
    }
    return new SimulationRequest(
        given.text(OPT_FORMULATION.value, ofFile.formulation()),
        given.text(OPT_CLOSURE.value, ofFile.closure()),
        given.flag(OPT_COMPACT.value),
        code(given),
        columns(given.text(OPT_COLUMNS.value, ofFile(ofFile))),
        settings(given, ofFile),
        given.flag(OPT_STANDALONE.value),
        given.flag(OPT_STRICT.value),
        integrated
            && given.text(OPT_INTEGRATOR.value, ofFile.run().integrator()).equals(MethodNames.AUTO),
        Optional.empty(),
        maxDrift(given),
        earlierIds(given));
  }

  /**
   * Returns the index of the source file requested, from 0.
   *
   * @throws InvalidOption if it is not a number from 0 to 999
   */
  public static int sourcePart(RequestOptions given) throws InvalidOption {
    return part(OPT_SOURCE_PART.value, given.text(OPT_SOURCE_PART.value, "0"));
  }

  /**
   * Returns the index of the part of a text that is requested, from 0; empty for all of it.
   *
   * @throws InvalidOption if it is not a number from 0 to 999
   */
  public static OptionalInt textPart(RequestOptions given) throws InvalidOption {
    String text = given.text(OPT_TEXT_PART.value, "");
    return text.isEmpty() ? OptionalInt.empty() : OptionalInt.of(part(OPT_TEXT_PART.value, text));
  }

  private static int part(String option, String text) throws InvalidOption {
    if (!text.matches("[0-9]{1,3}")) {
      throw ContractErrors.option(
          option, option + " is \"" + text + "\"; it must be a number from 0 to 999");
    }
    return Integer.parseInt(text);
  }

  /**
   * Returns the language of the source files requested; Java unless the request names another.
   *
   * @throws InvalidOption if there is none of that name
   */
  public static SourceLanguage sourceLanguage(RequestOptions given) throws InvalidOption {
    String text = given.text(SourceLanguage.OPTION, SourceLanguage.JAVA.label());
    return SourceLanguage.of(text)
        .orElseThrow(
            () ->
                ContractErrors.option(
                    SourceLanguage.OPTION,
                    SourceLanguage.OPTION + " is \"" + text + "\"; it must be java or c"));
  }

  private static List<String> earlierIds(RequestOptions given) throws InvalidOption {
    String ids = given.text(OPT_CONTINUES.value, "");
    if (ids.isEmpty()) {
      return List.of();
    }
    if (!ids.matches("[-0-9a-f]{1,64}(,[-0-9a-f]{1,64}){0,99}")) {
      throw ContractErrors.option(
          OPT_CONTINUES.value, "\"" + ids + "\" are no ids of runs, separated by commas");
    }
    return List.of(ids.split(",", -1));
  }

  /** Returns the same request with the integrator chosen for a scene, if it is automatic. */
  private SimulationRequest suiting(Mechanism mechanism) {
    if (!automatic) {
      return this;
    }
    IntegratorSelection choice = IntegratorSelection.of(formulation, mechanism, settings);
    return new SimulationRequest(
        formulation,
        closure,
        compact,
        code,
        columns,
        settings.withIntegrator(choice.integrator()),
        standalone,
        strict,
        true,
        choice.reason(),
        maxDrift,
        earlierIds);
  }

  /** Refuses options of integration for a task that is not integrated. */
  private static void refuseMethods(RequestOptions given, SimulationTask task)
      throws InvalidOption {
    for (String method :
        List.of(
            OPT_FORMULATION.value,
            OPT_CLOSURE.value,
            OPT_INTEGRATOR.value,
            OPT_REL_TOL.value,
            OPT_ABS_TOL.value,
            Accuracy.OPTION,
            OPT_MAX_DRIFT.value)) {
      if (given.has(method)) {
        throw ContractErrors.option(
            method,
            "the simulation is <"
                + task.element()
                + ">, which takes no "
                + method
                + "; leave it out");
      }
    }
  }

  private static OptionalDouble maxDrift(RequestOptions given) throws InvalidOption {
    return given.has(OPT_MAX_DRIFT.value)
        ? OptionalDouble.of(given.positive(OPT_MAX_DRIFT.value, 0, ""))
        : OptionalDouble.empty();
  }

  private static CodeForm code(RequestOptions given) throws InvalidOption {
    String text = given.text(OPT_CODE.value, CodeForm.AUTO.label());
    if (given.has(OPT_CODE.value) && given.flag(OPT_COMPACT.value)) {
      throw ContractErrors.option(
          OPT_CODE.value,
          "code says how code is laid out, and compact form has none; leave out one");
    }
    return CodeForm.named(text)
        .orElseThrow(
            () ->
                ContractErrors.option(
                    OPT_CODE.value, "code is \"" + text + "\"; it must be " + CodeForm.LABELS));
  }

  private static Set<ColumnGroup> columns(String text) throws InvalidOption {
    Set<ColumnGroup> groups = EnumSet.of(ColumnGroup.JOINTS);
    for (String word : text.split(",", -1)) {
      String label = word.strip();
      if (label.equals("all")) {
        groups.addAll(EnumSet.allOf(ColumnGroup.class));
      } else {
        groups.add(group(label));
      }
    }
    return groups;
  }

  private static String ofFile(SimulationSettings file) {
    return ModelColumns.shown(file).stream()
        .map(ColumnGroup::label)
        .collect(Collectors.joining(","));
  }

  private static ColumnGroup group(String label) throws InvalidOption {
    String known =
        Stream.of(ColumnGroup.values()).map(ColumnGroup::label).collect(Collectors.joining(", "));
    for (ColumnGroup group : ColumnGroup.values()) {
      if (group.label().equals(label)) {
        return group;
      }
    }
    throw ContractErrors.option(
        OPT_COLUMNS.value,
        "columns names \""
            + label
            + "\", which is no column group; there are "
            + known
            + " and all");
  }

  private static String automatic(String formulation) {
    return Formulation.find(formulation.toUpperCase(Locale.ROOT))
            .filter(Formulation::isResidual)
            .isPresent()
        ? RESIDUAL_INTEGRATOR
        : EXPLICIT_INTEGRATOR;
  }

  private static RunSettings settings(RequestOptions given, SimulationSettings file)
      throws InvalidOption {
    String formulation = given.text(OPT_FORMULATION.value, file.formulation());
    RunSettings ofFile = file.run();
    String integrator = given.text(OPT_INTEGRATOR.value, ofFile.integrator());
    double end = given.number(OPT_T_END.value, ofFile.tEnd());
    if (end < ofFile.tStart()) {
      throw ContractErrors.option(
          OPT_T_END.value,
          "t-end is " + end + " s, before the start of the run at " + ofFile.tStart() + " s");
    }
    RunSettings settings =
        ofFile
            .withOutput(end, given.positive(OPT_T_STEP.value, ofFile.tStep(), "s"))
            .withIntegrator(
                !(file.task() instanceof SimulationTask.Dynamic)
                    ? MethodNames.NONE
                    : integrator.equals(MethodNames.AUTO) ? automatic(formulation) : integrator)
            .withRelativeTolerance(given.belowOne(OPT_REL_TOL.value, ofFile.relativeTolerance()))
            .withAccuracy(accuracy(given, ofFile));
    return given.has(OPT_ABS_TOL.value)
        ? settings.withTolerances(tolerances(given.text(OPT_ABS_TOL.value, "")))
        : settings;
  }

  private static Accuracy accuracy(RequestOptions given, RunSettings ofFile) throws InvalidOption {
    try {
      return Accuracy.of(given.text(Accuracy.OPTION, ofFile.accuracy().label()));
    } catch (IllegalArgumentException e) {
      throw ContractErrors.option(Accuracy.OPTION, String.valueOf(e.getMessage()));
    }
  }

  /** Reads one tolerance, or four separated by semicolons. */
  private static List<Double> tolerances(String text) throws InvalidOption {
    List<Double> tolerances = new ArrayList<>();
    for (String one : text.split(";", -1)) {
      tolerances.add(RequestOptions.positiveOf(OPT_ABS_TOL.value, one.strip()));
    }
    if (tolerances.size() != 1 && tolerances.size() != 4) {
      throw ContractErrors.option(
          OPT_ABS_TOL.value,
          OPT_ABS_TOL.value
              + " is \""
              + text
              + "\"; it takes one number, or four for positions, angles, velocities and angular"
              + " velocities");
    }
    return tolerances;
  }

  /** Returns the build options of a JAR; it contains the settings of this request. */
  public BuildOptions forJar() {
    return new BuildOptions(
        formulation, closure, compact, code, columns, settings, integratorReason);
  }

  /**
   * Returns the build options of a run on this host. The class contains the settings of the file,
   * so that runs that differ in settings only share one class.
   */
  public BuildOptions forRun(SimulationSettings ofFile) {
    return new BuildOptions(
        formulation,
        closure,
        compact,
        code,
        columns,
        ofFile.run().withIntegrator(settings.integrator()),
        integratorReason);
  }
}
