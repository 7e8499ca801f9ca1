package org.mechservice.sim.emit.c;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.mechservice.sim.emit.method.NumberText;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.expression.MapSurface;
import org.mechservice.solver.expression.TableCurve;
import org.mechservice.solver.expression.TapeListing;
import org.mechservice.solver.symbol.MathFunction;

/** Writes the tape that the steps of a model watch, as the constant arrays of mech_watch.h. */
final class CWatchTape {
  private static final String SIZES = "mech_watch_tape.h";
  private static final String ARRAYS = "mech_watch_tape.c";

  /** Degrees of the cubics of a map, along each argument. */
  private static final int POWERS = 4;

  /** Operations of the steps' search that only Java has. */
  private static final Set<String> SEARCHED =
      Set.of(MathFunction.TOUCH.name(), MathFunction.PICK.name(), MathFunction.HELD.name());

  private final CWatch watch;
  private final TapeListing tape;
  private final List<Double> numbers = new ArrayList<>();
  private final Map<TableCurve, Integer> curves = new LinkedHashMap<>();
  private final Map<MapSurface, Integer> maps = new LinkedHashMap<>();
  private final List<String> tables = new ArrayList<>();

  private CWatchTape(CWatch watch) {
    this.watch = watch;
    this.tape = watch.tape();
  }

  /**
   * Returns the files by name: sizes, and arrays.
   *
   * @throws IllegalArgumentException if a watched formula needs a search, which mech_watch.c lacks
   */
  static Map<String, String> files(CWatch watch) {
    if (watch.tape().steps().stream().anyMatch(step -> SEARCHED.contains(step.operation()))) {
      throw new IllegalArgumentException(
          "a rope through a ring (inside=\"true\") that acts on one side, or has a constant length,"
              + " is not in code in C: the search for its slack needs the touching point; give it"
              + " side=\"both\", or a pathForce");
    }
    CWatchTape written = new CWatchTape(watch);
    Map<String, String> files = new LinkedHashMap<>();
    files.put(SIZES, written.sizes());
    files.put(ARRAYS, written.arrays());
    return files;
  }

  private String sizes() {
    SourceLines text = new SourceLines();
    text.line("/* Sizes of what the steps of this model watch: see mech_watch.h. */");
    text.line("#ifndef MECH_WATCH_TAPE_H").line("#define MECH_WATCH_TAPE_H").blank();
    text.line("enum {");
    size(text, "QUANTITIES", watch.quantityCount());
    size(text, "LEAVES", tape.leafSlots().size());
    size(text, "SLOTS", tape.initial().size());
    size(text, "STEPS", tape.steps().size());
    size(text, "FORMULAS", tape.resultSlots().size());
    size(text, "CHOICES", tape.choices().size());
    size(text, "TURNS", watch.turns().size());
    size(text, "OVERLAPS", watch.contacts().size());
    text.line("  /* Whether a formula can be large over a short way without a choice. */");
    text.line("  WATCH_NARROW = " + (tape.canBeNarrow() ? 1 : 0));
    text.line("};").blank();
    return text.line("#endif").toString();
  }

  private static void size(SourceLines text, String name, int value) {
    text.line("  WATCH_" + name + " = " + value + ",");
  }

  private String arrays() {
    SourceLines text = new SourceLines();
    text.line("/* The tape of the formulas that the steps of this model watch; generated. */");
    text.line("#include \"mech_watch.h\"").blank();
    CArrays arrays = CArrays.shared(text, new NumberText());
    text.line("const mech_watch_step WATCH_STEP_OF[] = {");
    for (TapeListing.Step step : tape.steps()) {
      text.line(
          "    {WATCH_%s, %d, %d, %d, %d, %d},"
              .formatted(
                  step.operation().toUpperCase(Locale.ROOT),
                  step.target(),
                  step.first(),
                  step.second(),
                  table(step),
                  step.choice()));
    }
    if (tape.steps().isEmpty()) {
      text.line("    {WATCH_ADD, 0, 0, 0, 0, -1},");
    }
    text.line("};");
    text.line("const mech_watch_choice WATCH_CHOICE_OF[] = {");
    for (TapeListing.Choice choice : tape.choices()) {
      text.line("    {" + choice.step() + ", " + (choice.isSign() ? 1 : 0) + "},");
    }
    if (tape.choices().isEmpty()) {
      text.line("    {0, 0},");
    }
    text.line("};");
    text.line("const mech_watch_table WATCH_TABLE_OF[] = {");
    tables.forEach(one -> text.line("    " + one + ","));
    if (tables.isEmpty()) {
      text.line("    {0, 0, 0, 0, 0},");
    }
    text.line("};");
    arrays.doubles("WATCH_NUMBER", numbers);
    arrays.doubles("WATCH_INITIAL", tape.initial());
    arrays.integers("WATCH_LEAF_SLOT", tape.leafSlots());
    arrays.integers("WATCH_RESULT_SLOT", tape.resultSlots());
    List<Integer> ends = new ArrayList<>();
    List<Integer> rates = new ArrayList<>();
    for (List<Integer> turn : watch.turns()) {
      rates.addAll(turn);
      ends.add(rates.size());
    }
    arrays.integers("WATCH_TURN_END", ends);
    arrays.integers("WATCH_TURN_RATE", rates);
    arrays.texts("WATCH_CONTACT", watch.contacts());
    return text.toString();
  }

  /** Returns the number of a step's table, 0 if it has none; a new one is appended. */
  private int table(TapeListing.Step step) {
    if (step.curve().isPresent()) {
      return curves.computeIfAbsent(step.curve().get(), this::append);
    }
    return step.map().isPresent() ? maps.computeIfAbsent(step.map().get(), this::append) : 0;
  }

  private int append(TableCurve curve) {
    double[] knots = curve.knots();
    describe(curve.hasCorners(), curve.isBounded(), knots.length, 0);
    append(knots);
    List<double[]> columns = IntStream.rangeClosed(0, POWERS).mapToObj(curve::numbers).toList();
    for (int place = 0; place <= knots.length; place++) {
      for (double[] column : columns) {
        numbers.add(column[place]);
      }
    }
    return tables.size() - 1;
  }

  private int append(MapSurface map) {
    describe(map.hasCorners(), map.isBounded(), map.knots(0).length, map.knots(1).length);
    append(map.knots(0));
    append(map.knots(1));
    append(map.origins(0));
    append(map.origins(1));
    List<double[]> columns = new ArrayList<>();
    for (int i = 0; i < POWERS; i++) {
      for (int j = 0; j < POWERS; j++) {
        columns.add(map.coefficients(i, j));
      }
    }
    for (int cell = 0; cell < columns.get(0).length; cell++) {
      for (double[] column : columns) {
        numbers.add(column[cell]);
      }
    }
    return tables.size() - 1;
  }

  private void describe(boolean straight, boolean bounded, int points, int furtherPoints) {
    tables.add(
        "{%d, %d, %d, %d, %d}"
            .formatted(straight ? 1 : 0, bounded ? 1 : 0, points, furtherPoints, numbers.size()));
  }

  private void append(double[] more) {
    DoubleStream.of(more).forEach(numbers::add);
  }
}
