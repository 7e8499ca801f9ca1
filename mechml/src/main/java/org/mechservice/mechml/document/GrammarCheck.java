package org.mechservice.mechml.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.solver.catalogue.MessageCode;

/** Compares a file with the grammar and reports each difference. */
final class GrammarCheck {
  private final Grammar grammar;
  private final Diagnostics diagnostics;

  GrammarCheck(Grammar grammar, Diagnostics diagnostics) {
    this.grammar = grammar;
    this.diagnostics = diagnostics;
  }

  /**
   * Reports the errors of an element and of all elements in it.
   *
   * @param element an element of the grammar
   */
  void check(Element element) {
    ContentModel content = grammar.content(element.name()).orElseThrow();
    checkAttributes(element);
    checkContent(element, content);
    for (Element child : element.children()) {
      if (!diagnostics.isFull() && grammar.content(child.name()).isPresent()) {
        check(child);
      }
    }
  }

  /** Reports the attributes of an element, and not what it lacks: it may be under construction. */
  void checkGivenAttributes(Element element) {
    checkGiven(element, lacking(element, grammar.attributes(element.name())));
  }

  /**
   * Returns the last place among the children of an element under construction where the grammar
   * allows another one; reports it if there is none.
   *
   * @param parent an element of the grammar
   */
  OptionalInt place(Element parent, Element child) {
    ContentModel content = grammar.content(parent.name()).orElseThrow();
    if (grammar.content(child.name()).isEmpty()) {
      unknownElement(parent, child, content);
      return OptionalInt.empty();
    }
    List<String> names = parent.children().stream().map(Element::name).toList();
    for (int place = names.size(); place >= 0; place--) {
      List<String> all = new ArrayList<>(names);
      all.add(place, child.name());
      if (begins(content, all)) {
        return OptionalInt.of(place);
      }
    }
    misplaced(parent, child, content);
    return OptionalInt.empty();
  }

  /** Returns whether further children can make valid content of these. */
  private static boolean begins(ContentModel content, List<String> children) {
    ContentModel rest = content.partial();
    for (String child : children) {
      if (!rest.next().contains(child)) {
        return false;
      }
      rest = rest.after(child);
    }
    return true;
  }

  private void checkAttributes(Element element) {
    Set<String> lacking = lacking(element, grammar.attributes(element.name()));
    checkGiven(element, lacking);
    for (String name : lacking) {
      error(
          MessageCode.MISSING_ATTRIBUTE,
          element,
          Phrase.of("attribute %s is missing", Quoted.of(name)));
    }
  }

  /** Removes those names from the lacking ones that were meant by unknown ones. */
  private void checkGiven(Element element, Set<String> lacking) {
    Map<String, Grammar.AttributeRule> rules = grammar.attributes(element.name());
    for (Attribute attribute : element.attributes()) {
      if (diagnostics.isFull()) {
        return;
      }
      Grammar.AttributeRule rule = rules.get(attribute.name());
      if (rule == null) {
        Optional<String> meant = meant(attribute.name(), rules.keySet(), lacking);
        unknownAttribute(element, attribute.name(), rules.keySet(), meant);
        meant.ifPresent(lacking::remove);
      } else if (!rule.choices().isEmpty() && !rule.choices().contains(attribute.value())) {
        notInList(element, attribute, rule);
      }
    }
  }

  private static Set<String> lacking(Element element, Map<String, Grammar.AttributeRule> rules) {
    Set<String> lacking = new LinkedHashSet<>();
    rules.forEach(
        (name, rule) -> {
          if (rule.required() && element.attribute(name).isEmpty()) {
            lacking.add(name);
          }
        });
    return lacking;
  }

  /**
   * Suggests the nearest known name; if there is none, the only required attribute that is missing.
   */
  private static Optional<String> meant(
      String name, Collection<String> known, Collection<String> lacking) {
    Optional<String> nearest = NearestName.of(name, known);
    return nearest.isEmpty() && lacking.size() == 1 ? lacking.stream().findFirst() : nearest;
  }

  private void unknownAttribute(
      Element element, String name, Collection<String> known, Optional<String> meant) {
    String hint =
        meant
            .map(n -> "; did you mean " + Quoted.of(n) + "?")
            .orElse(known.isEmpty() ? "; it has none" : "; it has " + String.join(", ", known));
    error(
        MessageCode.UNKNOWN_ATTRIBUTE,
        element,
        Phrase.of("<%s> has no attribute %s%s", element.name(), Quoted.of(name), hint));
  }

  private void notInList(Element element, Attribute attribute, Grammar.AttributeRule rule) {
    error(
        MessageCode.VALUE_NOT_IN_LIST,
        element,
        Phrase.of(
            "%s is %s; it must be one of %s%s",
            attribute.name(),
            Quoted.of(attribute.value()),
            String.join(", ", rule.choices()),
            ValueSuggestion.meant(attribute.value(), rule.choices())
                .map(meant -> "; did you mean " + Quoted.of(meant) + "?")
                .orElse("")));
  }

  /** Skips unknown and misplaced children, so that each error is reported once. */
  private void checkContent(Element element, ContentModel content) {
    ContentModel rest = content;
    Set<String> given = new HashSet<>();
    for (Element child : element.children()) {
      if (diagnostics.isFull()) {
        return;
      }
      given.add(child.name());
      if (grammar.content(child.name()).isEmpty()) {
        unknownElement(element, child, content);
        NearestName.of(child.name(), grammar.elements()).ifPresent(given::add);
      } else if (rest.next().contains(child.name())) {
        rest = rest.after(child.name());
      } else {
        misplaced(element, child, content);
      }
    }
    List<String> lacking = rest.required().stream().filter(name -> !given.contains(name)).toList();
    if (!lacking.isEmpty()) {
      error(
          MessageCode.WRONG_CONTENT,
          element,
          tags(lacking, " and ") + (lacking.size() == 1 ? " is missing" : " are missing"));
    }
  }

  private void unknownElement(Element parent, Element child, ContentModel content) {
    String hint =
        NearestName.of(child.name(), grammar.elements())
            .map(n -> "; did you mean <" + n + ">?")
            .orElse("; " + inside(parent, content));
    diagnostics.error(
        MessageCode.UNKNOWN_ELEMENT,
        child.position(),
        Phrase.of("<%s> is not an element of MechML%s", Quoted.plain(child.name()), hint));
  }

  private void misplaced(Element parent, Element child, ContentModel content) {
    String fault =
        content.names().contains(child.name())
            ? "is out of order or one too many; "
            : "does not belong here; ";
    diagnostics.error(
        MessageCode.WRONG_CONTENT,
        child.position(),
        Phrase.of("%s: <%s> %s%s", parent.label(), child.name(), fault, inside(parent, content)));
  }

  private static String inside(Element parent, ContentModel content) {
    Collection<String> allowed = content.names();
    String order = allowed.size() > 1 ? ", in this order, " : " ";
    return allowed.isEmpty()
        ? Phrase.of("<%s> is empty", parent.name())
        : Phrase.of("<%s> holds%s%s", parent.name(), order, content.listed(new LinkedHashSet<>()));
  }

  private static String tags(Collection<String> names, String separator) {
    return names.stream().map(n -> "<" + n + ">").collect(Collectors.joining(separator));
  }

  private void error(MessageCode code, Element element, String message) {
    diagnostics.error(code, element.position(), element.label() + ": " + message);
  }
}
