package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.mechanism.Mechanism;

/** The moving bodies in file order and their indices; the root is not among them. */
final class BodyIndex {
  private final BodyParts root;
  private final List<BodyParts> moving = new ArrayList<>();
  private final Map<String, Integer> indices = new HashMap<>();

  /**
   * Numbers the bodies.
   *
   * @param bodies all bodies in file order
   * @param root one of them
   */
  BodyIndex(List<BodyParts> bodies, BodyParts root) {
    this.root = root;
    indices.put(root.name(), Mechanism.ROOT);
    for (BodyParts body : bodies) {
      if (!body.name().equals(root.name())) {
        indices.putIfAbsent(body.name(), moving.size());
        moving.add(body);
      }
    }
  }

  BodyParts root() {
    return root;
  }

  List<BodyParts> moving() {
    return moving;
  }

  int of(BodyParts body) {
    return indices.getOrDefault(body.name(), Mechanism.ROOT);
  }

  /** Returns a body's name. */
  String name(int index) {
    return index == Mechanism.ROOT ? root.name() : moving.get(index).name();
  }
}
