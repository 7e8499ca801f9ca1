package org.mechservice.study.run;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;

/** The elements of a study, from XML or YAML, and what is wrong with them. */
final class StudyDocument {
  private static final Map<String, Set<String>> ATTRIBUTES =
      Map.of(
          "study", Set.of("model", "simulation"),
          "run", RunElement.ATTRIBUTES,
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

  private final Path file;
  private final Map<String, Path> places;
  private final Diagnostics diagnostics;
  private final Element root;

  private StudyDocument(
      Path file, Map<String, Path> places, Diagnostics diagnostics, Element root) {
    this.file = file;
    this.places = places;
    this.diagnostics = diagnostics;
    this.root = root;
  }

  /**
   * Reads a document; all its elements and attributes are those of a study.
   *
   * @param file its name, by whose ending it is YAML; the files that it names are sought beside it
   * @param places of files that are elsewhere, by the names that the study gives them
   * @throws MechmlException if it is no study
   */
  static StudyDocument read(Path file, byte[] content, Map<String, Path> places)
      throws MechmlException {
    Diagnostics diagnostics = new Diagnostics(file.toString());
    Element root =
        isYaml(file)
            ? YamlStudy.read(content, diagnostics)
            : DocumentReader.readForeign(content, diagnostics);
    StudyDocument document = new StudyDocument(file, places, diagnostics, root);
    if (!root.name().equals("study")) {
      document.error(
          root, "the outermost element is <" + root.name() + ">; that of a study is <study>");
    }
    document.throwIfErrors();
    document.checkNames(root);
    root.children().forEach(document::checkNames);
    return document;
  }

  private static boolean isYaml(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    return name.endsWith(".yaml") || name.endsWith(".yml");
  }

  private void checkNames(Element element) {
    Set<String> known = ATTRIBUTES.get(element.name());
    if (known == null) {
      List<String> names = List.of("run", "factor", "table", "design", "output", "stop");
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

  Element root() {
    return root;
  }

  /** Returns the place of a file that the study names. */
  Path place(String name) {
    return places.getOrDefault(name, file.resolveSibling(name));
  }

  /** Returns an attribute that must be there; blank, after an error, if it is not. */
  String required(Element element, String attribute, String what) {
    String value = element.attribute(attribute).map(String::strip).orElse("");
    if (value.isEmpty()) {
      error(element, element.label() + " lacks " + attribute + ": " + what);
    }
    return value;
  }

  /** Notes what is wrong with an element. */
  void error(Element at, String message) {
    diagnostics.error(MessageCode.STUDY_UNUSABLE, at.position(), message);
  }

  boolean hasErrors() {
    return diagnostics.hasErrors();
  }

  void throwIfErrors() throws MechmlException {
    diagnostics.throwIfErrors();
  }
}
