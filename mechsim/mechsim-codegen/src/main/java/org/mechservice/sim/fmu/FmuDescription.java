package org.mechservice.sim.fmu;

import java.io.StringWriter;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.mechservice.solver.text.ShortestDecimal;

/** The files {@code modelDescription.xml} and {@code sources/buildDescription.xml} of an FMU. */
final class FmuDescription {
  /** What importers should know of closed loops. */
  private static final String LOOPS =
      "Closed loops stay on their assembly as far as the error test of the method leads; a position"
          + " in which a loop locks, or two of its assemblies meet, is not noticed.";

  /** The same of a model whose steps are searched. */
  private static final String SEARCHED =
      "Co-Simulation searches its steps for hits and other changes that their ends do not show. In"
          + " Model Exchange the importer takes the steps, and nothing searches them: keep them"
          + " shorter than what happens.";

  private static final String TOOL = "MechService";

  /** A variable with all that both versions say about it. */
  private record Entry(
      int reference,
      FmuVariable variable,
      String causality,
      String variability,
      String initial,
      int derivativeOf) {
    boolean hasStart() {
      return initial.equals("exact") || causality.equals("input");
    }
  }

  private final FmuModel model;
  private final FmiVersion version;
  private final String token;
  private final List<String> sourceNames;
  private final ValueReferences references;
  private final List<Entry> entries = new ArrayList<>();

  /** Place of each value reference among the variables, counted from 1. */
  private final Map<Integer, Integer> places = new HashMap<>();

  private FmuDescription(
      FmuModel model, FmiVersion version, String token, List<String> sourceNames) {
    this.model = model;
    this.version = version;
    this.token = token;
    this.sourceNames = sourceNames;
    this.references = ValueReferences.of(model);
    collect();
  }

  /**
   * Describes a model.
   *
   * @param token GUID or instantiation token
   * @param sourceNames C files to compile, in order
   */
  static String of(FmuModel model, FmiVersion version, String token, List<String> sourceNames) {
    return new FmuDescription(model, version, token, sourceNames).write();
  }

  /** Returns how to compile the sources, as FMI 3.0 states it. */
  static String build(FmuModel model, List<String> sourceNames) {
    return written(
        xml -> {
          start(xml, "fmiBuildDescription", "fmiVersion", "3.0");
          start(xml, "BuildConfiguration", "modelIdentifier", model.identifier());
          start(xml, "SourceFileSet", "language", "C99", "compilerOptions", "-ffp-contract=off");
          for (String name : sourceNames) {
            empty(xml, "SourceFile", "name", name);
          }
          xml.writeEndElement();
          xml.writeEndElement();
          xml.writeEndElement();
        });
  }

  private void collect() {
    Set<String> taken = new HashSet<>();
    Set<String> outputs = new HashSet<>();
    model.outputs().forEach(output -> outputs.add(output.name()));
    add(taken, new Entry(0, named("time", "s", "Time"), "independent", "continuous", "", -1));
    int reference = references.state();
    for (FmuVariable state : model.states()) {
      String causality = outputs.contains(state.name()) ? "output" : "local";
      add(taken, new Entry(reference++, state, causality, "continuous", "exact", -1));
    }
    for (int i = 0; i < model.states().size(); i++) {
      FmuVariable state = model.states().get(i);
      String unit = state.unit().isEmpty() ? "1/s" : state.unit() + "/s";
      FmuVariable derivative =
          named("der(" + state.name() + ")", unit, "Derivative of " + state.name());
      add(
          taken,
          new Entry(
              references.derivative() + i,
              derivative,
              "local",
              "continuous",
              "calculated",
              references.state() + i));
    }
    reference = references.parameter();
    for (FmuVariable parameter : model.parameters()) {
      add(taken, new Entry(reference++, parameter, "parameter", "tunable", "exact", -1));
    }
    reference = references.input();
    for (FmuVariable input : model.inputs()) {
      add(taken, new Entry(reference++, input, "input", "continuous", "", -1));
    }
    Set<String> states = new HashSet<>();
    model.states().forEach(state -> states.add(state.name()));
    reference = references.output();
    for (FmuVariable output : model.outputs()) {
      if (!states.contains(output.name())) {
        add(taken, new Entry(reference, output, "output", "continuous", "calculated", -1));
      }
      reference++;
    }
    if (version == FmiVersion.FMI_3) {
      reference = references.indicator();
      for (String event : model.events()) {
        FmuVariable indicator = named("event(" + event + ")", "", "Event function of " + event);
        add(taken, new Entry(reference++, indicator, "local", "continuous", "calculated", -1));
      }
    }
  }

  private static FmuVariable named(String name, String unit, String description) {
    return new FmuVariable(name, unit, description, 0);
  }

