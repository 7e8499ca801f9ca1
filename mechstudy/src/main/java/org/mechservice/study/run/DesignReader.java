package org.mechservice.study.run;

import java.util.List;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.document.Element;
import org.mechservice.study.design.Design;
import org.mechservice.study.design.Spread;

/** Reads how the points of a study are chosen. */
final class DesignReader {
  private static final List<String> DESIGNS =
      List.of("grid", "list", "sobol", "latin-hypercube", "monte-carlo", "indices");

  private static final int MOST_SOBOL_FACTORS = 1000;

  private final StudyDocument document;

  DesignReader(StudyDocument document) {
    this.document = document;
  }

  /** Returns the design; an empty one, and the document is told, if it cannot be used. */
  Design read(List<GivenFactor> factors) {
    Element root = document.root();
    List<Element> given = root.children("design");
    if (given.size() > 1) {
      document.error(given.get(1), "the study has two designs; write one");
    }
    Element element = given.isEmpty() ? root : given.get(0);
    String kind =
        given.isEmpty() ? "grid" : document.required(element, "kind", String.join(", ", DESIGNS));
    try {
      boolean tables = !root.children("table").isEmpty();
      if (tables && !given.isEmpty() && !kind.equals("list")) {
        throw new StudyRefusal("a table gives points as they are; its design is kind=\"list\"");
      }
      return design(element, tables ? "list" : kind, factors);
    } catch (StudyRefusal e) {
      document.error(e.at(element), "design: " + e.getMessage());
      return Design.list(List.of());
    } catch (IllegalArgumentException e) {
      document.error(element, "design: " + e.getMessage());
      return Design.list(List.of());
    }
  }

  private static Design design(Element element, String kind, List<GivenFactor> factors)
      throws StudyRefusal {
    List<Spread> spreads = factors.stream().map(GivenFactor::spread).toList();
    return switch (kind) {
      case "grid" -> Design.grid(levels(kind, factors, spreads));
      case "list" -> Design.list(ofEqualLength(factors, levels(kind, factors, spreads)));
      case "sobol" -> {
        if (spreads.size() > MOST_SOBOL_FACTORS) {
          throw new StudyRefusal("Sobol's sequence has 1000 factors at most; take monte-carlo");
        }
        yield Design.sobol(spreads, StudyValue.whole(element, "points", 1), seed(element, 0));
      }
      case "latin-hypercube" ->
          Design.latinHypercube(spreads, StudyValue.whole(element, "points", 1), seed(element, 1));
      case "monte-carlo" ->
          Design.monteCarlo(spreads, StudyValue.whole(element, "points", 1), seed(element, 1));
      case "indices" -> {
        if (2 * spreads.size() > MOST_SOBOL_FACTORS) {
          throw new StudyRefusal("indices have 500 factors at most");
        }
        yield Design.indices(spreads, StudyValue.whole(element, "points", 1), seed(element, 0));
      }
      default ->
          throw new StudyRefusal(
              "there is no design \""
                  + kind
                  + '"'
                  + NearestName.suggestion(kind, DESIGNS)
                  + "; there are "
                  + String.join(", ", DESIGNS));
    };
  }

  private static List<double[]> levels(String kind, List<GivenFactor> factors, List<Spread> spreads)
      throws StudyRefusal {
    List<double[]> levels = spreads.stream().map(Spread::levels).toList();
    for (int j = 0; j < levels.size(); j++) {
      if (levels.get(j).length == 0) {
        throw new StudyRefusal(
            factors.get(j).element(),
            "factor \""
                + factors.get(j).factor().name()
                + "\" has no single values; a "
                + kind
                + " needs count beside from and to, or values, or take another design such as"
                + " <design kind=\"sobol\" points=\"256\"/>");
      }
    }
    return levels;
  }

  private static List<double[]> ofEqualLength(List<GivenFactor> factors, List<double[]> levels)
      throws StudyRefusal {
    for (int j = 1; j < levels.size(); j++) {
      if (levels.get(j).length != levels.get(0).length) {
        throw new StudyRefusal(
            "the lists side by side have equal lengths; factor \""
                + factors.get(j).factor().name()
                + "\" has "
                + levels.get(j).length
                + " values, \""
                + factors.get(0).factor().name()
                + "\" has "
                + levels.get(0).length);
      }
    }
    return levels;
  }

  private static int seed(Element element, int without) throws StudyRefusal {
    return element.attribute("seed").isPresent() ? StudyValue.whole(element, "seed", 0) : without;
  }
}
