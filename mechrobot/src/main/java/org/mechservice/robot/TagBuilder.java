package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Content;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.text.ShortestDecimal;

/** Builds an element of MechML; it has the position of the URDF element that it comes from. */
final class TagBuilder {
  private final String name;
  private final SourcePosition position;
  private final String owner;
  private final List<Attribute> attributes = new ArrayList<>();
  private final List<Content> content = new ArrayList<>();

  private TagBuilder(String name, SourcePosition position, String owner) {
    this.name = name;
    this.position = position;
    this.owner = owner;
  }

  /** Begins an element without a counterpart in the robot's file. */
  TagBuilder(String name) {
    this(name, SourcePosition.FILE, "");
  }

  /** Begins an element from another one. */
  static TagBuilder of(String name, Element from) {
    return new TagBuilder(name, from.position(), "");
  }

  /** Begins an element from another one; messages name it with the named element around it. */
  static TagBuilder of(String name, Element from, TagBuilder owner) {
    return new TagBuilder(name, from.position(), owner.element().label());
  }

  TagBuilder set(String attribute, String value) {
    attributes.add(new Attribute(attribute, value));
    return this;
  }

  TagBuilder set(String attribute, double value) {
    // Zero is written without a sign.
    return set(attribute, ShortestDecimal.format(value + 0.0));
  }

  TagBuilder add(Element child) {
    content.add(child);
    return this;
  }

  TagBuilder add(TagBuilder child) {
    return add(child.element());
  }

  TagBuilder addUnlessEmpty(TagBuilder child) {
    return child.content.isEmpty() ? this : add(child);
  }

  Element element() {
    return new Element(name, attributes, content, position, owner);
  }
}
