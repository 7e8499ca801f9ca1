package org.mechservice.study.run;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitException;
import org.mechservice.mechml.unit.UnitParser;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.SolverVersion;
import org.mechservice.solver.text.ModelFiles;
import org.mechservice.solver.text.Sha256;
import org.mechservice.study.PointModel;
import org.mechservice.study.Reduction;
import org.mechservice.study.design.Design;
import org.mechservice.study.design.Spread;

/** Reads a study file and checks it against its model. */
public final class StudyReader {
  private static final Map<String, Set<String>> ATTRIBUTES =
      Map.of(
          "study", Set.of("model", "simulation"),
          "factor",
              Set.of(
                  "name",
                  "unit",
                  "from",
                  "to",
                  "count",
                  "values",
                  "distribution",
                  "mean",
                  "deviation",
                  "mode"),
          "table", Set.of("file"),
          "design", Set.of("kind", "points", "seed"),
          "output", Set.of("name", "of", "unit", "failing"),
          "stop", Set.of("failures", "output", "error"));

  private static final List<String> DESIGNS =
      List.of("grid", "list", "sobol", "latin-hypercube", "monte-carlo", "indices");

  private static final int MOST_SOBOL_FACTORS = 1000;

  private final Path file;
  private final Diagnostics diagnostics;

  /** A factor with its values. */
  private record Read(Element element, StudyFactor factor, Spread spread) {}

  /** What is wrong with an element; the message says what to write. */
  private static final class Refusal extends Exception {
    private static final long serialVersionUID = 1L;

    private final transient Optional<Element> at;

    Refusal(String message) {
      super(message);
      at = Optional.empty();
    }

    /**
     * @param at an element other than the one that is read
     */
    Refusal(Element at, String message) {
      super(message);
      this.at = Optional.of(at);
    }
  }

  /** Places of files that are not beside the study, by the names that the study gives them. */
  private final Map<String, Path> places;

  private StudyReader(Path file, Map<String, Path> places) {
    this.file = file;
    this.places = places;
    diagnostics = new Diagnostics(file.toString());
  }

  /**
   * Reads a study.
   *
   * @param file XML file, or YAML file by the ending of its name; files that it names are sought
   *     beside it
   * @throws IOException if a file cannot be read
   * @throws MechmlException if the study or its model cannot be used; says what, where and what to
   *     write instead
   */
  public static StudyPlan read(Path file) throws IOException, MechmlException {
    return read(file, Map.of());
  }

  /**
   * Reads a study whose files are elsewhere.
   *
   * @param places of the files that it names, by these names; others are sought beside it
   */
  static StudyPlan read(Path file, Map<String, Path> places) throws IOException, MechmlException {
    return new StudyReader(file, places).read();
  }

  private Path place(String name) {
    return places.getOrDefault(name, file.resolveSibling(name));
  }

  private static boolean isYaml(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    return name.endsWith(".yaml") || name.endsWith(".yml");
  }

  private StudyPlan read() throws IOException, MechmlException {
    byte[] content = Files.readAllBytes(file);
    Element root =
        isYaml(file)
            ? YamlStudy.read(content, diagnostics)
            : DocumentReader.readForeign(content, diagnostics);
    if (!root.name().equals("study")) {
      error(root, "the outermost element is <" + root.name() + ">; that of a study is <study>");
    }
    diagnostics.throwIfErrors();
    checkNames(root);
    root.children().forEach(this::checkNames);
    String modelName = required(root, "model", "the model's file, such as model=\"seat.xml\"");
    diagnostics.throwIfErrors();
    Path modelFile = place(modelName);
    if (!Files.isRegularFile(modelFile)) {
      error(root, "there is no model file " + modelFile + "; it is sought beside the study file");
      diagnostics.throwIfErrors();
    }
    // By its simple name, as on a host: the code and its messages do not depend on the folder.
    MechModel model = MechModel.read(String.valueOf(modelFile.getFileName()), modelFile);
    Optional<String> simulation = root.attribute("simulation");
    if (simulation.isPresent()) {
      model = model.simulation(simulation.get());
    }
    List<Read> factors = factors(root, model);
    Design design = design(root, factors);
    List<Element> outputs = root.children("output");
    List<Reduction> reductions = reductions(root, outputs);
    diagnostics.throwIfErrors();
    PointModel points = points(root, model, factors, outputs, reductions);
    List<StudyOutput> columns = columns(outputs, reductions, points);
    StopRule stop = stop(root, columns);
    diagnostics.throwIfErrors();
    JsonObject identity =
        identity(root, content, modelFile, points, factors.stream().map(Read::factor).toList());
    identity.addProperty("points", design.size());
    return new StudyPlan(
        factors.stream().map(f -> f.factor.name()).toList(),
        design,
        factors.stream().map(Read::factor).toList(),
        columns,
        stop,
        points,
        modelFile,
        tables(root),
        identity);
  }

