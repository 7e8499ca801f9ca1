package org.mechservice.mechml.document;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The elements and attributes of the DTD. */
final class Grammar {
  /**
   * Rule for the value of an attribute.
   *
   * @param required whether it must be given
   * @param choices the allowed values; empty if every text is allowed
   */
  record AttributeRule(boolean required, List<String> choices) {}

  private final Map<String, ContentModel> content = new LinkedHashMap<>();
  private final Map<String, Map<String, AttributeRule>> attributes = new LinkedHashMap<>();

  void addElement(String element, ContentModel model) {
    content.put(element, model);
  }

  void addAttribute(String element, String attribute, AttributeRule rule) {
    attributes.computeIfAbsent(element, e -> new LinkedHashMap<>()).put(attribute, rule);
  }

  /** Returns the content model of an element; empty if the DTD does not declare it. */
  Optional<ContentModel> content(String element) {
    return Optional.ofNullable(content.get(element));
  }

  /** Returns the names of all elements. */
  Set<String> elements() {
    return content.keySet();
  }

  /** Returns the attributes of an element, in the order of the DTD. */
  Map<String, AttributeRule> attributes(String element) {
    return attributes.getOrDefault(element, Map.of());
  }
}
