package org.mechservice.library;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.Vocabulary;
import org.mechservice.mechml.unit.UnitException;
import org.mechservice.mechml.unit.UnitParser;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * An element of a model that a {@link MechanismBuilder} builds: its attributes and its children.
 * Every method throws {@link IllegalArgumentException} for what the grammar of MechML does not
 * allow; the message is the reader's, and begins with its code.
 *
 * @param <T> the class itself, which the methods return
 */
public abstract sealed class BuiltElement<T extends BuiltElement<T>>
    permits MechanismBuilder, BodyElement, ConnectionElement, SimulationElement, OtherElement {
  private final String name;
  private final Optional<BuiltElement<?>> parent;
  private final List<Attribute> attributes = new ArrayList<>();
  private final List<BuiltElement<?>> children = new ArrayList<>();

  BuiltElement(String name, Optional<BuiltElement<?>> parent) {
    this.name = name;
    this.parent = parent;
  }

  abstract T self();

  /**
   * Sets an attribute; a second value replaces the first.
   *
   * @param attribute its name in MechML
   * @param value a name, a word, or an expression of numbers and parameters
   * @throws IllegalArgumentException M-007 if the element has no such attribute, M-009 if the value
   *     is not in its list, M-023 if a unit is none
   */
  public T set(String attribute, String value) {
    Attribute given = new Attribute(attribute, value);
    refuseUnlessAllowed(given);
    put(given);
    return self();
  }

  private void put(Attribute given) {
    for (int i = 0; i < attributes.size(); i++) {
      if (attributes.get(i).name().equals(given.name())) {
        attributes.set(i, given);
        return;
      }
    }
    attributes.add(given);
  }

  /**
   * Sets an attribute to numbers, written so that they are read back exactly.
   *
   * @param attribute its name in MechML
   * @param values one, or the items of a list; in the unit of the attribute
   * @throws IllegalArgumentException as {@link #set(String, String)}; M-021 if one is not finite
   */
  public T set(String attribute, double... values) {
    return set(
        attribute,
        Arrays.stream(values)
            .mapToObj(value -> number(attribute, value))
            .collect(Collectors.joining(";")));
  }

  /**
   * Sets an attribute to a number and its unit beside it: as {@code kUnit} for {@code k} if there
   * is such an attribute, else as {@code unit}.
   *
   * @throws IllegalArgumentException as {@link #set(String, double...)}
   */
  public T set(String attribute, double value, String unit) {
    return set(attribute, number(attribute, value), unit);
  }

  /**
   * Sets an attribute to an expression and its unit beside it.
   *
   * @throws IllegalArgumentException as {@link #set(String, String)}
   */
  public T set(String attribute, String value, String unit) {
    String own = attribute + "Unit";
    Attribute given = new Attribute(attribute, value);
    Attribute measure =
        new Attribute(Vocabulary.attributes(name).contains(own) ? own : "unit", unit);
    refuseUnlessAllowed(given);
    refuseUnlessAllowed(measure);
    put(given);
    put(measure);
    return self();
  }

  /** Sets the attribute {@code unit}. */
  public T unit(String unit) {
    return set("unit", unit);
  }

  /**
   * Adds any element that the grammar allows in this one, at the last place where it may stand.
   *
   * @param element its name in MechML
   * @param attributes names and values in turn
   * @return the new element
   * @throws IllegalArgumentException M-006 if MechML has no such element, M-010 if it does not
   *     belong here; also as {@link #set(String, String)}
   */
  public OtherElement element(String element, String... attributes) {
    return add(new OtherElement(element, this), child -> child.setAll(attributes));
  }

  /**
   * Adds an element where the grammar allows it.
   *
   * @param child without attributes and children
   * @param values sets its attributes; if it refuses one, the element stays out
   */
  final <E extends BuiltElement<?>> E add(E child, Consumer<E> values) {
    Diagnostics faults = new Diagnostics(name);
    Element siblings = with(children.stream().map(BuiltElement::head).toList());
    OptionalInt place = Vocabulary.place(siblings, child.head(), faults);
    refuse(faults);
    values.accept(child);
    children.add(place.orElseThrow(), child);
    return child;
  }

  /**
   * Sets attributes.
   *
   * @param given names and values in turn
   */
  final void setAll(String... given) {
    if (given.length % 2 != 0) {
      throw new IllegalArgumentException(
          "attributes are names and values in turn; that of "
              + Quoted.of(given[given.length - 1])
              + " has no value");
    }
    for (int i = 0; i < given.length; i += 2) {
      set(given[i], given[i + 1]);
    }
  }

  /** Returns the first child of a name; adds it if there is none. */
  BuiltElement<?> section(String element) {
    for (BuiltElement<?> child : children) {
      if (child.name.equals(element)) {
        return child;
      }
    }
    return add(new OtherElement(element, this), child -> {});
  }

  final String name() {
    return name;
  }

  final List<BuiltElement<?>> children() {
    return children;
  }

  final Optional<String> attribute(String attribute) {
    return attributes.stream()
        .filter(a -> a.name().equals(attribute))
        .map(Attribute::value)
        .findFirst();
  }

  /** Returns it as an element of a document. */
  final Element built() {
    return with(children.stream().map(BuiltElement::built).toList());
  }

  /** Returns it without its children. */
  final Element head() {
    return with(List.of());
  }

  private Element with(List<Element> content) {
    return new Element(
        name,
        attributes,
        List.copyOf(content),
        new SourcePosition(0, 0, path()),
        parent.map(around -> around.head().ownerOfChildren()).orElse(""));
  }

  private String path() {
    String step = name + attribute("name").map(n -> "[" + n + "]").orElse("");
    return parent.map(around -> around.path() + "/").orElse("") + step;
  }

  private void refuseUnlessAllowed(Attribute given) {
    Element head = head();
    List<Attribute> all = new ArrayList<>(attributes);
    all.removeIf(one -> one.name().equals(given.name()));
    all.add(given);
    Element with = new Element(name, all, List.of(), head.position(), head.owner());
    Diagnostics faults = new Diagnostics(name);
    Vocabulary.checkAttributes(with, faults);
    if (!faults.hasErrors() && given.name().toLowerCase(Locale.ROOT).endsWith("unit")) {
      refuseUnlessUnit(with, given.value(), faults);
    }
    refuse(faults);
  }

  private static void refuseUnlessUnit(Element element, String unit, Diagnostics faults) {
    try {
      UnitParser.parse(unit.strip());
    } catch (UnitException e) {
      faults.error(
          MessageCode.UNKNOWN_UNIT, element.position(), element.label() + ": " + e.reason());
    }
  }

  private static void refuse(Diagnostics faults) {
    if (faults.hasErrors()) {
      throw new IllegalArgumentException(
          faults.inFileOrder().stream()
              .map(fault -> fault.code() + " " + fault.message())
              .collect(Collectors.joining("\n")));
    }
  }

  private String number(String attribute, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(
          Phrase.of(
              "%s %s: %s is %s; a number must be finite",
              MessageCode.EXPRESSION_VALUE, head().label(), attribute, value));
    }
    // Zero is written without a sign.
    return ShortestDecimal.format(value + 0.0);
  }
}