  private void error(Element at, String message) {
    diagnostics.error(MessageCode.STUDY_UNUSABLE, at.position(), message);
  }

  private void checkNames(Element element) {
    Set<String> known = ATTRIBUTES.get(element.name());
    if (known == null) {
      List<String> names = List.of("factor", "table", "design", "output", "stop");
      error(
          element,
          "a study has no element <"
              + element.name()
              + ">"
              + NearestName.suggestion(element.name(), names)
              + "; there are "
              + String.join(", ", names));
      return;
    }
    for (Attribute attribute : element.attributes()) {
      if (!known.contains(attribute.name())) {
        error(
            element,
            element.label()
                + " has no attribute "
                + attribute.name()
                + NearestName.suggestion(attribute.name(), known)
                + "; there are "
                + known.stream().sorted().collect(Collectors.joining(", ")));
      }
    }
    if (!element.name().equals("study")) {
      element
          .children()
          .forEach(child -> error(child, "<" + child.name() + "> stands directly in <study>"));
    }
  }

  private String required(Element element, String attribute, String what) {
    String value = element.attribute(attribute).map(String::strip).orElse("");
    if (value.isEmpty()) {
      error(element, element.label() + " lacks " + attribute + ": " + what);
    }
    return value;
  }

  private List<Read> factors(Element root, MechModel model) {
    Map<String, ModelParameter> known =
        model.parameters().stream().collect(Collectors.toMap(ModelParameter::name, p -> p));
    List<Read> factors = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (Element element : root.children()) {
      try {
        if (element.name().equals("factor")) {
          String name = required(element, "name", "a parameter of the model");
          if (!name.isEmpty()) {
            addFactor(factors, taken, element, factor(element, name, known), spread(element));
          }
        } else if (element.name().equals("table")) {
          for (Map.Entry<String, double[]> column : table(element).entrySet()) {
            addFactor(
                factors,
                taken,
                element,
                factor(element, column.getKey(), known),
                new Spread.Choice(column.getValue()));
          }
        }
      } catch (Refusal e) {
        error(element, element.label() + ": " + e.getMessage());
      }
    }
    if (factors.isEmpty() && !diagnostics.hasErrors()) {
      error(
          root,
          "the study has no factor; write such as <factor name=\"damping\" from=\"500\" to=\"4500\""
              + " count=\"9\"/>");
    }
    return factors;
  }

  private static void addFactor(
      List<Read> factors, Set<String> taken, Element element, StudyFactor factor, Spread spread)
      throws Refusal {
    if (!taken.add(factor.name())) {
      throw new Refusal("factor \"" + factor.name() + "\" is given twice");
    }
    factors.add(new Read(element, factor, spread));
  }

  private static StudyFactor factor(Element element, String name, Map<String, ModelParameter> known)
      throws Refusal {
    ModelParameter parameter = known.get(name);
    if (parameter == null) {
      throw new Refusal(
          "the model has no parameter \""
              + name
              + '"'
              + NearestName.suggestion(name, known.keySet())
              + (known.isEmpty()
                  ? "; it has no <Parameters>"
                  : "; it has "
                      + known.keySet().stream().sorted().collect(Collectors.joining(", "))));
    }
    Unit own = unit(parameter.unit());
    String text = element.attribute("unit").map(String::strip).orElse(parameter.unit());
    Unit given = unit(text);
    if (!given.dimension().equals(own.dimension())) {
      throw new Refusal(
          "unit \""
              + text
              + "\" is one of "
              + given.dimension()
              + "; the model gives parameter \""
              + name
              + "\" in \""
              + parameter.unit()
              + '"');
    }
    return new StudyFactor(name, text, given, own);
  }

  private static Unit unit(String text) throws Refusal {
    try {
      return UnitParser.parse(text);
    } catch (UnitException e) {
      throw new Refusal("unit " + e.reason());
    }
  }

  private static double number(Element element, String attribute) throws Refusal {
    String text =
        element
            .attribute(attribute)
            .map(String::strip)
            .orElseThrow(() -> new Refusal("it lacks " + attribute));
    return number(text, attribute);
  }

  private static double number(String text, String what) throws Refusal {
    try {
      double value = Double.parseDouble(text.strip());
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw new Refusal(what + " \"" + text.strip() + "\" is no number");
    }
    throw new Refusal(what + " \"" + text.strip() + "\" is not finite");
  }

