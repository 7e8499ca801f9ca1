package org.mechservice.mechml.urdf;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Place;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Content;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.text.ShortestDecimal;

/** An element of MechML that is being made, with the place of the one it is made from. */
final class Tag {
  private final String name;
  private final Place place;
  private final String owner;
  private final List<Attribute> attributes = new ArrayList<>();
  private final List<Content> content = new ArrayList<>();

  private Tag(String name, Place place, String owner) {
    this.name = name;
    this.place = place;
    this.owner = owner;
  }

  /** An element that the robot's file has no counterpart of. */
  Tag(String name) {
    this(name, Place.FILE, "");
  }

  /** An element made from another one. */
  static Tag of(String name, Element from) {
    return new Tag(name, from.place(), "");
  }

  /** An element made from another one, which messages name with the named one around it. */
  static Tag of(String name, Element from, Tag owner) {
    return new Tag(name, from.place(), owner.element().label());
  }

  Tag set(String attribute, String value) {
    attributes.add(new Attribute(attribute, value));
    return this;
  }

  Tag set(String attribute, double value) {
    // No sign at zero: it means nothing and reads oddly.
    return set(attribute, ShortestDecimal.format(value + 0.0));
  }

  Tag add(Element child) {
    content.add(child);
    return this;
  }

  Tag add(Tag child) {
    return add(child.element());
  }

  Tag addUnlessEmpty(Tag child) {
    return child.content.isEmpty() ? this : add(child);
  }

  Element element() {
    return new Element(name, attributes, content, place, owner);
  }

  /** Returns the element if there is anything in it. */
  Optional<Element> unlessEmpty() {
    return content.isEmpty() ? Optional.empty() : Optional.of(element());
  }
}
