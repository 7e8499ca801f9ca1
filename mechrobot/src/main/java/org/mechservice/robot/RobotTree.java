package org.mechservice.robot;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.Mimic;
import org.mechservice.robot.Robot.Range;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The tree of a robot's links.
 *
 * @param root the link that is no joint's child
 * @param closing names of the joints that close loops: their child has another joint to the root
 * @param start start positions by joint name: the value nearest to zero within the limits; a mimic
 *     joint takes the value of the joint that it follows
 */
record RobotTree(String root, Set<String> closing, Map<String, Double> start) {
  RobotTree {
    closing = Set.copyOf(closing);
    start = Map.copyOf(start);
  }

  /** Returns the tree; it is not usable if there is an error. */
  static RobotTree of(Robot robot, Diagnostics diagnostics) {
    Reader reader = new Reader(robot, diagnostics);
    reader.requireLinks();
    String root = diagnostics.hasErrors() ? "" : reader.root();
    return new RobotTree(root, reader.closing, reader.start());
  }

  /** Returns whether a joint closes a loop of the tree. */
  boolean closes(Joint joint) {
    return closing.contains(joint.name());
  }

  private static final class Reader {
    private final Robot robot;
    private final Diagnostics diagnostics;
    private final Map<String, Link> links = new LinkedHashMap<>();
    private final Map<String, Joint> joints = new LinkedHashMap<>();
    private final Map<String, Joint> above = new HashMap<>();
    private final Set<String> closing = new HashSet<>();

    /** Links from which a way up to a root is known. */
    private final Set<String> rooted = new HashSet<>();

    Reader(Robot robot, Diagnostics diagnostics) {
      this.robot = robot;
      this.diagnostics = diagnostics;
      robot.links().forEach(link -> links.put(link.name(), link));
      robot.joints().forEach(joint -> joints.put(joint.name(), joint));
    }

    private void error(MessageCode code, Element element, String text) {
      diagnostics.error(code, element.position(), element.label() + ": " + text);
    }

    void requireLinks() {
      for (Joint joint : robot.joints()) {
        requireLink(joint, "parent", joint.parent());
        requireLink(joint, "child", joint.child());
      }
    }

    String root() {
      for (Joint joint : robot.joints()) {
        Joint other = above.putIfAbsent(joint.child(), joint);
        if (other != null && robot.format().mayCloseLoops()) {
          closing.add(joint.name());
        } else if (other != null) {
          error(
              MessageCode.ROBOT_TREE,
              joint.element(),
              Phrase.of(
                  "link %s is already the child of joint %s; the links of a robot form a tree",
                  Quoted.of(joint.child()), Quoted.of(other.name())));
        }
      }
      List<String> roots = links.keySet().stream().filter(l -> !above.containsKey(l)).toList();
      if (roots.size() > 1) {
        error(
            MessageCode.ROBOT_TREE,
            element(roots.get(1)),
            Phrase.of(
                "neither it nor link %s is the child of a joint; a robot has one such link, its"
                    + " root",
                Quoted.of(roots.get(0))));
      }
      links.keySet().forEach(this::requireWayUp);
      return roots.isEmpty() ? "" : roots.get(0);
    }

    private Element element(String link) {
      return Optional.ofNullable(links.get(link)).orElseThrow().element();
    }

    private void requireLink(Joint joint, String end, String name) {
      if (!links.containsKey(name)) {
        error(
            MessageCode.UNKNOWN_NAME,
            joint.element(),
            Phrase.of(
                "its %s, link %s, does not exist%s",
                end, Quoted.of(name), NearestName.suggestion(name, links.keySet())));
      }
    }

    /** Reports links that form a cycle: they have no root. */
    private void requireWayUp(String link) {
      Set<String> seen = new HashSet<>(Set.of(link));
      Joint joint = above.get(link);
      while (joint != null && !rooted.contains(joint.parent())) {
        if (joint.parent().equals(link)) {
          error(
              MessageCode.ROBOT_TREE,
              joint.element(),
              Phrase.of(
                  "link %s is its own ancestor; the links of a robot form a tree",
                  Quoted.of(link)));
          return;
        }
        if (!seen.add(joint.parent())) {
          return; // the links of that cycle are reported themselves
        }
        joint = above.get(joint.parent());
      }
      rooted.addAll(seen);
    }

    /**
     * Returns the positions at the start: as near to the pose of the file as the limits allow, or,
     * of a robot with loops, that pose, because it closes them.
     */
    Map<String, Double> start() {
      Map<String, Double> start = new HashMap<>();
      robot.joints().stream()
          .filter(joint -> joint.type().isSingle())
          .forEach(joint -> start.put(joint.name(), position(joint, start, new HashSet<>())));
      return start;
    }

    private double position(Joint joint, Map<String, Double> known, Set<String> asked) {
      Double done = known.get(joint.name());
      if (done != null || joint.coordinate().mimic().isEmpty()) {
        boolean loops = !closing.isEmpty() || !robot.loops().isEmpty();
        Optional<Range> limits = joint.coordinate().limits().filter(range -> !loops);
        return done == null ? limits.map(Range::nearestToZero).orElse(0.0) : done;
      }
      Mimic mimic = joint.coordinate().mimic().get();
      Joint other = joints.get(mimic.joint());
      if (other == null || !other.type().isSingle()) {
        error(
            MessageCode.ROBOT_JOINT,
            mimic.element(),
            Phrase.of(
                other == null
                    ? "joint %s does not exist%s"
                    : "joint %s is fixed or has several coordinates, so there is none to follow%s",
                Quoted.of(mimic.joint()),
                other == null ? NearestName.suggestion(mimic.joint(), joints.keySet()) : ""));
        return 0;
      } else if (!asked.add(joint.name())) {
        error(
            MessageCode.ROBOT_JOINT,
            mimic.element(),
            "the joint follows itself through other mimic joints");
        return 0;
      }
      return mimic.multiplier() * position(other, known, asked) + mimic.offset();
    }
  }
}