  private static int whole(Element element, String attribute, int least) throws Refusal {
    String text = element.attribute(attribute).map(String::strip).orElse("");
    try {
      int value = Integer.parseInt(text);
      if (value >= least) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw new Refusal(
          text.isEmpty()
              ? "it lacks " + attribute
              : attribute + " \"" + text + "\" is no whole number that fits");
    }
    throw new Refusal(attribute + " is " + text + "; it is " + least + " or more");
  }

  private static Spread spread(Element element) throws Refusal {
    Optional<String> values = element.attribute("values");
    Optional<String> distribution = element.attribute("distribution").map(String::strip);
    if (values.isPresent() && (distribution.isPresent() || element.attribute("from").isPresent())) {
      throw new Refusal("values stands beside from or distribution; write one of them");
    } else if (values.isPresent()) {
      List<Double> all = new ArrayList<>();
      for (String word : values.get().strip().split("[\\s,;]+", -1)) {
        all.add(number(word, "value"));
      }
      return new Spread.Choice(all.stream().mapToDouble(Double::doubleValue).toArray());
    } else if (distribution.isEmpty()) {
      if (element.attribute("from").isEmpty()) {
        throw new Refusal(
            "it has no values; write from=\"\" to=\"\" count=\"\", values=\"1 2 5\", or"
                + " distribution=\"normal\" mean=\"\" deviation=\"\"");
      }
      int count = element.attribute("count").isPresent() ? whole(element, "count", 1) : 0;
      return new Spread.Range(number(element, "from"), number(element, "to"), count);
    }
    try {
      return distribution(element, distribution.get());
    } catch (MathIllegalArgumentException e) {
      throw new Refusal("the distribution is not possible: " + e.getMessage());
    }
  }

  private static Spread distribution(Element element, String kind) throws Refusal {
    return switch (kind) {
      case "uniform" -> new Spread.Range(number(element, "from"), number(element, "to"), 0);
      case "normal" -> Spread.normal(number(element, "mean"), number(element, "deviation"));
      case "lognormal" -> {
        double mean = number(element, "mean");
        if (mean <= 0) {
          throw new Refusal("the mean of a lognormal distribution is above 0");
        }
        yield Spread.lognormal(mean, number(element, "deviation"));
      }
      case "triangular" ->
          Spread.triangular(
              number(element, "from"), number(element, "mode"), number(element, "to"));
      default -> {
        List<String> known = List.of("uniform", "normal", "lognormal", "triangular");
        throw new Refusal(
            "there is no distribution \""
                + kind
                + '"'
                + NearestName.suggestion(kind, known)
                + "; there are "
                + String.join(", ", known));
      }
    };
  }

  private Map<String, double[]> table(Element element) throws Refusal {
    Path table = place(required(element, "file", "a CSV file"));
    List<String> lines;
    try {
      lines = Files.readAllLines(table).stream().filter(line -> !line.isBlank()).toList();
    } catch (IOException e) {
      throw new Refusal(
          "the file " + table + " cannot be read; it is sought beside the study file");
    }
    if (lines.size() < 2) {
      throw new Refusal(table + " has no row under its header, which names parameters");
    }
    List<String> names = CsvLine.cells(lines.get(0)).stream().map(String::strip).toList();
    Map<String, double[]> columns = new LinkedHashMap<>();
    names.forEach(name -> columns.put(name, new double[lines.size() - 1]));
    for (int i = 1; i < lines.size(); i++) {
      List<String> cells = CsvLine.cells(lines.get(i));
      if (cells.size() != names.size()) {
        throw new Refusal(
            table + ": row " + i + " has " + cells.size() + " cells, the header " + names.size());
      }
      for (int j = 0; j < cells.size(); j++) {
        double[] column = columns.get(names.get(j));
        if (column != null) {
          column[i - 1] = number(cells.get(j), table + ": row " + i + ", " + names.get(j));
        }
      }
    }
    return columns;
  }

  private Design design(Element root, List<Read> factors) {
    List<Element> given = root.children("design");
    if (given.size() > 1) {
      error(given.get(1), "the study has two designs; write one");
    }
    Element element = given.isEmpty() ? root : given.get(0);
    String kind = given.isEmpty() ? "grid" : required(element, "kind", String.join(", ", DESIGNS));
    try {
      boolean tables = !root.children("table").isEmpty();
      if (tables && !given.isEmpty() && !kind.equals("list")) {
        throw new Refusal("a table gives points as they are; its design is kind=\"list\"");
      }
      return design(element, tables ? "list" : kind, factors);
    } catch (Refusal e) {
      error(e.at.orElse(element), "design: " + e.getMessage());
      return Design.list(List.of());
    } catch (IllegalArgumentException e) {
      error(element, "design: " + e.getMessage());
      return Design.list(List.of());
    }
  }

