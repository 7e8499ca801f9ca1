package org.mechservice.mechml.document;

import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;

/**
 * The choices that the grammar of MechML allows to a program that writes a document element by
 * element: at each step they are those that the reader of the whole file would accept. What is
 * still missing is no fault here.
 */
public final class Vocabulary {
  private static final Grammar GRAMMAR = DocumentReader.grammar();

  private Vocabulary() {}

  /** Returns the names of the attributes of an element, in the order of the DTD. */
  public static Set<String> attributes(String element) {
    return GRAMMAR.attributes(element).keySet();
  }

  /** Returns the names of the elements that an element may hold; none if there is no such one. */
  public static List<String> children(String element) {
    return GRAMMAR.content(element).map(content -> List.copyOf(content.names())).orElse(List.of());
  }

  /**
   * Reports the attributes that an element of MechML does not have, and the values that are not in
   * the list of an attribute.
   *
   * @param element an element of the grammar, perhaps without all of its attributes
   * @param diagnostics receives errors
   */
  public static void checkAttributes(Element element, Diagnostics diagnostics) {
    new GrammarCheck(GRAMMAR, diagnostics).checkGivenAttributes(element);
  }

  /**
   * Returns where a further child may stand: the last place that the grammar allows.
   *
   * @param parent an element of the grammar, perhaps without all of its children
   * @param child an element without children
   * @param diagnostics receives an error if there is no place, or no such element
   * @return index among the children of the parent; empty if there is none
   */
  public static OptionalInt place(Element parent, Element child, Diagnostics diagnostics) {
    return new GrammarCheck(GRAMMAR, diagnostics).place(parent, child);
  }
}
