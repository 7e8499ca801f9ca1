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
import org.mechservice.solver.expression.PointFunction;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.expression.TableMap;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Reads {@code Tables}: functions of one argument, given by points, and of two, given on a grid,
 * for use in expressions.
 */
final class TablesReader {
  private static final int MOST_POINTS = 100_000;

  /** Largest number of values of a map, of which each gives 16 numbers of a cell. */
  private static final int MOST_OF_MAP = 20_000;

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
    for (Element element : model.child("Tables").map(Element::children).orElse(List.of())) {
      taken.add(element, Optional.of(element));
      boolean map = element.name().equals("map");
      names.add(
          (map ? reader.map(element) : reader.table(element))
              .orElseGet(() -> unreadable(element, map)));
    }
  }

  /** Returns any table in place of one with errors, so that its calls cause no second message. */
  private static PointFunction unreadable(Element element, boolean map) {
    String name = element.required("name");
    List<Double> x = List.of(0.0, 1.0);
    List<Double> ones = List.of(1.0, 1.0, 1.0, 1.0);
    return map
        ? new TableMap(name, x, x, ones, Table.Method.LINEAR, Table.Extrapolation.HOLD)
        : new Table(name, x, ones.subList(0, 2), Table.Method.LINEAR, Table.Extrapolation.HOLD);
  }

  private Optional<PointFunction> map(Element element) {
    if (isFunction(element)) {
      return Optional.empty();
    }
    if (element.attribute("x").isEmpty()
        || element.attribute("y").isEmpty()
        || element.attribute("z").isEmpty()) {
      return missing(element, "x, y and z");
    }
    Optional<List<Double>> x = numbers(element, "x", MOST_POINTS);
    Optional<List<Double>> y = numbers(element, "y", MOST_POINTS);
    Optional<List<Double>> z = numbers(element, "z", MOST_OF_MAP);
    if (x.isEmpty() || y.isEmpty() || z.isEmpty()) {
      return Optional.empty();
    }
    int rows = x.get().size();
    int columns = y.get().size();
    Optional<String> wrong = notAscending("x", x.get()).or(() -> notAscending("y", y.get()));
    if (wrong.isPresent()) {
      return error(element, wrong.get());
    }
    if (z.get().size() != rows * columns) {
      return error(
          element,
          "z has "
              + z.get().size()
              + " values, but "
              + rows
              + " values of x and "
              + columns
              + " of y need "
              + rows * columns
              + ": for the first x those of all y, then for the second x, and so on");
    }
    return Optional.of(
        new TableMap(
            element.required("name"),
            x.get(),
            y.get(),
            z.get(),
            Table.Method.valueOf(upper(element, "method", "linear")),
            Table.Extrapolation.valueOf(upper(element, "extrapolation", "error"))));
  }

  private boolean isFunction(Element element) {
    String name = element.required("name");
    if (MathFunction.named(name).isPresent()) {
      diagnostics.error(
          MessageCode.UNUSABLE_NAME,
          element.position(),
          Phrase.of("%s: %s is a function of expressions", element.label(), name));
      return true;
    }
    return false;
  }

  private <T> Optional<T> missing(Element element, String which) {
    return error(
        element,
        element.attribute("file").isPresent()
            ? "its file was not read, because this model is not read from a folder; write " + which
            : "write " + which + ", or file with the name of a CSV file beside the model");
  }

  private Optional<PointFunction> table(Element element) {
    if (isFunction(element)) {
      return Optional.empty();
    }
    if (element.attribute("x").isEmpty() || element.attribute("y").isEmpty()) {
      return missing(element, "x and y");
    }
    Optional<List<Double>> x = numbers(element, "x", MOST_POINTS);
    Optional<List<Double>> y = numbers(element, "y", MOST_POINTS);
    if (x.isEmpty() || y.isEmpty()) {
      return Optional.empty();
    }
    Optional<String> wrong = wrong(x.get(), y.get());
    if (wrong.isPresent()) {
      return error(element, wrong.get());
    }
    return Optional.of(
        new Table(
            element.required("name"),
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
    return notAscending("x", x);
  }

  private static Optional<String> notAscending(String name, List<Double> x) {
    if (x.size() < 2) {
      return Optional.of(name + " needs two values at least");
    }
    for (int i = 1; i < x.size(); i++) {
      if (!(x.get(i) > x.get(i - 1))) {
        return Optional.of(
            name
                + " must ascend, but "
                + x.get(i)
                + " follows "
                + x.get(i - 1)
                + (x.get(i).equals(x.get(i - 1))
                    ? "; for a jump add step(" + name + "-" + x.get(i) + ") in the expression"
                    : ""));
      }
    }
    return Optional.empty();
  }

  private Optional<List<Double>> numbers(Element element, String attribute, int most) {
    List<AttributeText> items = AttributeText.itemsOf(element, attribute);
    if (items.size() > most) {
      return error(element, attribute + " has more than " + most + " values");
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
