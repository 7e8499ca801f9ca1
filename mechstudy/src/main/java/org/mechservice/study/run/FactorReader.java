package org.mechservice.study.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.study.design.Spread;

/** Reads the factors of a study and their values, those of tables too. */
final class FactorReader {
  private final StudyDocument document;

  FactorReader(StudyDocument document) {
    this.document = document;
  }

  /** Returns the factors in their order; what is wrong with them is told to the document. */
  List<GivenFactor> read(MechModel model) {
    Element root = document.root();
    Map<String, ModelParameter> known =
        model.parameters().stream().collect(Collectors.toMap(ModelParameter::name, p -> p));
    List<GivenFactor> factors = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (Element element : root.children()) {
      try {
        if (element.name().equals("factor")) {
          String name = document.required(element, "name", "a parameter of the model");
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
      } catch (StudyRefusal e) {
        document.error(element, element.label() + ": " + e.getMessage());
      }
    }
    if (factors.isEmpty() && !document.hasErrors()) {
      document.error(
          root,
          "the study has no factor; write such as <factor name=\"damping\" from=\"500\" to=\"4500\""
              + " count=\"9\"/>");
    }
    return factors;
  }

  private static void addFactor(
      List<GivenFactor> factors,
      Set<String> taken,
      Element element,
      StudyFactor factor,
      Spread spread)
      throws StudyRefusal {
    if (!taken.add(factor.name())) {
      throw new StudyRefusal("factor \"" + factor.name() + "\" is given twice");
    }
    factors.add(new GivenFactor(element, factor, spread));
  }

  private static StudyFactor factor(Element element, String name, Map<String, ModelParameter> known)
      throws StudyRefusal {
    ModelParameter parameter = known.get(name);
    if (parameter == null) {
      throw new StudyRefusal(
          "the model has no parameter \""
              + name
              + '"'
              + NearestName.suggestion(name, known.keySet())
              + (known.isEmpty()
                  ? "; it has no <Parameters>"
                  : "; it has "
                      + known.keySet().stream().sorted().collect(Collectors.joining(", "))));
    }
    Unit own = StudyValue.unit(parameter.unit());
    String text = element.attribute("unit").map(String::strip).orElse(parameter.unit());
    Unit given = StudyValue.unit(text);
    if (!given.dimension().equals(own.dimension())) {
      throw new StudyRefusal(
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

  private static Spread spread(Element element) throws StudyRefusal {
    Optional<String> values = element.attribute("values");
    Optional<String> distribution = element.attribute("distribution").map(String::strip);
    if (values.isPresent() && (distribution.isPresent() || element.attribute("from").isPresent())) {
      throw new StudyRefusal("values stands beside from or distribution; write one of them");
    } else if (values.isPresent()) {
      List<Double> all = new ArrayList<>();
      for (String word : words(values.get())) {
        all.add(StudyValue.number(word, "value"));
      }
      return new Spread.Choice(all.stream().mapToDouble(Double::doubleValue).toArray());
    } else if (distribution.isEmpty()) {
      if (element.attribute("from").isEmpty()) {
        throw new StudyRefusal(
            "it has no values; write from=\"\" to=\"\" count=\"\", values=\"1 2 5\", or"
                + " distribution=\"normal\" mean=\"\" deviation=\"\"");
      }
      int count =
          element.attribute("count").isPresent() ? StudyValue.whole(element, "count", 1) : 0;
      return new Spread.Range(
          StudyValue.number(element, "from"), StudyValue.number(element, "to"), count);
    }
    try {
      return distribution(element, distribution.get());
    } catch (MathIllegalArgumentException e) {
      throw new StudyRefusal("the distribution is not possible: " + e.getMessage());
    }
  }

  /** Returns values that blanks, commas or semicolons separate. */
  private static List<String> words(String values) {
    List<String> words = new ArrayList<>(StudyValue.split(values, " \t\n\r,;"));
    words.removeIf(String::isBlank);
    return words;
  }

  private static Spread distribution(Element element, String kind) throws StudyRefusal {
    return switch (kind) {
      case "uniform" ->
          new Spread.Range(StudyValue.number(element, "from"), StudyValue.number(element, "to"), 0);
      case "normal" ->
          Spread.normal(
              StudyValue.number(element, "mean"), StudyValue.number(element, "deviation"));
      case "lognormal" -> {
        double mean = StudyValue.number(element, "mean");
        if (mean <= 0) {
          throw new StudyRefusal("the mean of a lognormal distribution is above 0");
        }
        yield Spread.lognormal(mean, StudyValue.number(element, "deviation"));
      }
      case "triangular" ->
          Spread.triangular(
              StudyValue.number(element, "from"),
              StudyValue.number(element, "mode"),
              StudyValue.number(element, "to"));
      default -> {
        List<String> known = List.of("uniform", "normal", "lognormal", "triangular");
        throw new StudyRefusal(
            "there is no distribution \""
                + kind
                + '"'
                + NearestName.suggestion(kind, known)
                + "; there are "
                + String.join(", ", known));
      }
    };
  }

  private Map<String, double[]> table(Element element) throws StudyRefusal {
    Path table = document.place(document.required(element, "file", "a CSV file"));
    List<String> lines;
    try {
      lines = Files.readAllLines(table).stream().filter(line -> !line.isBlank()).toList();
    } catch (IOException e) {
      throw new StudyRefusal(
          "the file " + table + " cannot be read; it is sought beside the study file");
    }
    if (lines.size() < 2) {
      throw new StudyRefusal(table + " has no row under its header, which names parameters");
    }
    List<String> names = CsvLine.cells(lines.get(0)).stream().map(String::strip).toList();
    Map<String, double[]> columns = new LinkedHashMap<>();
    names.forEach(name -> columns.put(name, new double[lines.size() - 1]));
    for (int i = 1; i < lines.size(); i++) {
      List<String> cells = CsvLine.cells(lines.get(i));
      if (cells.size() != names.size()) {
        throw new StudyRefusal(
            table + ": row " + i + " has " + cells.size() + " cells, the header " + names.size());
      }
      for (int j = 0; j < cells.size(); j++) {
        double[] column = columns.get(names.get(j));
        if (column != null) {
          column[i - 1] =
              StudyValue.number(cells.get(j), table + ": row " + i + ", " + names.get(j));
        }
      }
    }
    return columns;
  }
}
