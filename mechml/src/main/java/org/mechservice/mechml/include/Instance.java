package org.mechservice.mechml.include;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Content;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;

/** One use of a subsystem: its elements with the names and values that the use gives them. */
final class Instance {
  /** Elements whose attribute {@code name} names another element. */
  private static final Set<String> ENDS = Set.of("body1", "body2", "plane", "via", "pulley");

  /** Attributes that are neither expressions nor names of the model's elements. */
  private static final Set<String> WORDS =
      Set.of(
          "type",
          "cut",
          "law",
          "frame",
          "side",
          "quantity",
          "method",
          "rotation",
          "extrapolation",
          "derivativeOf",
          "tunable",
          "fixed",
          "component",
          "fileName",
          "graphSrc",
          "file",
          "layout",
          "sha256",
          "xColumn",
          "yColumn",
          "unit",
          "prefix");

  /** Attributes that name a point or a vector of the body that stands beside them. */
  private static final Set<String> IN_BODY = Set.of("point", "vector", "vector2");

  /** Attributes that hold a name which a use may bind. */
  private static final Set<String> REFERENCES =
      Set.of("point", "vector", "vector2", "body1", "body2", "body", "joint");

  private final Element use;
  private final String file;
  private final Renaming names;
  private final Map<String, Element> given = new HashMap<>();
  private final Diagnostics diagnostics;

  /**
   * Prepares a use.
   *
   * @param use the element {@code include}
   * @param subsystem the outermost element of the included file
   */
  Instance(Element use, Element subsystem, Diagnostics diagnostics) {
    this.use = use;
    this.file = use.required("file");
    this.diagnostics = diagnostics;
    Map<String, String> bound = new HashMap<>();
    for (Element bind : use.children("bind")) {
      bound.put(bind.required("name"), bind.required("to"));
    }
    this.names = new Renaming(use.attribute("prefix").orElse(""), bound);
    for (Element section : subsystem.children()) {
      for (Element element : section.children()) {
        define(section, element);
      }
    }
    takeParameters();
  }

  private void define(Element section, Element element) {
    String name = element.attribute("name").orElse("");
    if (section.name().equals("Bodies")) {
      names.define(Renaming.Kind.BODY, name);
    } else if (section.name().equals("Joints")) {
      names.define(Renaming.Kind.JOINT, name);
    } else if (section.name().equals("Parameters") || section.name().equals("States")) {
      names.define(Renaming.Kind.VALUE, name);
    } else if (section.name().equals("Tables")) {
      names.define(Renaming.Kind.TABLE, name);
    }
  }

  private void takeParameters() {
    for (Element parameter : use.children("parameter")) {
      String name = parameter.required("name");
      if (names.defines(Renaming.Kind.VALUE, name)) {
        given.put(name, parameter);
      } else {
        diagnostics.error(
            MessageCode.UNKNOWN_NAME,
            parameter.position(),
            Phrase.of(
                "include names parameter %s, which %s does not have",
                Quoted.of(name), Quoted.of(file)));
      }
    }
  }

  /** Returns the elements of a section as they stand in the model. */
  List<Element> of(Element section) {
    List<Element> renamed = new ArrayList<>();
    for (Element element : section.children()) {
      renamed.add(renamed(element, section));
    }
    return renamed;
  }

  /** Reports names that the use binds in vain; ask after all sections have been renamed. */
  void checkBindings(Set<String> open) {
    Set<String> vain = names.unusedBindings();
    for (Element bind : use.children("bind")) {
      String name = bind.required("name");
      if (vain.contains(name)) {
        diagnostics.error(
            MessageCode.UNKNOWN_NAME,
            bind.position(),
            Phrase.of(
                "include binds the name %s, which %s does not leave open%s",
                Quoted.of(name),
                Quoted.of(file),
                NearestName.suggestion(name, open.stream().filter(this::isOpen).toList())));
      }
    }
  }

  private boolean isOpen(String name) {
    return !names.defines(Renaming.Kind.BODY, name) && !names.defines(Renaming.Kind.JOINT, name);
  }

  private Element renamed(Element element, Element section) {
    boolean isParameter = section.name().equals("Parameters");
    Element value = isParameter ? given.get(element.required("name")) : null;
    List<Attribute> attributes = new ArrayList<>();
    for (Attribute attribute : element.attributes()) {
      if (value != null && attribute.name().equals("value")) {
        attributes.add(new Attribute("value", value.required("value")));
      } else if (value != null
          && attribute.name().equals("unit")
          && value.attribute("unit").isPresent()) {
        attributes.add(new Attribute("unit", value.required("unit")));
      } else {
        attributes.add(new Attribute(attribute.name(), renamed(element, section, attribute)));
      }
    }
    if (value != null && element.attribute("unit").isEmpty()) {
      value.attribute("unit").ifPresent(unit -> attributes.add(new Attribute("unit", unit)));
    }
    List<Content> content = new ArrayList<>();
    for (Content part : element.content()) {
      content.add(part instanceof Element child ? renamed(child, section) : part);
    }
    return new Element(
        element.name(),
        attributes,
        content,
        value == null ? element.position() : value.position(),
        owner(element));
  }

  /** Messages name the elements by the names that they have in the model. */
  private String owner(Element element) {
    int quote = element.owner().indexOf('"');
    return quote < 0
        ? element.owner()
        : element.owner().substring(0, quote + 1) + names.own(element.owner().substring(quote + 1));
  }

  private String renamed(Element element, Element section, Attribute attribute) {
    String value = attribute.value();
    String name = attribute.name();
    if (WORDS.contains(name) || name.endsWith("Unit")) {
      return value;
    }
    if (name.equals("name")) {
      return renamedName(element, value);
    }
    if (name.equals("table")) {
      return names.reference(Renaming.Kind.TABLE, value);
    }
    if (name.equals("joint")) {
      return names.reference(Renaming.Kind.JOINT, value);
    }
    if (name.equals("body") || (element.name().equals("joint") && ENDS.contains(name))) {
      return names.reference(Renaming.Kind.BODY, value);
    }
    if (IN_BODY.contains(name) && !value.contains(";")) {
      return inBody(element, section, value);
    }
    if ((name.equals("from") || name.equals("to")) && !value.contains(";")) {
      return value;
    }
    return names.expression(value);
  }

  private String renamedName(Element element, String name) {
    return switch (element.name()) {
      case "body1", "body2" -> names.reference(Renaming.Kind.BODY, name);
      case "jointVal" -> names.reference(Renaming.Kind.JOINT, name);
      case "point", "vector" -> name;
      default -> names.own(name);
    };
  }

  /** Points of the subsystem's bodies keep their names; those of the model's may be bound. */
  private String inBody(Element element, Element section, String value) {
    String body = element.attribute(ENDS.contains(element.name()) ? "name" : "body").orElse("");
    boolean ofOwnBody = section.name().equals("Bodies") || names.defines(Renaming.Kind.BODY, body);
    return ofOwnBody ? value : names.bound(value);
  }

  /** Returns the names that the use may bind, for suggestions. */
  static Set<String> namesIn(Element subsystem) {
    Set<String> found = new HashSet<>();
    for (Element element : subsystem.children()) {
      element.attributes().stream()
          .filter(a -> REFERENCES.contains(a.name()) || ENDS.contains(element.name()))
          .forEach(a -> found.add(a.value()));
      found.addAll(namesIn(element));
    }
    return found;
  }
}
