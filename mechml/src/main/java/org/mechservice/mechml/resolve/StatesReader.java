package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.formula.Signal;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.PointFunction;
import org.mechservice.solver.mechanism.FurtherChange;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.Sampling;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Reads {@code States}: single states, blocks that stand for several states and an output, inputs,
 * and states that are sampled. Their names must be known before any formula is read, since states
 * and forces may refer to each other; the formulas are read afterwards.
 */
final class StatesReader {
  private static final Set<String> RESERVED = Set.of("t", "PI", "Math");

  /** Largest number of states. */
  private static final int MOST = 10_000;

  private final ValueReader values;
  private final MechanismNames names;
  private final ReadOptions.Inputs inputs;
  private final Diagnostics diagnostics;
  private final List<Entry> entries = new ArrayList<>();
  private final List<Parameter> inputParameters = new ArrayList<>();
  private final Map<Clock, Samples> samples = new LinkedHashMap<>();
  private Optional<ControllerBlocks> blocks = Optional.empty();

  /** An element with its states. */
  private final class Entry implements Signal {
    private final Element element;
    private final List<String> suffixes;
    private final int first;
    private final int inputsBefore;
    private Optional<ControllerBlocks.Block> block = Optional.empty();
    private boolean done;
    private boolean open;

    Entry(Element element, int first) {
      this.element = element;
      this.first = first;
      inputsBefore = (int) entries.stream().filter(Entry::isInput).count();
      suffixes =
          switch (element.name()) {
            case "pid" -> ControllerBlocks.statesOfPid(element);
            case "transferFunction" -> ControllerBlocks.statesOfTransferFunction(element);
            case "input" -> isHeld() ? List.of("") : List.of();
            default -> List.of("");
          };
    }

    boolean isInput() {
      return element.name().equals("input");
    }

    boolean isSampled() {
      return element.name().equals("sampled") || element.attribute("period").isPresent();
    }

    /** Returns whether the value is that of a state, the first one of the element. */
    boolean isState() {
      return element.name().equals("state") || isInput() || isSampled();
    }

    /** Returns whether an input is a state; one with a table is a function of time otherwise. */
    boolean isHeld() {
      return inputs == ReadOptions.Inputs.STATES
          || (inputs == ReadOptions.Inputs.AS_IN_FILE && element.attribute("table").isEmpty());
    }

    Optional<ControllerBlocks.Block> block() {
      if (!done) {
        open = true;
        ControllerBlocks reader = blocks.orElseThrow();
        block =
            element.name().equals("pid")
                ? reader.pid(element, first)
                : reader.transferFunction(element, first);
        open = false;
        done = true;
      }
      return block;
    }

    @Override
    public Expression value(int offset) throws ExpressionException {
      if (isInput() && inputs == ReadOptions.Inputs.PARAMETERS) {
        int tunable = values.parameters().tunable().size();
        return new Expression.ParameterValue(tunable + inputsBefore);
      }
      if (isInput() && !isHeld()) {
        // an unknown table is reported when the states are read
        return names
            .table(element.required("table"))
            .filter(table -> table.argumentCount() == 1)
            .<Expression>map(
                table -> new Expression.TableValue(table, List.of(new Expression.Time())))
            .orElse(new Expression.Time());
      }
      if (isState() || blocks.isEmpty()) {
        return new Expression.StateValue(first);
      }
      if (open) {
        throw new ExpressionException(
            MessageCode.EXPRESSION_NAME,
            offset,
            Phrase.of(
                "%s depends on itself here without delay, an algebraic loop; put a <state> or a"
                    + " <transferFunction> with a lag in between",
                Quoted.of(element.required("name"))));
      }
      // a block with an error has been reported; any expression prevents a second message
      return block().map(ControllerBlocks.Block::output).orElse(new Expression.Time());
    }
  }

  /** Times of samples. */
  private record Clock(double period, double offset) {}

  /** What is sampled at the same times, with the first element of it. */
  private record Samples(Element first, List<FurtherChange> changes) {}

  private StatesReader(
      ValueReader values,
      MechanismNames names,
      ReadOptions.Inputs inputs,
      Diagnostics diagnostics) {
    this.values = values;
    this.names = names;
    this.inputs = inputs;
    this.diagnostics = diagnostics;
  }

  /**
   * Returns a reader that has made the names of the states known to formulas.
   *
   * @param inputs what becomes of inputs
   */
  static StatesReader begin(
      Element model,
      ValueReader values,
      MechanismNames names,
      ReadOptions.Inputs inputs,
      Diagnostics diagnostics) {
    StatesReader reader = new StatesReader(values, names, inputs, diagnostics);
    model.child("States").ifPresent(states -> reader.register(states.children()));
    reader.checkColumns(model);
    return reader;
  }

