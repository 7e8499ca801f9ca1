package org.mechservice.mechml.resolve;

import org.mechservice.solver.mechanism.Mechanism;

/** Which bodies hang together: disjoint sets of body indices, the root's included. */
final class BodyGroups {
  private final int[] parent;

  /** Begins with every body on its own. */
  BodyGroups(int bodies) {
    parent = new int[bodies + 1];
    for (int i = 0; i < parent.length; i++) {
      parent[i] = i;
    }
  }

  /** Returns whether two bodies hang together. */
  boolean areJoined(int body1, int body2) {
    return group(body1) == group(body2);
  }

  /** Returns a number that the bodies of one group share and no other body has. */
  int group(int body) {
    int i = body - Mechanism.ROOT;
    while (parent[i] != i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }

  /** Makes one group of those of two bodies. */
  void join(int body1, int body2) {
    parent[group(body1)] = group(body2);
  }
}
