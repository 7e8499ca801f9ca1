package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Function;
import org.mechservice.solver.expression.Table;

/** Reads {@code Tables}: functions of one argument, given by points, for use in expressions. */
final class TablesReader {
  private static final int MOST_POINTS = 100_000;

  private final ValueReader values;
  private final Diagnostics diagnostics;

  private TablesReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Makes the tables of a model known to formulas. */
  static void read(
      Element model, ValueReader values, MechanismNames names, Diagnostics diagnostics) {
    TablesReader reader = new TablesReader(values, diagnostics);
    NameTable<Element> taken = new NameTable<>("table", "does not exist", diagnostics);
    for (Element element : model.child("Tables").map(t -> t.children("table")).orElse(List.of())) {
      taken.add(element, Optional.of(element));
      names.add(reader.table(element).orElseGet(() -> unreadable(element)));
    }
  }

  /** Returns any table in place of one with errors, so that its calls cause no second message. */
  private static Table unreadable(Element element) {
    return new Table(
        element.required("name"),
        List.of(0.0, 1.0),
        List.of(1.0, 1.0),
        Table.Method.LINEAR,
        Table.Extrapolation.HOLD);
  }

  private Optional<Table> table(Element element) {
    String name = element.required("name");
    if (Function.named(name).isPresent()) {
      diagnostics.error(
          MessageCode.UNUSABLE_NAME,
          element.position(),
          Phrase.of("%s: %s is a function of expressions", element.label(), name));
      return Optional.empty();
    }
    if (element.attribute("x").isEmpty() || element.attribute("y").isEmpty()) {
      return error(
          element,
          element.attribute("file").isPresent()
              ? "its file was not read, because this model is not read from a folder; write x and y"
              : "write x and y, or file with the name of a CSV file beside the model");
    }
    Optional<List<Double>> x = numbers(element, "x");
    Optional<List<Double>> y = numbers(element, "y");
    if (x.isEmpty() || y.isEmpty()) {
      return Optional.empty();
    }
    Optional<String> wrong = wrong(x.get(), y.get());
    if (wrong.isPresent()) {
      return error(element, wrong.get());
    }
    return Optional.of(
        new Table(
            name,
            x.get(),
            y.get(),
            Table.Method.valueOf(upper(element, "method", "linear")),
            Table.Extrapolation.valueOf(upper(element, "extrapolation", "error"))));
  }

  private static String upper(Element element, String attribute, String otherwise) {
    return element.attribute(attribute).orElse(otherwise).toUpperCase(Locale.ROOT);
  }

  private static Optional<String> wrong(List<Double> x, List<Double> y) {
    if (x.size() != y.size()) {
      return Optional.of("x has " + x.size() + " values and y has " + y.size());
    }
    if (x.size() < 2) {
      return Optional.of("a table needs two points at least");
    }
    for (int i = 1; i < x.size(); i++) {
      if (!(x.get(i) > x.get(i - 1))) {
        return Optional.of(
            "x must ascend, but "
                + x.get(i)
                + " follows "
                + x.get(i - 1)
                + (x.get(i).equals(x.get(i - 1))
                    ? "; for a jump add step(x-" + x.get(i) + ") in the expression"
                    : ""));
      }
    }
    return Optional.empty();
  }

  private Optional<List<Double>> numbers(Element element, String attribute) {
    List<AttributeText> items = AttributeText.itemsOf(element, attribute);
    if (items.size() > MOST_POINTS) {
      return error(element, attribute + " has more than " + MOST_POINTS + " values");
    }
    List<Double> numbers = new ArrayList<>();
    for (AttributeText item : items) {
      OptionalDouble number = values.evaluate(item, Unit.ONE);
      if (number.isEmpty()) {
        return Optional.empty();
      }
      numbers.add(number.getAsDouble());
    }
    return Optional.of(numbers);
  }

  private <T> Optional<T> error(Element element, String message) {
    diagnostics.error(
        MessageCode.TABLE_POINTS, element.position(), element.label() + ": " + message);
    return Optional.empty();
  }
}
