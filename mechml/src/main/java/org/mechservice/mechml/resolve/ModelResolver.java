package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.MechmlException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.LaterLanguage;
import org.mechservice.mechml.expression.Scope;
import org.mechservice.mechml.unit.UnitSymbols;
import org.mechservice.mechml.unit.UnitSystem;
import org.mechservice.solver.mechanism.Mechanism;

/** Makes a mechanism and its settings of a document that keeps to the grammar. */
public final class ModelResolver {
  private final Diagnostics diagnostics;

  private ModelResolver(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /**
   * Resolves a document.
   *
   * @param document the element MechML
   * @param diagnostics takes what is wrong or worth knowing
   * @throws MechmlException if there is an error, with all that were found
   */
  public static MechmlModel resolve(Element document, Diagnostics diagnostics)
      throws MechmlException {
    return new ModelResolver(diagnostics).resolve(document);
  }

  private MechmlModel resolve(Element document) throws MechmlException {
    Element model = document.requiredChild("MBSmodel");
    ValueReader values = new ValueReader(units(model), Scope.CONSTANTS, diagnostics);
    checkLaterElements(document, model);
    Optional<SimulationSettings> settings =
        new SimulationReader(values, diagnostics)
            .read(document.requiredChild("MBSsimulation").requiredChild("dynamic"));
    Optional<Mechanism> mechanism = new MechanismReader(values, diagnostics).read(model);
    diagnostics.throwIfErrors();
    return new MechmlModel(
        mechanism.orElseThrow(), settings.orElseThrow(), diagnostics.inFileOrder());
  }

  private static UnitSystem units(Element model) {
    return new UnitSystem(
        UnitSymbols.unit(model.required("massUnits")).orElseThrow(),
        UnitSymbols.unit(model.required("lengthUnits")).orElseThrow(),
        UnitSymbols.unit(model.attribute("angleUnits").orElse("rad")).orElseThrow());
  }

  /** Reports what the grammar knows but nothing here reads. */
  private void checkLaterElements(Element document, Element model) {
    List<Element> later = new ArrayList<>();
    List<Element> simulations = document.children("MBSsimulation");
    later.addAll(simulations.subList(1, simulations.size()));
    model.child("Constraints").ifPresent(c -> later.addAll(c.children("DISTConstraint")));
    model.child("Forces").ifPresent(f -> later.addAll(f.children("force")));
    for (Element element : later) {
      diagnostics.error(
          MessageCode.NOT_IN_THIS_VERSION,
          element.place(),
          Phrase.of("%s is not available; %s", what(element), LaterLanguage.PRESENT));
    }
  }

  private static String what(Element element) {
    return element.name().equals("MBSsimulation") ? "a second <MBSsimulation>" : element.label();
  }
}
