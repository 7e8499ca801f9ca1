package org.mechservice.mechml.resolve.simulation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.NameRule;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.solver.catalogue.MessageCode;

/** Reads all {@code MBSsimulation} blocks and chooses one of them. */
public final class SimulationsReader {
  private static final Pattern NUMBER = Pattern.compile("[1-9][0-9]{0,5}");

  private final SimulationReader reader;
  private final Diagnostics diagnostics;

  /**
   * Prepares reading.
   *
   * @param events reads events; empty if the model could not be read, so that events are skipped
   */
  public SimulationsReader(
      ValueReader values, Optional<EventsReader> events, Diagnostics diagnostics) {
    this.reader = new SimulationReader(values, events, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the settings of the blocks without errors, in file order. */
  public List<SimulationSettings> read(List<Element> blocks) {
    checkNames(blocks);
    List<SimulationSettings> settings = new ArrayList<>();
    blocks.forEach(block -> reader.read(block).ifPresent(settings::add));
    return settings;
  }

  private void checkNames(List<Element> blocks) {
    Map<String, Element> named = new HashMap<>();
    for (Element block : blocks) {
      if (block.attribute("name").isEmpty()) {
        continue;
      }
      NameRule.check(block, diagnostics);
      Element first = named.putIfAbsent(block.required("name"), block);
      if (first != null) {
        diagnostics.error(
            MessageCode.DUPLICATE_NAME,
            block.position(),
            Phrase.of(
                "%s: line %d has a simulation with this name",
                block.label(), first.position().line()));
      }
    }
  }

  /**
   * Returns the index, from 0, of the block chosen by name or by number from 1; 0 if none is
   * chosen.
   */
  public int choose(List<Element> blocks, Optional<String> wanted) {
    OptionalInt index = index(blocks, wanted);
    if (index.isPresent()) {
      return index.getAsInt();
    }
    List<String> names = names(blocks);
    diagnostics.error(
        MessageCode.UNKNOWN_SIMULATION,
        SourcePosition.FILE,
        Phrase.of(
            "the file has no simulation %s; it has %s%s",
            Quoted.of(wanted.get()),
            listed(names),
            NearestName.suggestion(wanted.get(), named(names))));
    return 0;
  }

  /** Returns the index, from 0, of the chosen block; empty if there is no such block. */
  public static OptionalInt index(List<Element> blocks, Optional<String> wanted) {
    if (wanted.isEmpty()) {
      return OptionalInt.of(0);
    }
    int index = names(blocks).indexOf(wanted.get());
    if (index < 0 && NUMBER.matcher(wanted.get()).matches()) {
      index = Integer.parseInt(wanted.get()) - 1;
    }
    return index >= 0 && index < blocks.size() ? OptionalInt.of(index) : OptionalInt.empty();
  }

  private static List<String> names(List<Element> blocks) {
    return blocks.stream().map(b -> b.attribute("name").orElse("")).toList();
  }

  private static List<String> named(List<String> names) {
    return names.stream().filter(name -> !name.isEmpty()).toList();
  }

  private static String listed(List<String> names) {
    return String.join(
        ", ",
        IntStream.range(0, Math.min(names.size(), 10))
            .mapToObj(
                i -> (i + 1) + (names.get(i).isEmpty() ? "" : " (" + Quoted.of(names.get(i)) + ")"))
            .toList());
  }
}