  private static Design design(Element element, String kind, List<Read> factors) throws Refusal {
    List<Spread> spreads = factors.stream().map(Read::spread).toList();
    return switch (kind) {
      case "grid" -> Design.grid(levels(kind, factors, spreads));
      case "list" -> Design.list(ofEqualLength(factors, levels(kind, factors, spreads)));
      case "sobol" -> {
        if (spreads.size() > MOST_SOBOL_FACTORS) {
          throw new Refusal("Sobol's sequence has 1000 factors at most; take monte-carlo");
        }
        yield Design.sobol(spreads, whole(element, "points", 1), seed(element, 0));
      }
      case "latin-hypercube" ->
          Design.latinHypercube(spreads, whole(element, "points", 1), seed(element, 1));
      case "monte-carlo" ->
          Design.monteCarlo(spreads, whole(element, "points", 1), seed(element, 1));
      case "indices" -> {
        if (2 * spreads.size() > MOST_SOBOL_FACTORS) {
          throw new Refusal("indices have 500 factors at most");
        }
        yield Design.indices(spreads, whole(element, "points", 1), seed(element, 0));
      }
      default ->
          throw new Refusal(
              "there is no design \""
                  + kind
                  + '"'
                  + NearestName.suggestion(kind, DESIGNS)
                  + "; there are "
                  + String.join(", ", DESIGNS));
    };
  }

  private static List<double[]> levels(String kind, List<Read> factors, List<Spread> spreads)
      throws Refusal {
    List<double[]> levels = spreads.stream().map(Spread::levels).toList();
    for (int j = 0; j < levels.size(); j++) {
      if (levels.get(j).length == 0) {
        throw new Refusal(
            factors.get(j).element,
            "factor \""
                + factors.get(j).factor.name()
                + "\" has no single values; a "
                + kind
                + " needs count beside from and to, or values, or take another design such as"
                + " <design kind=\"sobol\" points=\"256\"/>");
      }
    }
    return levels;
  }

  private static List<double[]> ofEqualLength(List<Read> factors, List<double[]> levels)
      throws Refusal {
    for (int j = 1; j < levels.size(); j++) {
      if (levels.get(j).length != levels.get(0).length) {
        throw new Refusal(
            "the lists side by side have equal lengths; factor \""
                + factors.get(j).factor.name()
                + "\" has "
                + levels.get(j).length
                + " values, \""
                + factors.get(0).factor.name()
                + "\" has "
                + levels.get(0).length);
      }
    }
    return levels;
  }

  private static int seed(Element element, int without) throws Refusal {
    return element.attribute("seed").isPresent() ? whole(element, "seed", 0) : without;
  }

  private List<Reduction> reductions(Element root, List<Element> outputs) {
    List<Reduction> reductions = new ArrayList<>();
    if (outputs.isEmpty()) {
      error(root, "the study has no output; write such as <output of=\"max(height.a)\"/>");
    }
    for (Element output : outputs) {
      String text = required(output, "of", "a reduction of a column, such as max(height.a)");
      if (text.isEmpty()) {
        continue;
      }
      try {
        reductions.add(Reduction.parse(text));
      } catch (IllegalArgumentException e) {
        error(output, "of=\"" + text + "\": " + e.getMessage());
      }
    }
    return reductions;
  }

  private PointModel points(
      Element root,
      MechModel model,
      List<Read> factors,
      List<Element> outputs,
      List<Reduction> reductions)
      throws MechmlException {
    List<String> names = factors.stream().map(f -> f.factor.name()).toList();
    for (int i = 0; i < outputs.size(); i++) {
      try {
        PointModel.of(model, List.of(), reductions.subList(i, i + 1));
      } catch (IllegalArgumentException e) {
        error(outputs.get(i), String.valueOf(e.getMessage()));
      }
    }
    diagnostics.throwIfErrors();
    try {
      return PointModel.of(model, names, reductions);
    } catch (IllegalArgumentException e) {
      error(root, String.valueOf(e.getMessage()));
      diagnostics.throwIfErrors();
      throw e;
    }
  }

