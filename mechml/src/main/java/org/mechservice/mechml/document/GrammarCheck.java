package org.mechservice.mechml.document;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Nearest;
import org.mechservice.mechml.diagnosis.Quoted;

/** Says in words where a file departs from the grammar. */
final class GrammarCheck {
  private final Grammar grammar;
  private final Diagnostics diagnostics;

  GrammarCheck(Grammar grammar, Diagnostics diagnostics) {
    this.grammar = grammar;
    this.diagnostics = diagnostics;
  }

  /**
   * Reports what is wrong with an element the grammar knows, and with everything in it.
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

  private void checkAttributes(Element element) {
    Map<String, Grammar.AttributeRule> rules = grammar.attributes(element.name());
    for (Attribute attribute : element.attributes()) {
      if (diagnostics.isFull()) {
        return;
      }
      Grammar.AttributeRule rule = rules.get(attribute.name());
      if (rule == null) {
        unknownAttribute(element, attribute.name(), rules.keySet());
      } else if (!rule.choices().isEmpty() && !rule.choices().contains(attribute.value())) {
        notInList(element, attribute, rule);
      }
    }
    rules.forEach(
        (name, rule) -> {
          if (rule.required() && element.attribute(name).isEmpty()) {
            error(
                MessageCode.MISSING_ATTRIBUTE,
                element,
                "attribute %s is missing".formatted(Quoted.of(name)));
          }
        });
  }

  private void unknownAttribute(Element element, String name, Collection<String> known) {
    if (LaterLanguage.hasAttribute(element.name(), name)) {
      error(
          MessageCode.NOT_IN_THIS_VERSION,
          element,
          "attribute %s is not available; %s"
              .formatted(Quoted.of(name), LaterLanguage.PRESENT));
    } else {
      String hint =
          Nearest.of(name, known)
              .map(n -> "; did you mean " + Quoted.of(n) + "?")
              .orElse(known.isEmpty() ? "; it has none" : "; it has " + String.join(", ", known));
      error(
          MessageCode.UNKNOWN_ATTRIBUTE,
          element,
          "<%s> has no attribute %s%s".formatted(element.name(), Quoted.of(name), hint));
    }
  }

  private void notInList(Element element, Attribute attribute, Grammar.AttributeRule rule) {
    error(
        MessageCode.VALUE_NOT_IN_LIST,
        element,
        "%s is %s; it must be one of %s"
            .formatted(
                attribute.name(), Quoted.of(attribute.value()), String.join(", ", rule.choices())));
  }

  /** Unknown and misplaced children are passed over, so that each fault is reported once. */
  private void checkContent(Element element, ContentModel content) {
    ContentModel rest = content;
    for (Element child : element.children()) {
      if (diagnostics.isFull()) {
        return;
      }
      if (grammar.content(child.name()).isEmpty()) {
        unknownElement(element, child, content);
      } else if (rest.next().contains(child.name())) {
        rest = rest.after(child.name());
      } else {
        misplaced(element, child, content, rest);
      }
    }
    List<String> lacking =
        rest.required().stream().filter(name -> element.child(name).isEmpty()).toList();
    if (!lacking.isEmpty()) {
      error(MessageCode.WRONG_CONTENT, element, "lacks " + tags(lacking, " and "));
    }
  }

  private void unknownElement(Element parent, Element child, ContentModel content) {
    if (LaterLanguage.hasElement(child.name())) {
      diagnostics.error(
          MessageCode.NOT_IN_THIS_VERSION,
          child.place(),
          "<%s> is not available; %s".formatted(child.name(), LaterLanguage.PRESENT));
      return;
    }
    String hint =
        Nearest.of(child.name(), grammar.elements())
            .map(n -> "; did you mean <" + n + ">?")
            .orElse("; " + inside(parent, content));
    diagnostics.error(
        MessageCode.UNKNOWN_ELEMENT,
        child.place(),
        "<%s> is not an element of MechML%s".formatted(Quoted.plain(child.name()), hint));
  }

  private void misplaced(Element parent, Element child, ContentModel content, ContentModel rest) {
    boolean elsewhere = content.names().contains(child.name());
    String message;
    if (!elsewhere) {
      message =
          "<%s> does not belong into <%s>; %s"
              .formatted(child.name(), parent.name(), inside(parent, content));
    } else if (rest.next().isEmpty()) {
      message = "<%s> is one too many in <%s>".formatted(child.name(), parent.name());
    } else {
      message =
          "<%s> is out of order or one too many in <%s>; here may stand %s"
              .formatted(child.name(), parent.name(), tags(rest.next(), " or "));
    }
    diagnostics.error(MessageCode.WRONG_CONTENT, child.place(), prefix(parent) + message);
  }

  private static String inside(Element parent, ContentModel content) {
    Collection<String> allowed = content.names();
    return allowed.isEmpty()
        ? "<" + parent.name() + "> is empty"
        : "<%s> holds %s".formatted(parent.name(), tags(allowed, ", "));
  }

  private static String tags(Collection<String> names, String separator) {
    return names.stream().map(n -> "<" + n + ">").collect(Collectors.joining(separator));
  }

  private void error(MessageCode code, Element element, String message) {
    diagnostics.error(code, element.place(), element.label() + ": " + message);
  }

  private static String prefix(Element parent) {
    return parent.attribute("name").isPresent() ? parent.label() + ": " : "";
  }
}
