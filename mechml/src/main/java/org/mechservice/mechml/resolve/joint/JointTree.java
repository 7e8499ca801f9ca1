package org.mechservice.mechml.resolve.joint;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.BodyIndex;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Chooses the spanning tree: the joints of the tree, the joints that close loops and are cut, and
 * the direction of each joint from the root outwards.
 *
 * <p>Welds come first, then joints with an armature, then the other joints, each group in file
 * order. A joint whose bodies are already connected is cut. A joint marked {@code cut="true"} never
 * enters the tree.
 */
public final class JointTree {
  private final List<JointLink> links;
  private final BodyIndex index;
  private final BodyGroups groups;
  private final boolean[] cut;

  public JointTree(List<JointLink> links, BodyIndex index) {
    this.links = links;
    this.index = index;
    this.groups = new BodyGroups(index.moving().size());
    this.cut = new boolean[links.size()];
    for (int j : inOrderOfChoice()) {
      JointLink link = links.get(j);
      cut[j] = link.isCutAsked() || groups.areJoined(link.body1(), link.body2());
      if (!cut[j]) {
        groups.join(link.body1(), link.body2());
      }
    }
  }

  private List<Integer> inOrderOfChoice() {
    return IntStream.range(0, links.size())
        .boxed()
        .sorted(
            Comparator.comparing((Integer j) -> links.get(j).type() != JointType.W)
                .thenComparing(j -> !ArmatureReader.isGiven(links.get(j).element())))
        .toList();
  }

  /** Returns whether a joint closes a loop. */
  public boolean isCut(int joint) {
    return cut[joint];
  }

  /** Reports joints of a body with itself. */
  public void checkBodies(Diagnostics diagnostics) {
    for (JointLink link : links) {
      if (link.body1() == link.body2()) {
        diagnostics.error(
            MessageCode.JOINT_WITH_ITSELF,
            link.element().position(),
            Phrase.of(
                "%s: body1 and body2 are the same body, %s",
                link.element().label(), name(link.body1())));
      }
    }
  }

  /** Reports bodies that no chain of uncut joints connects with the root, once for each group. */
  public void checkConnection(Diagnostics diagnostics) {
    Map<Integer, List<Integer>> loose = new LinkedHashMap<>();
    for (int body = 0; body < index.moving().size(); body++) {
      if (!groups.areJoined(body, Mechanism.ROOT)) {
        loose.computeIfAbsent(groups.group(body), g -> new ArrayList<>()).add(body);
      }
    }
    for (List<Integer> group : loose.values()) {
      if (diagnostics.isFull()) {
        return;
      }
      Element first = index.moving().get(group.get(0)).element();
      diagnostics.error(
          MessageCode.NOT_CONNECTED,
          first.position(),
          Phrase.of(
              "%s: no chain of joints connects it with the root, %s%s%s",
              first.label(),
              name(Mechanism.ROOT),
              alsoLoose(group.size() - 1),
              cutBetween(group.get(0))));
    }
  }

  private String cutBetween(int body) {
    Optional<JointLink> bridge =
        links.stream()
            .filter(JointLink::isCutAsked)
            .filter(
                link ->
                    groups.areJoined(link.body1(), body) != groups.areJoined(link.body2(), body))
            .findFirst();
    return bridge
        .map(b -> "; " + b.element().label() + " would connect it, but it is cut=\"true\"")
        .orElse("");
  }

  /**
   * Returns the joints of the tree in file order, each from the body nearer the root outwards; all
   * must have been read and connect every body.
   */
  public List<Joint> outward() {
    boolean[] reversed = reversed();
    List<Joint> joints = new ArrayList<>();
    for (int j = 0; j < links.size(); j++) {
      if (!cut[j]) {
        Joint joint = links.get(j).joint().orElseThrow();
        joints.add(reversed[j] ? joint.reversed() : joint);
      }
    }
    return joints;
  }

  private boolean[] reversed() {
    List<List<Integer>> linksOf = linksOfBodies();
    boolean[] passed = cut.clone();
    boolean[] reversed = new boolean[links.size()];
    Deque<Integer> front = new ArrayDeque<>(List.of(Mechanism.ROOT));
    while (!front.isEmpty()) {
      int body = front.remove();
      for (int j : linksOf.get(body - Mechanism.ROOT)) {
        if (!passed[j]) {
          passed[j] = true;
          reversed[j] = links.get(j).body2() == body;
          front.add(reversed[j] ? links.get(j).body1() : links.get(j).body2());
        }
      }
    }
    return reversed;
  }

  private List<List<Integer>> linksOfBodies() {
    List<List<Integer>> linksOf = new ArrayList<>();
    for (int i = 0; i <= index.moving().size(); i++) {
      linksOf.add(new ArrayList<>());
    }
    for (int j = 0; j < links.size(); j++) {
      linksOf.get(links.get(j).body1() - Mechanism.ROOT).add(j);
      linksOf.get(links.get(j).body2() - Mechanism.ROOT).add(j);
    }
    return linksOf;
  }

  private static String alsoLoose(int others) {
    return others == 0
        ? ""
        : Phrase.of(" (nor from %d other%s joined to it)", others, others == 1 ? "" : "s");
  }

  private String name(int body) {
    return Quoted.of(index.name(body));
  }

  /** Connected groups of bodies: disjoint sets of body indices, including the root's. */
  private static final class BodyGroups {
    private final int[] parent;

    /** Begins with each body in a group of its own. */
    BodyGroups(int bodies) {
      parent = new int[bodies + 1];
      for (int i = 0; i < parent.length; i++) {
        parent[i] = i;
      }
    }

    /** Returns whether two bodies are connected. */
    boolean areJoined(int body1, int body2) {
      return group(body1) == group(body2);
    }

    /** Returns the number of a body's group. */
    int group(int body) {
      int i = body - Mechanism.ROOT;
      while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
      }
      return i;
    }

    /** Merges the groups of two bodies. */
    void join(int body1, int body2) {
      parent[group(body1)] = group(body2);
    }
  }
}
