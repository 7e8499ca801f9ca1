package org.mechservice.mechml.resolve.body;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.mechanism.Mechanism;

/** The moving bodies in file order and their indices; the root is not among them. */
public final class BodyIndex {
  private final BodyDefinition root;
  private final List<BodyDefinition> moving = new ArrayList<>();
  private final Map<String, Integer> indices = new HashMap<>();

  /**
   * Numbers the bodies.
   *
   * @param bodies all bodies in file order
   * @param root one of them
   */
  public BodyIndex(List<BodyDefinition> bodies, BodyDefinition root) {
    this.root = root;
    indices.put(root.name(), Mechanism.ROOT);
    for (BodyDefinition body : bodies) {
      if (!body.name().equals(root.name())) {
        indices.putIfAbsent(body.name(), moving.size());
        moving.add(body);
      }
    }
  }

  public BodyDefinition root() {
    return root;
  }

  public List<BodyDefinition> moving() {
    return moving;
  }

  public int of(BodyDefinition body) {
    return indices.getOrDefault(body.name(), Mechanism.ROOT);
  }

  /** Returns a body's name. */
  public String name(int index) {
    return index == Mechanism.ROOT ? root.name() : moving.get(index).name();
  }
}
