package org.mechservice.mechml.resolve;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.LaterLanguage;
import org.mechservice.solver.mechanism.Mechanism;

/** Whether the joints form a tree, and which end of each is nearer the root. */
final class JointTree {
  private final List<JointLink> links;
  private final BodyIndex index;
  private final BodyGroups groups;

  JointTree(List<JointLink> links, BodyIndex index) {
    this.links = links;
    this.index = index;
    this.groups = new BodyGroups(index.moving().size());
  }

  /** Reports each joint of a body with itself and each that closes a loop with earlier ones. */
  void checkLoops(Diagnostics diagnostics) {
    for (JointLink link : links) {
      if (link.body1() == link.body2()) {
        diagnostics.error(
            MessageCode.JOINT_WITH_ITSELF,
            link.element().place(),
            Phrase.of(
                "%s: body1 and body2 are the same body, %s",
                link.element().label(), name(link.body1())));
      } else if (groups.areJoined(link.body1(), link.body2())) {
        diagnostics.error(
            MessageCode.LOOP,
            link.element().place(),
            Phrase.of(
                "%s closes a loop: %s and %s are connected already; %s",
                link.element().label(),
                name(link.body1()),
                name(link.body2()),
                LaterLanguage.PRESENT));
      }
      groups.join(link.body1(), link.body2());
    }
  }

  /** Reports bodies that no chain of joints connects with the root, once for each group. */
  void checkConnection(Diagnostics diagnostics) {
    Map<Integer, List<Element>> loose = new LinkedHashMap<>();
    for (int body = 0; body < index.moving().size(); body++) {
      if (!groups.areJoined(body, Mechanism.ROOT)) {
        loose
            .computeIfAbsent(groups.group(body), g -> new ArrayList<>())
            .add(index.moving().get(body).element());
      }
    }
    for (List<Element> group : loose.values()) {
      diagnostics.error(
          MessageCode.NOT_CONNECTED,
          group.get(0).place(),
          Phrase.of(
              "%s: no chain of joints leads from it to the root, %s%s",
              group.get(0).label(), name(Mechanism.ROOT), alsoLoose(group.size() - 1)));
    }
  }

  /**
   * Returns for each joint whether its body2 is the one nearer the root; the joints must form a
   * tree.
   */
  boolean[] reversed() {
    List<List<Integer>> linksOf = linksOfBodies();
    boolean[] passed = new boolean[links.size()];
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
}
