package org.mechservice.view.mesh;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A node of a VRML file: its type and the fields that the file gives. */
final class VrmlNode {
  final String type;
  private final Map<String, double[]> numbers = new HashMap<>();
  private final Map<String, List<VrmlNode>> nodes = new HashMap<>();

  VrmlNode(String type) {
    this.type = type;
  }

  void put(String field, double[] values) {
    numbers.put(field, values);
  }

  void add(String field, VrmlNode node) {
    nodes.computeIfAbsent(field, name -> new ArrayList<>()).add(node);
  }

  /** Returns the nodes of a field; empty if the file gives none. */
  List<VrmlNode> nodes(String field) {
    return nodes.getOrDefault(field, List.of());
  }

  /** Returns all numbers of a field; none if the file does not give it. */
  double[] numbers(String field) {
    return numbers.getOrDefault(field, new double[0]);
  }

  /**
   * Returns the numbers of a field of fixed length, or those that hold where the file is silent.
   *
   * @throws MeshException if the file gives fewer
   */
  double[] numbers(String field, double... otherwise) throws MeshException {
    double[] given = numbers.getOrDefault(field, otherwise);
    if (given.length < otherwise.length) {
      throw new MeshException(
          field + " of " + type + " has " + given.length + " numbers, not " + otherwise.length);
    }
    return given;
  }
}