  private List<StudyOutput> columns(
      List<Element> outputs, List<Reduction> reductions, PointModel points) {
    List<StudyOutput> columns = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (int i = 0; i < points.names().size(); i++) {
      Reduction origin = points.origins().get(i);
      Element element = outputs.get(reductions.indexOf(origin));
      String column = points.names().get(i);
      String name =
          element
              .attribute("name")
              .map(String::strip)
              .map(
                  n ->
                      column.startsWith(origin.column() + "@")
                          ? n + column.substring(origin.column().length())
                          : n)
              .orElse(column);
      if (!taken.add(name)) {
        error(element, "there are two outputs \"" + name + "\"; give one another name");
      }
      try {
        columns.add(column(element, name, column, points.units().get(i)));
      } catch (Refusal e) {
        error(element, element.label() + ": " + e.getMessage());
      }
    }
    return columns;
  }

  private static StudyOutput column(Element element, String name, String of, String si)
      throws Refusal {
    OptionalDouble failing =
        element.attribute("failing").isPresent()
            ? OptionalDouble.of(number(element, "failing"))
            : OptionalDouble.empty();
    Optional<String> wanted = element.attribute("unit").map(String::strip);
    if (wanted.isEmpty()) {
      return new StudyOutput(name, of, si, Unit.ONE, failing);
    }
    Unit scale = unit(wanted.get());
    if (!scale.dimension().equals(unit(si).dimension())) {
      throw new Refusal(
          "unit \""
              + wanted.get()
              + "\" is one of "
              + scale.dimension()
              + "; "
              + of
              + " is in "
              + si);
    }
    return new StudyOutput(name, of, wanted.get(), scale, failing);
  }

  private StopRule stop(Element root, List<StudyOutput> columns) {
    List<Element> given = root.children("stop");
    if (given.isEmpty()) {
      return StopRule.NONE;
    } else if (given.size() > 1) {
      error(
          given.get(1),
          "the study has two elements <stop>; write failures, output and error in one");
      return StopRule.NONE;
    }
    Element stop = given.get(0);
    try {
      int failures = stop.attribute("failures").isPresent() ? whole(stop, "failures", 1) : 0;
      if (stop.attribute("output").isEmpty() && stop.attribute("error").isEmpty()) {
        if (failures == 0) {
          throw new Refusal(
              "it says nothing; write failures=\"10\", or output=\"NAME\" error=\"0.01\"");
        }
        return new StopRule(failures, -1, 0);
      }
      String name = required(stop, "output", "the output whose mean is to be known");
      List<String> names = columns.stream().map(StudyOutput::name).toList();
      if (!names.contains(name)) {
        throw new Refusal(
            "there is no output \""
                + name
                + '"'
                + NearestName.suggestion(name, names)
                + "; there are "
                + String.join(", ", names));
      }
      double error = number(stop, "error");
      if (error <= 0) {
        throw new Refusal("error is above 0");
      }
      return new StopRule(failures, names.indexOf(name), error);
    } catch (Refusal e) {
      error(stop, "stop: " + e.getMessage());
      return StopRule.NONE;
    }
  }

  private static List<String> tables(Element root) {
    return root.children("table").stream()
        .map(table -> table.attribute("file").map(String::strip).orElse(""))
        .toList();
  }

  private JsonObject identity(
      Element root, byte[] content, Path modelFile, PointModel points, List<StudyFactor> factors)
      throws IOException {
    JsonObject identity = new JsonObject();
    identity.addProperty("study", String.valueOf(file.getFileName()));
    identity.addProperty("studySha256", Sha256.of(content));
    JsonArray tables = new JsonArray();
    for (String table : tables(root)) {
      tables.add(Sha256.of(Files.readAllBytes(place(table))));
    }
    identity.add("tablesSha256", tables);
    identity.addProperty("model", root.attribute("model").map(String::strip).orElse(""));
    byte[] model = ModelFiles.inlined(Files.readAllBytes(modelFile), modelFile);
    identity.addProperty("modelSha256", Sha256.of(model));
    identity.addProperty("codeSha256", points.model().sha256());
    identity.addProperty("version", SolverVersion.CURRENT);
    root.attribute("simulation").ifPresent(name -> identity.addProperty("simulation", name));
    identity.add("design", attributes(root.children("design")));
    identity.add("factors", attributes(root.children("factor")));
    identity.add("outputs", attributes(root.children("output")));
    identity.add("stop", attributes(root.children("stop")));
    JsonObject units = new JsonObject();
    factors.forEach(factor -> units.addProperty(factor.name(), factor.unit()));
    identity.add("units", units);
    return identity;
  }

  private static JsonElement attributes(List<Element> elements) {
    JsonArray all = new JsonArray();
    for (Element element : elements) {
      JsonObject one = new JsonObject();
      element.attributes().forEach(a -> one.addProperty(a.name(), a.value()));
      all.add(one);
    }
    return all;
  }
}
