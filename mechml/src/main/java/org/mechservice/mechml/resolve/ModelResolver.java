package org.mechservice.mechml.resolve;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.simulation.EventsReader;
import org.mechservice.mechml.resolve.simulation.SimulationsReader;
import org.mechservice.mechml.resolve.value.ParameterTable;
import org.mechservice.mechml.resolve.value.ParametersReader;
import org.mechservice.mechml.resolve.value.ResolvedParameter;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitSymbols;
import org.mechservice.mechml.unit.UnitSystem;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** Resolves a valid document: builds the mechanism and the simulation settings. */
public final class ModelResolver {
  private final ReadOptions options;
  private final Diagnostics diagnostics;

  private ModelResolver(ReadOptions options, Diagnostics diagnostics) {
    this.options = options;
    this.diagnostics = diagnostics;
  }

  /**
   * Resolves a document.
   *
   * @param document the element MechML
   * @param options the chosen simulation and the parameters to set
   * @param diagnostics receives errors and warnings
   * @throws MechmlException with all diagnostics, if one of them is an error
   */
  public static MechmlModel resolve(Element document, ReadOptions options, Diagnostics diagnostics)
      throws MechmlException {
    return new ModelResolver(options, diagnostics).resolve(document);
  }

  private MechmlModel resolve(Element document) throws MechmlException {
    Element model = document.requiredChild("MBSmodel");
    UnitSystem units = units(model);
    ParameterTable parameters = new ParametersReader(units, options, diagnostics).read(model);
    ValueReader values = new ValueReader(units, parameters, diagnostics);
    List<Element> blocks = document.children("MBSsimulation");
    Optional<MechanismReader> reader =
        MechanismReader.begin(model, values, inputs(blocks), diagnostics);
    Optional<Mechanism> mechanism = reader.flatMap(MechanismReader::mechanism);
    List<Output> outputs = reader.map(MechanismReader::outputs).orElse(List.of());
    SimulationsReader simulations =
        new SimulationsReader(
            values,
            reader.map(r -> new EventsReader(values, r.formulas(), r.names(), diagnostics)),
            diagnostics);
    List<SimulationSettings> settings = simulations.read(blocks);
    int chosen = simulations.choose(blocks, options.simulation());
    diagnostics.throwIfErrors();
    reader.orElseThrow().checkMotions(mechanism.orElseThrow(), settings.get(chosen));
    reader.orElseThrow().checkStates(mechanism.orElseThrow(), settings.get(chosen));
    TrimCheck.of(
        settings.get(chosen).task(), blocks.get(chosen), mechanism.get(), outputs, diagnostics);
    if (!outputs.isEmpty()) {
      new ColumnNames(mechanism.get()).refuse(model, diagnostics);
    }
    Set<MessageCode> silenced = SilencedWarnings.of(model, options.silenced(), diagnostics);
    diagnostics.throwIfErrors();
    new ModelRemarks(model, reader.get(), mechanism.get(), diagnostics)
        .make(settings.get(chosen).task(), unusedParameters(parameters, mechanism.get()));
    return new MechmlModel(
        mechanism.get(),
        reader.get().inputCount(),
        settings.get(chosen),
        settings,
        parameters.all(),
        outputs,
        unused(reader.get(), parameters, mechanism.get()),
        diagnostics.inFileOrder().stream()
            .filter(said -> said.severity() == Severity.ERROR || !silenced.contains(said.code()))
            .toList(),
        silenced,
        reader.get().scenery(),
        dataFiles(model));
  }

  /** Returns the files of tables as {@code mech check} shows them. */
  private static List<String> dataFiles(Element model) {
    return model.children("Tables").stream()
        .flatMap(tables -> tables.children().stream())
        .filter(table -> table.attribute("layout").isPresent())
        .map(
            table ->
                Phrase.of(
                    "%s: %s, %s",
                    table.label(),
                    Quoted.plain(table.attribute("file").orElse("")),
                    Quoted.plain(table.attribute("layout").orElse(""))))
        .toList();
  }

  /** Returns what becomes of inputs: a linearisation varies them, also those with a table. */
  private ReadOptions.Inputs inputs(List<Element> blocks) {
    OptionalInt chosen = SimulationsReader.index(blocks, options.simulation());
    boolean linearizes =
        chosen.isPresent() && blocks.get(chosen.getAsInt()).child("linearize").isPresent();
    return linearizes ? ReadOptions.Inputs.STATES : options.inputs();
  }

  private static List<String> unused(
      MechanismReader reader, ParameterTable parameters, Mechanism mechanism) {
    return UnusedNames.of(reader.names(), parameters, hasClasses(mechanism));
  }

  /**
   * Returns none if a value is set: the expression that it replaces may be the one that uses it.
   */
  private List<ResolvedParameter> unusedParameters(ParameterTable parameters, Mechanism mechanism) {
    return !options.values().isEmpty()
        ? List.of()
        : UnusedNames.parameters(parameters, hasClasses(mechanism));
  }

  /** Returns whether forces are classes of users, which may read points and tunable parameters. */
  private static boolean hasClasses(Mechanism mechanism) {
    return mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance);
  }

  private static UnitSystem units(Element model) {
    Unit mass = unit(model.required("massUnits"));
    Unit length = unit(model.required("lengthUnits"));
    Unit angle = unit(model.attribute("angleUnits").orElse("rad"));
    return model
        .attribute("forceUnits")
        .map(force -> new UnitSystem(mass, length, angle, unit(force)))
        .orElse(UnitSystem.composed(mass, length, angle));
  }

  private static Unit unit(String symbol) {
    return UnitSymbols.unit(symbol).orElseThrow();
  }
}
