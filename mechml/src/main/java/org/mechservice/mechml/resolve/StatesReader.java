package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
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
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Function;
import org.mechservice.solver.mechanism.FurtherState;

/**
 * Reads {@code States}. Their names must be known before any formula is read, since states and
 * forces may refer to each other; the formulas are read afterwards.
 */
final class StatesReader {
  private static final Set<String> RESERVED = Set.of("t", "PI", "Math");

  private final ValueReader values;
  private final MechanismNames names;
  private final Diagnostics diagnostics;
  private final List<Element> elements;

  private StatesReader(
      List<Element> elements, ValueReader values, MechanismNames names, Diagnostics diagnostics) {
    this.elements = elements;
    this.values = values;
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns a reader that has made the names of the states known to formulas. */
  static StatesReader begin(
      Element model, ValueReader values, MechanismNames names, Diagnostics diagnostics) {
    List<Element> elements =
        model.child("States").map(states -> states.children("state")).orElse(List.of());
    StatesReader reader = new StatesReader(elements, values, names, diagnostics);
    reader.register();
    reader.checkColumns(model);
    return reader;
  }

  private void register() {
    NameTable<Element> taken = new NameTable<>("state", "does not exist", diagnostics);
    for (int i = 0; i < elements.size(); i++) {
      Element element = elements.get(i);
      String name = element.required("name");
      taken.add(element, Optional.of(element));
      if (RESERVED.contains(name) || Function.named(name).isPresent()) {
        unusable(element, "has another meaning in expressions");
      } else if (values.parameters().names().contains(name)) {
        unusable(element, "is the name of a parameter, too; rename one of them");
      }
      Expression value = new Expression.StateValue(i);
      names.add(name, () -> value);
    }
  }

  private void unusable(Element element, String why) {
    diagnostics.error(
        MessageCode.UNUSABLE_NAME,
        element.position(),
        Phrase.of("%s: %s %s", element.label(), Quoted.of(element.required("name")), why));
  }

  /** Reports states and outputs of the same name: their columns could not be told apart. */
  private void checkColumns(Element model) {
    Set<String> outputs =
        model.child("Outputs").map(o -> o.children("output")).orElse(List.of()).stream()
            .flatMap(output -> output.attribute("name").stream())
            .collect(Collectors.toSet());
    for (Element element : elements) {
      if (outputs.contains(element.required("name"))) {
        diagnostics.error(
            MessageCode.DUPLICATE_NAME,
            element.position(),
            element.label()
                + ": an output has this name; a state has a column of its own, so leave the output"
                + " out or rename it");
      }
    }
  }

  /** Returns the states without errors, in file order. */
  List<FurtherState> read(FormulaReader formulas) {
    List<FurtherState> states = new ArrayList<>();
    for (Element element : elements) {
      state(element, formulas).ifPresent(states::add);
    }
    return states;
  }

  private Optional<FurtherState> state(Element element, FormulaReader formulas) {
    OptionalDouble start = numberOr(element, "x0", 0);
    OptionalDouble tolerance = numberOr(element, "atol", 0);
    Optional<Expression> derivative =
        formulas.read(AttributeText.of(element, "derivative"), Unit.ONE, FormulaRole.STATE);
    if (element.attribute("atol").isPresent()
        && tolerance.isPresent()
        && !(tolerance.getAsDouble() > 0)) {
      diagnostics.error(
          MessageCode.STATE_VALUE,
          element.position(),
          element.label() + ": atol is " + tolerance.getAsDouble() + "; it must be positive");
      return Optional.empty();
    }
    if (start.isEmpty() || tolerance.isEmpty()) {
      return Optional.empty();
    }
    return derivative.map(
        rate ->
            new FurtherState(
                element.required("name"),
                start.getAsDouble(),
                rate,
                element.attribute("unit").map(StatesReader::label).orElse("1"),
                tolerance.getAsDouble(),
                names.origin(element)));
  }

  /** Returns a unit as written: it labels the column, and nothing is converted by it. */
  private static String label(String unit) {
    String text = unit.strip().replaceAll("\\p{Cntrl}", " ");
    return text.isEmpty() ? "1" : text;
  }

  private OptionalDouble numberOr(Element element, String attribute, double otherwise) {
    return element.attribute(attribute).isPresent()
        ? values.number(element, attribute)
        : OptionalDouble.of(otherwise);
  }
}