  private void register(List<Element> elements) {
    NameTable<Element> taken = new NameTable<>("state", "does not exist", diagnostics);
    int count = 0;
    for (Element element : elements) {
      Entry entry = new Entry(element, count);
      count += entry.suffixes.size();
      if (count > MOST) {
        diagnostics.error(
            MessageCode.MODEL_FILE_TOO_LARGE,
            element.position(),
            "the model has more than " + MOST + " states");
        return;
      }
      entries.add(entry);
      String name = element.required("name");
      taken.add(element, Optional.of(element));
      if (RESERVED.contains(name) || MathFunction.named(name).isPresent()) {
        unusable(element, "has another meaning in expressions");
      } else if (values.parameters().names().contains(name)) {
        unusable(element, "is the name of a parameter, too; rename one of them");
      }
      names.add(name, entry);
      for (int i = 0; i < entry.suffixes.size(); i++) {
        if (!entry.suffixes.get(i).isEmpty()) {
          Expression state = new Expression.StateValue(entry.first + i);
          names.add(name + entry.suffixes.get(i), offset -> state);
        }
      }
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
    for (Entry entry : entries) {
      for (String suffix : entry.suffixes) {
        if (outputs.contains(entry.element.required("name") + suffix)) {
          diagnostics.error(
              MessageCode.DUPLICATE_NAME,
              entry.element.position(),
              entry.element.label()
                  + ": an output has this name; a state has a column of its own, so leave the"
                  + " output out or rename it");
        }
      }
    }
  }

  /** Returns the first element that is no input; states of forces have none. */
  Optional<Element> firstChanging() {
    return entries.stream()
        .filter(entry -> !entry.isInput())
        .findFirst()
        .map(entry -> entry.element);
  }

  /** Returns the samplings, after {@link #read}. */
  List<Sampling> samplings() {
    List<Sampling> samplings = new ArrayList<>();
    samples.forEach(
        (clock, together) ->
            samplings.add(
                new Sampling(
                    together.first.required("name"),
                    clock.period,
                    clock.offset,
                    together.changes,
                    names.origin(together.first))));
    return samplings;
  }

  /** Returns the inputs that are parameters, in file order, after {@link #read}. */
  List<Parameter> inputParameters() {
    return inputParameters;
  }

  /** Returns the states without errors, in file order. */
  List<FurtherState> read(FormulaReader formulas) {
    blocks = Optional.of(new ControllerBlocks(formulas, diagnostics));
    List<FurtherState> states = new ArrayList<>();
    for (Entry entry : entries) {
      Optional<Double> tolerance = tolerance(entry.element);
      if (entry.isInput()) {
        input(entry, states);
      } else if (entry.isSampled()) {
        sampled(entry, formulas, states);
      } else if (entry.isState()) {
        formulas
            .read(AttributeText.of(entry.element, "derivative"), Unit.ONE, FormulaRole.STATE)
            .ifPresent(rate -> add(entry, 0, rate, "unit", tolerance, states));
      } else if (entry.block().isPresent()) {
        List<Expression> rates = entry.block().get().derivatives();
        for (int i = 0; i < rates.size(); i++) {
          String unit = entry.suffixes.get(i).equals(ControllerBlocks.INTEGRAL) ? "unit" : "";
          add(entry, i, rates.get(i), unit, tolerance, states);
        }
      }
    }
    return states;
  }

  private void input(Entry entry, List<FurtherState> states) {
    Element element = entry.element;
    Optional<String> name = element.attribute("table");
    OptionalDouble start = name.isEmpty() ? start(entry, 0) : OptionalDouble.of(0);
    Optional<PointFunction> table = name.flatMap(names::table);
    if (name.isPresent() && table.isEmpty()) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          element.position(),
          Phrase.of(
              "%s names table %s, which does not exist%s",
              element.label(),
              Quoted.of(name.get()),
              NearestName.suggestion(name.get(), names.tableNames())));
    } else if (table.isPresent() && table.get().argumentCount() > 1) {
      error(element, name.get() + " is a map of two arguments; an input follows a table of t");
    } else if (name.isPresent() && element.attribute("x0").isPresent()) {
      error(element, "x0 has no meaning beside table, which gives the start, too; leave one out");
    } else if (start.isPresent()) {
      double first = table.map(t -> t.at(List.of(0.0))).orElse(start.getAsDouble());
      if (inputs == ReadOptions.Inputs.PARAMETERS) {
        inputParameters.add(new Parameter(element.required("name"), first, unit(element)));
      } else if (entry.isHeld()) {
        states.add(
            FurtherState.held(
                element.required("name"),
                first,
                unit(element),
                FurtherState.Role.INPUT,
                names.origin(element)));
      }
    }
  }

  /** Reads a state that is sampled, or the states of a controller that is. */
  private void sampled(Entry entry, FormulaReader formulas, List<FurtherState> states) {
    Element element = entry.element;
    Optional<Clock> clock = clock(element);
    if (clock.isEmpty()) {
      return;
    }
    Optional<List<Expression>> next =
        element.name().equals("pid")
            ? blocks.orElseThrow().sampledPid(element, entry.first, clock.get().period)
            : formulas
                .read(AttributeText.of(element, "value"), Unit.ONE, FormulaRole.STATE)
                .map(List::of);
    if (next.isEmpty()) {
      return;
    }
    List<FurtherChange> changes =
        samples.computeIfAbsent(clock.get(), c -> new Samples(element, new ArrayList<>())).changes;
    for (int i = 0; i < next.get().size(); i++) {
      OptionalDouble start = start(entry, i);
      if (start.isEmpty()) {
        return;
      }
      String suffix = entry.suffixes.get(i);
      boolean ofOutput = !suffix.equals(ControllerBlocks.PREVIOUS);
      states.add(
          FurtherState.held(
              element.required("name") + suffix,
              start.getAsDouble(),
              ofOutput ? unit(element) : "1",
              FurtherState.Role.SAMPLED,
              names.origin(element)));
      changes.add(new FurtherChange(entry.first + i, next.get().get(i)));
    }
  }

  private Optional<Clock> clock(Element element) {
    OptionalDouble period = values.number(element, "period");
    OptionalDouble offset =
        element.attribute("offset").isPresent()
            ? values.number(element, "offset")
            : OptionalDouble.of(0);
    if (period.isEmpty() || offset.isEmpty()) {
      return Optional.empty();
    }
    if (!(period.getAsDouble() > 0)) {
      error(element, "period is " + period.getAsDouble() + " s; it must be positive");
      return Optional.empty();
    }
    return Optional.of(new Clock(period.getAsDouble(), offset.getAsDouble()));
  }

  private void error(Element element, String message) {
    diagnostics.error(
        MessageCode.STATE_VALUE, element.position(), element.label() + ": " + message);
  }

  private static String unit(Element element) {
    return element.attribute("unit").map(StatesReader::label).orElse("1");
  }

  private void add(
      Entry entry,
      int index,
      Expression rate,
      String unit,
      Optional<Double> tolerance,
      List<FurtherState> states) {
    OptionalDouble start = start(entry, index);
    if (start.isPresent() && tolerance.isPresent()) {
      states.add(
          new FurtherState(
              entry.element.required("name") + entry.suffixes.get(index),
              start.getAsDouble(),
              rate,
              unit.isEmpty() ? "1" : unit(entry.element),
              tolerance.get(),
              names.origin(entry.element)));
    }
  }

  /** Returns an item of the list of start values, 0 beyond its end; empty after an error. */
  private OptionalDouble start(Entry entry, int index) {
    if (entry.element.attribute("x0").isEmpty()) {
      return OptionalDouble.of(0);
    }
    List<AttributeText> items = AttributeText.itemsOf(entry.element, "x0");
    int states = entry.isInput() ? 1 : entry.suffixes.size();
    if (items.size() > states) {
      diagnostics.error(
          MessageCode.VALUE_COUNT,
          entry.element.position(),
          Phrase.of(
              "%s: x0 has %d values for %d states", entry.element.label(), items.size(), states));
      return OptionalDouble.empty();
    }
    return index < items.size()
        ? values.evaluate(items.get(index), Unit.ONE)
        : OptionalDouble.of(0);
  }

  /** Returns the tolerance, 0 if there is none; empty after a reported error. */
  private Optional<Double> tolerance(Element element) {
    if (element.attribute("atol").isEmpty()) {
      return Optional.of(0.0);
    }
    OptionalDouble given = values.number(element, "atol");
    if (given.isPresent() && !(given.getAsDouble() > 0)) {
      diagnostics.error(
          MessageCode.STATE_VALUE,
          element.position(),
          element.label() + ": atol is " + given.getAsDouble() + "; it must be positive");
      return Optional.empty();
    }
    return given.stream().boxed().findFirst();
  }

  /** Returns a unit as written: it labels the column, and nothing is converted by it. */
  private static String label(String unit) {
    String text = unit.strip().replaceAll("\\p{Cntrl}", " ");
    return text.isEmpty() ? "1" : text;
  }
}