  /** Adds a variable; one whose name is taken by another kind gets a number behind it. */
  private void add(Set<String> taken, Entry entry) {
    String name = entry.variable().name();
    for (int i = 2; !taken.add(name); i++) {
      name = entry.variable().name() + "_" + i;
    }
    FmuVariable old = entry.variable();
    FmuVariable unique = new FmuVariable(name, old.unit(), old.description(), old.start());
    entries.add(
        new Entry(
            entry.reference(),
            unique,
            entry.causality(),
            entry.variability(),
            entry.initial(),
            entry.derivativeOf()));
    places.put(entry.reference(), entries.size());
  }

  private int place(int reference) {
    return places.getOrDefault(reference, 0);
  }

  private String write() {
    return written(
        xml -> {
          boolean two = version == FmiVersion.FMI_2;
          start(
              xml,
              "fmiModelDescription",
              "fmiVersion",
              version.text(),
              "modelName",
              model.name(),
              two ? "guid" : "instantiationToken",
              token,
              "generationTool",
              TOOL,
              "variableNamingConvention",
              "flat");
          if (!notes().isEmpty()) {
            xml.writeAttribute("description", String.join(" ", notes()));
          }
          if (two) {
            xml.writeAttribute("numberOfEventIndicators", Integer.toString(model.events().size()));
          }
          kinds(xml);
          units(xml);
          categories(xml);
          FmuModel.Experiment run = model.experiment();
          empty(
              xml,
              "DefaultExperiment",
              "startTime",
              number(run.start()),
              "stopTime",
              number(run.end()),
              "tolerance",
              number(run.relativeTolerance()),
              "stepSize",
              number(run.step()));
          xml.writeStartElement("ModelVariables");
          for (Entry entry : entries) {
            variable(xml, entry);
          }
          xml.writeEndElement();
          xml.writeStartElement("ModelStructure");
          if (two) {
            structure2(xml);
          } else {
            structure3(xml);
          }
          xml.writeEndElement();
          xml.writeEndElement();
        });
  }

  /** Returns what an importer should know of the model. */
  private List<String> notes() {
    List<String> notes = new ArrayList<>();
    if (model.hasLoops()) {
      notes.add(LOOPS);
    }
    if (model.isWatched()) {
      notes.add(SEARCHED);
    }
    return notes;
  }

  private void kinds(XMLStreamWriter xml) throws XMLStreamException {
    if (version == FmiVersion.FMI_3) {
      for (String kind : List.of("ModelExchange", "CoSimulation")) {
        xml.writeEmptyElement(kind);
        xml.writeAttribute("modelIdentifier", model.identifier());
        xml.writeAttribute("canGetAndSetFMUState", "true");
        xml.writeAttribute("canSerializeFMUState", "true");
        xml.writeAttribute("providesDirectionalDerivatives", "true");
        if (kind.equals("ModelExchange")) {
          xml.writeAttribute("needsCompletedIntegratorStep", "true");
        } else {
          xml.writeAttribute("canHandleVariableCommunicationStepSize", "true");
        }
      }
      return;
    }
    for (String kind : List.of("ModelExchange", "CoSimulation")) {
      start(xml, kind, "modelIdentifier", model.identifier());
      if (kind.equals("CoSimulation")) {
        xml.writeAttribute("canHandleVariableCommunicationStepSize", "true");
      }
      xml.writeAttribute("canGetAndSetFMUstate", "true");
      xml.writeAttribute("canSerializeFMUstate", "true");
      xml.writeAttribute("providesDirectionalDerivative", "true");
      xml.writeStartElement("SourceFiles");
      for (String name : sourceNames) {
        empty(xml, "File", "name", name);
      }
      xml.writeEndElement();
      xml.writeEndElement();
    }
  }

  private void units(XMLStreamWriter xml) throws XMLStreamException {
    Set<String> units = new TreeSet<>();
    entries.forEach(entry -> units.add(unitOf(entry)));
    xml.writeStartElement("UnitDefinitions");
    for (String unit : units) {
      start(xml, "Unit", "name", unit);
      BaseUnits base = BaseUnits.of(unit).orElse(null);
      if (base != null) {
        xml.writeEmptyElement("BaseUnit");
        for (int i = 0; i < BaseUnits.BASE.size(); i++) {
          int power = base.powers().get(i);
          if (power != 0) {
            xml.writeAttribute(BaseUnits.BASE.get(i), Integer.toString(power));
          }
        }
      }
      xml.writeEndElement();
    }
    xml.writeEndElement();
  }

  private static String unitOf(Entry entry) {
    return entry.variable().unit().isEmpty() ? "1" : entry.variable().unit();
  }

  private static void categories(XMLStreamWriter xml) throws XMLStreamException {
    xml.writeStartElement("LogCategories");
    empty(xml, "Category", "name", "logAll", "description", "All messages");
    empty(xml, "Category", "name", "logStatusWarning", "description", "Warnings");
    empty(xml, "Category", "name", "logStatusDiscard", "description", "Values that do not exist");
    empty(xml, "Category", "name", "logStatusError", "description", "Errors");
    xml.writeEndElement();
  }

