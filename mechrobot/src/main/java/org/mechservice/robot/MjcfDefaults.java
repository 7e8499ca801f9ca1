package org.mechservice.robot;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Element;

/**
 * Attributes of MJCF elements with their defaults: an element takes what it lacks from its class,
 * which takes it from the classes around it.
 */
final class MjcfDefaults {
  private static final String MAIN = "main";

  private final Map<String, Map<String, Map<String, String>>> classes = new HashMap<>();

  /** Reads the sections {@code default} of a file. */
  MjcfDefaults(Element mujoco) {
    classes.put(MAIN, new HashMap<>());
    for (Element section : mujoco.children("default")) {
      read(section, MAIN, true);
    }
  }

  private void read(Element section, String outer, boolean outermost) {
    String name = outermost ? MAIN : section.attribute("class").orElse(MAIN);
    Map<String, Map<String, String>> own = classes.computeIfAbsent(name, key -> new HashMap<>());
    classes.getOrDefault(outer, Map.of()).forEach((tag, values) -> inherit(own, tag, values));
    // Own values first, then the classes inside, which take what they lack from here.
    for (Element part : section.children()) {
      if (!part.name().equals("default")) {
        Map<String, String> values = own.computeIfAbsent(part.name(), key -> new HashMap<>());
        for (Attribute attribute : part.attributes()) {
          values.put(attribute.name(), attribute.value());
        }
      }
    }
    section.children("default").forEach(inner -> read(inner, name, false));
  }

  private static void inherit(
      Map<String, Map<String, String>> own, String tag, Map<String, String> values) {
    Map<String, String> kept = own.computeIfAbsent(tag, key -> new HashMap<>());
    values.forEach(kept::putIfAbsent);
  }

  /** Returns whether a class exists. */
  boolean has(String name) {
    return classes.containsKey(name);
  }

  /**
   * Returns an attribute of an element.
   *
   * @param childClass class of elements that name none, from the bodies around; empty for none
   */
  Optional<String> attribute(Element element, String name, Optional<String> childClass) {
    return element
        .attribute(name)
        .or(
            () ->
                Optional.ofNullable(
                    classes
                        .getOrDefault(
                            element.attribute("class").or(() -> childClass).orElse(MAIN), Map.of())
                        .getOrDefault(element.name(), Map.of())
                        .get(name)));
  }
}
