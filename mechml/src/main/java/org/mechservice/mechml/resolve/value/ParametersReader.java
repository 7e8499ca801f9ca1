package org.mechservice.mechml.resolve.value;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.expression.ConstantEvaluation;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ExpressionParser;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.mechml.expression.References;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitException;
import org.mechservice.mechml.unit.UnitParser;
import org.mechservice.mechml.unit.UnitSystem;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.symbol.MathFunction;

/** Reads {@code Parameters}; they may refer to each other in any order. */
public final class ParametersReader {
  private static final Set<String> RESERVED = Set.of("t", "PI", "Math");

  private final UnitSystem units;
  private final ReadOptions options;
  private final Diagnostics diagnostics;
  private final Map<String, Pending> pending = new LinkedHashMap<>();
  private final Set<String> unreadable = new HashSet<>();
  private final ParameterTable table = new ParameterTable(unreadable);

  /** A parameter whose expression has been read but not evaluated. */
  private record Pending(Element element, String text, ParsedExpression expression, Unit unit) {}

  public ParametersReader(UnitSystem units, ReadOptions options, Diagnostics diagnostics) {
    this.units = units;
    this.options = options;
    this.diagnostics = diagnostics;
  }

  /** Returns the parameters without errors; reports the others. */
  public ParameterTable read(Element model) {
    List<Element> elements =
        model.child("Parameters").map(p -> p.children("parameter")).orElse(List.of());
    NameTable<Element> names = new NameTable<>("parameter", "does not exist", diagnostics);
    elements.forEach(element -> names.add(element, Optional.of(element)));
    elements.forEach(this::parse);
    pending.keySet().forEach(this::evaluateWithWhatItUses);
    refuseUnknown(options.values().keySet(), names.names(), "set");
    refuseUnknown(options.tunable(), names.names(), "tunable");
    return table;
  }

  private void refuseUnknown(Set<String> wanted, Set<String> known, String option) {
    for (String name : wanted) {
      if (!known.contains(name)) {
        diagnostics.error(
            MessageCode.UNKNOWN_NAME,
            SourcePosition.FILE,
            Phrase.of(
                "%s names parameter %s, which the model does not have%s",
                option, Quoted.of(name), NearestName.suggestion(name, known)));
      }
    }
  }

  private void parse(Element element) {
    String name = element.required("name");
    String text = options.values().getOrDefault(name, element.required("value"));
    if (RESERVED.contains(name) || MathFunction.named(name).isPresent()) {
      diagnostics.error(
          MessageCode.UNUSABLE_NAME,
          element.position(),
          Phrase.of("%s: %s has another meaning in expressions", element.label(), name));
      unreadable.add(name);
      return;
    }
    try {
      String unit = element.attribute("unit").map(String::strip).orElse("1");
      pending.putIfAbsent(
          name, new Pending(element, text, ExpressionParser.parse(text), UnitParser.parse(unit)));
    } catch (ExpressionException e) {
      report(element, text, e);
    } catch (UnitException e) {
      diagnostics.error(
          MessageCode.UNKNOWN_UNIT, element.position(), element.label() + ": " + e.reason());
      unreadable.add(name);
    }
  }

  private void report(Element element, String text, ExpressionException e) {
    unreadable.add(element.required("name"));
    boolean set = options.values().containsKey(element.required("name"));
    diagnostics.error(
        e.code(),
        element.position(),
        Phrase.of(
            "%s: in %s at character %d: %s",
            element.label(),
            set ? "the value set, " + Quoted.of(text) + "," : "value=" + Quoted.of(text),
            e.offset() + 1,
            e.reason()));
  }

  /**
   * Evaluates a parameter after those that it uses. Depth first without recursion, since a chain
   * may be as long as the file.
   */
  private void evaluateWithWhatItUses(String first) {
    Deque<String> open = new ArrayDeque<>(List.of(first));
    Set<String> begun = new HashSet<>();
    while (!open.isEmpty()) {
      String name = open.element();
      Optional<String> needed = isDone(name) ? Optional.empty() : firstUndone(name);
      if (isDone(name) || needed.isEmpty()) {
        open.remove();
        evaluate(name);
      } else if (!begun.add(name) && open.contains(needed.get())) {
        reportCircle(name, needed.get());
      } else {
        open.push(needed.get());
      }
    }
  }

  private boolean isDone(String name) {
    return table.names().contains(name) || unreadable.contains(name);
  }

  private Optional<String> firstUndone(String name) {
    return References.in(pendingOf(name).expression()).stream()
        .map(ParsedExpression.Reference::text)
        .filter(used -> pending.containsKey(used) && !isDone(used))
        .findFirst();
  }

  private Pending pendingOf(String name) {
    return Optional.ofNullable(pending.get(name)).orElseThrow();
  }

  private void reportCircle(String name, String used) {
    Element element = pendingOf(name).element();
    unreadable.add(name);
    diagnostics.error(
        MessageCode.CIRCULAR_PARAMETER,
        element.position(),
        Phrase.of(
            "%s: its value depends on itself%s",
            element.label(), used.equals(name) ? "" : " by way of " + Quoted.of(used)));
  }

  private void evaluate(String name) {
    if (isDone(name)) {
      return;
    }
    Pending parameter = pendingOf(name);
    Unit unit = parameter.unit();
    try {
      if (References.in(parameter.expression()).stream().anyMatch(r -> isLost(r.text()))) {
        unreadable.add(name);
        return;
      }
      double value = ConstantEvaluation.of(parameter.expression(), table) + 0.0;
      Unit seen = units.inExpressions(unit.dimension());
      double inExpressions = unit.equals(seen) ? value : seen.fromSi(unit.toSi(value));
      if (!Double.isFinite(inExpressions)) {
        throw new ExpressionException(MessageCode.EXPRESSION_VALUE, 0, "too large");
      }
      if (!options.values().containsKey(name)) {
        DimensionCheck.check(
            AttributeText.of(parameter.element(), "value"),
            parameter.expression(),
            unit,
            table,
            other -> Optional.empty(),
            diagnostics);
      }
      table.add(
          new ResolvedParameter(
              parameter.element(), value, unit, inExpressions, isTunable(parameter)));
    } catch (ExpressionException e) {
      report(parameter.element(), parameter.text(), e);
    }
  }

  /** A parameter that uses an unreadable one is not reported again. */
  private boolean isLost(String used) {
    return unreadable.contains(used);
  }

  private boolean isTunable(Pending parameter) {
    return parameter.element().attribute("tunable").map("true"::equals).orElse(false)
        || options.tunable().contains(parameter.element().required("name"));
  }
}