  private void variable(XMLStreamWriter xml, Entry entry) throws XMLStreamException {
    boolean two = version == FmiVersion.FMI_2;
    xml.writeStartElement(two ? "ScalarVariable" : "Float64");
    xml.writeAttribute("name", entry.variable().name());
    xml.writeAttribute("valueReference", Integer.toString(entry.reference()));
    if (!entry.variable().description().isEmpty()) {
      xml.writeAttribute("description", entry.variable().description());
    }
    xml.writeAttribute("causality", entry.causality());
    xml.writeAttribute("variability", entry.variability());
    if (!entry.initial().isEmpty()) {
      xml.writeAttribute("initial", entry.initial());
    }
    if (two) {
      xml.writeEmptyElement("Real");
    }
    xml.writeAttribute("unit", unitOf(entry));
    if (entry.derivativeOf() >= 0) {
      int of = two ? place(entry.derivativeOf()) : entry.derivativeOf();
      xml.writeAttribute("derivative", Integer.toString(of));
    }
    if (entry.hasStart()) {
      xml.writeAttribute("start", number(entry.variable().start()));
    }
    xml.writeEndElement();
  }

  /** Entries that an output's or derivative's value at the start is calculated for. */
  private boolean isInitialUnknown(Entry entry) {
    return entry.initial().equals("calculated") && !isIndicator(entry);
  }

  private boolean isIndicator(Entry entry) {
    return entry.reference() >= references.indicator();
  }

  private void structure2(XMLStreamWriter xml) throws XMLStreamException {
    unknowns2(xml, "Outputs", entry -> entry.causality().equals("output"));
    unknowns2(xml, "Derivatives", entry -> entry.derivativeOf() >= 0);
    unknowns2(xml, "InitialUnknowns", this::isInitialUnknown);
  }

  private void unknowns2(XMLStreamWriter xml, String group, Predicate<Entry> belongs)
      throws XMLStreamException {
    if (entries.stream().noneMatch(belongs)) {
      return;
    }
    xml.writeStartElement(group);
    for (Entry entry : entries) {
      if (belongs.test(entry)) {
        xml.writeEmptyElement("Unknown");
        xml.writeAttribute("index", Integer.toString(place(entry.reference())));
        if (isState(entry)) {
          xml.writeAttribute("dependencies", Integer.toString(place(entry.reference())));
          xml.writeAttribute("dependenciesKind", "constant");
        }
      }
    }
    xml.writeEndElement();
  }

  private boolean isState(Entry entry) {
    return entry.reference() >= references.state() && entry.reference() < references.derivative();
  }

  private void structure3(XMLStreamWriter xml) throws XMLStreamException {
    for (Entry entry : entries) {
      if (entry.causality().equals("output")) {
        unknown3(xml, "Output", entry);
      }
    }
    for (Entry entry : entries) {
      if (entry.derivativeOf() >= 0) {
        unknown3(xml, "ContinuousStateDerivative", entry);
      }
    }
    for (Entry entry : entries) {
      if (isInitialUnknown(entry)) {
        unknown3(xml, "InitialUnknown", entry);
      }
    }
    for (Entry entry : entries) {
      if (isIndicator(entry)) {
        unknown3(xml, "EventIndicator", entry);
      }
    }
  }

  private void unknown3(XMLStreamWriter xml, String element, Entry entry)
      throws XMLStreamException {
    xml.writeEmptyElement(element);
    xml.writeAttribute("valueReference", Integer.toString(entry.reference()));
    if (isState(entry)) {
      xml.writeAttribute("dependencies", Integer.toString(entry.reference()));
      xml.writeAttribute("dependenciesKind", "constant");
    }
  }

  private static String number(double value) {
    return ShortestDecimal.format(value);
  }

  private interface Content {
    void write(XMLStreamWriter xml) throws XMLStreamException;
  }

  private static String written(Content content) {
    StringWriter text = new StringWriter();
    try {
      XMLStreamWriter xml = XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(text);
      xml.writeStartDocument("UTF-8", "1.0");
      content.write(xml);
      xml.writeEndDocument();
      xml.flush();
    } catch (XMLStreamException e) {
      throw new IllegalStateException("text in memory can always be written", e);
    }
    return text.toString();
  }

  private static void start(XMLStreamWriter xml, String element, String... attributes)
      throws XMLStreamException {
    xml.writeStartElement(element);
    attributes(xml, attributes);
  }

  private static void empty(XMLStreamWriter xml, String element, String... attributes)
      throws XMLStreamException {
    xml.writeEmptyElement(element);
    attributes(xml, attributes);
  }

  private static void attributes(XMLStreamWriter xml, String... attributes)
      throws XMLStreamException {
    for (int i = 0; i < attributes.length; i += 2) {
      xml.writeAttribute(attributes[i], attributes[i + 1]);
    }
  }
}
