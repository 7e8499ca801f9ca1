package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Output;

/** Reads {@code Outputs}. */
final class OutputsReader {
  private final ValueReader values;
  private final FormulaReader formulas;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  OutputsReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.values = values;
    this.formulas = formulas;
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns the outputs without errors, in file order. */
  List<Output> read(Element model) {
    NameTable<Element> taken = new NameTable<>("output", "does not exist", diagnostics);
    List<Output> outputs = new ArrayList<>();
    for (Element element :
        model.child("Outputs").map(o -> o.children("output")).orElse(List.of())) {
      if (isComplete(element)) {
        taken.add(element, Optional.of(element));
        output(element).ifPresent(outputs::add);
      }
    }
    return outputs;
  }

  private boolean isComplete(Element element) {
    boolean complete = true;
    for (String needed : List.of("name", "expression")) {
      if (element.attribute(needed).isEmpty()) {
        error(element, Phrase.of("attribute %s is missing", Quoted.of(needed)));
        complete = false;
      }
    }
    if (element.attribute("columns").isPresent()) {
      error(element, "attribute \"columns\" belongs to the output of a simulation");
      complete = false;
    }
    return complete;
  }

  private Optional<Output> output(Element element) {
    Optional<Unit> unit =
        element
            .attribute("unit")
            .map(text -> values.parse(element, text))
            .orElse(Optional.of(Unit.ONE));
    return formulas
        .read(AttributeText.of(element, "expression"), Unit.ONE, FormulaRole.STATE)
        .filter(value -> unit.isPresent())
        .map(
            value ->
                new Output(
                    element.required("name"),
                    value,
                    element.attribute("unit").map(String::strip).orElse("1"),
                    names.origin(element)));
  }

  private void error(Element element, String message) {
    diagnostics.error(
        MessageCode.OUTPUT_INCOMPLETE, element.position(), element.label() + ": " + message);
  }
}
