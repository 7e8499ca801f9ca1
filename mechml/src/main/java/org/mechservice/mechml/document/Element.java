package org.mechservice.mechml.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.diagnosis.SourcePosition;

/**
 * An element of a model file.
 *
 * @param name name of the element, such as {@code joint}
 * @param attributes in file order
 * @param content elements, comments and text between its tags, in file order
 * @param position start of its tag
 * @param owner the nearest named element around it as {@link #label()} gives it, such as {@code
 *     body "bar1"}; empty if there is none
 */
public record Element(
    String name,
    List<Attribute> attributes,
    List<Content> content,
    SourcePosition position,
    String owner)
    implements Content {
  /** Elements whose name messages do not repeat, since they stand for the whole file. */
  private static final Set<String> NOT_OWNERS =
      Set.of("MechML", "MBSmodel", "robot", "sdf", "mujoco", "body1", "body2");

  public Element {
    attributes = List.copyOf(attributes);
    content = List.copyOf(content);
  }

  /** Returns the elements between its tags, in file order. */
  public List<Element> children() {
    List<Element> children = new ArrayList<>();
    for (Content part : content) {
      if (part instanceof Element child) {
        children.add(child);
      }
    }
    return children;
  }

  /** Returns the text between its tags, without white space at its ends; model files have none. */
  public String text() {
    StringBuilder all = new StringBuilder();
    for (Content part : content) {
      if (part instanceof Text piece) {
        all.append(all.isEmpty() ? "" : " ").append(piece.text());
      }
    }
    return all.toString();
  }

  /** Returns the text of an attribute; empty if the element lacks it. */
  public Optional<String> attribute(String attributeName) {
    for (Attribute attribute : attributes) {
      if (attribute.name().equals(attributeName)) {
        return Optional.of(attribute.value());
      }
    }
    return Optional.empty();
  }

  /**
   * Returns the text of an attribute that the grammar requires.
   *
   * @throws IllegalStateException if it is missing
   */
  public String required(String attributeName) {
    return attribute(attributeName)
        .orElseThrow(() -> new IllegalStateException(name + " lacks " + attributeName));
  }

  /** Returns the children of a name, in file order. */
  public List<Element> children(String childName) {
    return children().stream().filter(c -> c.name().equals(childName)).toList();
  }

  /** Returns the first child of a name. */
  public Optional<Element> child(String childName) {
    for (Element child : children()) {
      if (child.name().equals(childName)) {
        return Optional.of(child);
      }
    }
    return Optional.empty();
  }

  /**
   * Returns the first child of a name that the grammar requires.
   *
   * @throws IllegalStateException if it is missing
   */
  public Element requiredChild(String childName) {
    return child(childName)
        .orElseThrow(() -> new IllegalStateException(name + " lacks " + childName));
  }

  /** Returns its name in messages: {@code body "bar1": point "p2"}. */
  public String label() {
    return role() + attribute("name").map(n -> " " + Quoted.of(n)).orElse("");
  }

  /**
   * Returns its name in messages if its attribute {@code name} names another element: {@code joint
   * "j2": body2}.
   */
  public String role() {
    return owner.isEmpty() ? name : owner + ": " + name;
  }

  /** Returns {@link #owner} of the elements between its tags. */
  public String ownerOfChildren() {
    return attribute("name").isEmpty() || NOT_OWNERS.contains(name) ? owner : label();
  }
}
