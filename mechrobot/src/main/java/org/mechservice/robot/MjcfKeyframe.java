package org.mechservice.robot;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Start;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The keyframes of an MJCF model: positions and velocities of all joints in file order. Source:
 * MuJoCo documentation, XML reference, {@code keyframe}, and Modeling, "Floating-point and
 * quaternions" for the order of the numbers.
 */
final class MjcfKeyframe {
  private final List<Joint> joints;
  private final Map<String, Double> references;
  private final RobotNumbers numbers;
  private final boolean alignsFree;
  private final Diagnostics diagnostics;
  private final ImportLosses losses;

  /**
   * @param joints in file order
   * @param references positions that the file's pose counts as, by joint, rad or m
   * @param alignsFree whether free joints are aligned that do not say so themselves
   */
  MjcfKeyframe(
      List<Joint> joints,
      Map<String, Double> references,
      boolean alignsFree,
      RobotNumbers numbers,
      Diagnostics diagnostics,
      ImportLosses losses) {
    this.joints = joints;
    this.references = references;
    this.alignsFree = alignsFree;
    this.numbers = numbers;
    this.diagnostics = diagnostics;
    this.losses = losses;
  }

  /**
   * Returns the start by joint; empty if no keyframe is asked for.
   *
   * @param wished name of a keyframe or its number from 0
   */
  Map<String, Start> read(Element mujoco, Optional<String> wished) {
    List<Element> keys =
        mujoco.children("keyframe").stream().flatMap(k -> k.children("key").stream()).toList();
    if (wished.isEmpty()) {
      keys.stream()
          .findFirst()
          .ifPresent(
              key ->
                  losses.picture(
                      key, "the robot starts in the pose of the file; --keyframe takes this one"));
      return Map.of();
    }
    List<String> names = new ArrayList<>();
    for (int i = 0; i < keys.size(); i++) {
      names.add(keys.get(i).attribute("name").orElse(String.valueOf(i)));
    }
    int at = names.indexOf(wished.get());
    if (at < 0 && wished.get().matches("\\d{1,6}")) {
      at = Integer.parseInt(wished.get());
    }
    if (at < 0 || at >= keys.size()) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          mujoco.position(),
          Phrase.of(
              "keyframe %s does not exist%s; the file has %s",
              Quoted.of(wished.get()),
              NearestName.suggestion(wished.get(), names),
              names.isEmpty() ? "none" : String.join(", ", names)));
      return Map.of();
    }
    return start(keys.get(at));
  }

  private Map<String, Start> start(Element key) {
    Optional<List<Double>> q = list(key, "qpos", true);
    Optional<List<Double>> v = list(key, "qvel", false);
    Map<String, Start> start = new LinkedHashMap<>();
    int atQ = 0;
    int atV = 0;
    for (Joint joint : joints) {
      int countQ = count(joint, true);
      int countV = count(joint, false);
      if (joint.type() == Freedom.FLOATING && isAligned(joint)) {
        losses.motion(
            key, "the place of " + Quoted.of(joint.name()) + " is left out: its joint is aligned");
      } else if (countQ > 0) {
        int fromQ = atQ;
        int fromV = atV;
        Optional<List<Double>> own = q.map(all -> all.subList(fromQ, fromQ + countQ));
        Optional<List<Double>> speed = v.map(all -> all.subList(fromV, fromV + countV));
        start.put(joint.name(), of(joint, own, speed));
      }
      atQ += countQ;
      atV += countV;
    }
    return start;
  }

  /** Returns whether MuJoCo counts a free joint from principal axes, which a key is in then. */
  private boolean isAligned(Joint joint) {
    String own = joint.element().attribute("align").orElse("auto");
    boolean last = joints.stream().noneMatch(other -> other.parent().equals(joint.child()));
    return last && (own.equals("true") || (own.equals("auto") && alignsFree));
  }

  private Optional<List<Double>> list(Element key, String name, boolean positions) {
    int all = joints.stream().mapToInt(joint -> count(joint, positions)).sum();
    return key.attribute(name).map(text -> numbers.read(key, name, text, all, all));
  }

  private static int count(Joint joint, boolean positions) {
    return switch (joint.type()) {
      case FLOATING -> positions ? 7 : 6;
      case SPHERICAL -> positions ? 4 : 3;
      case FIXED -> 0;
      default -> 1;
    };
  }

  private Start of(Joint joint, Optional<List<Double>> q, Optional<List<Double>> v) {
    Frame frame = joint.place().frame();
    if (joint.type() == Freedom.FLOATING) {
      // MuJoCo: position, quaternion; velocity in world axes, angular velocity in body axes.
      Frame pose = q.map(p -> new Frame(vector(p, 0), turn(p.subList(3, 7)))).orElse(frame);
      Vector3 spin = v.map(all -> pose.turn().apply(vector(all, 3))).orElse(Vector3.ZERO);
      Vector3 speed = v.map(all -> vector(all, 0)).orElse(Vector3.ZERO);
      Vector3 moved = pose.at().minus(joint.place().pointOnParent());
      List<Double> positions = new ArrayList<>(pose.eulerParameters());
      positions.addAll(List.of(moved.x(), moved.y(), moved.z()));
      return new Start(
          positions, List.of(spin.x(), spin.y(), spin.z(), speed.x(), speed.y(), speed.z()));
    }
    if (joint.type() == Freedom.SPHERICAL) {
      Rotation whole = q.map(p -> frame.turn().times(turn(p))).orElse(frame.turn());
      Vector3 spin = v.map(all -> whole.apply(vector(all, 0))).orElse(Vector3.ZERO);
      return new Start(
          new Frame(Vector3.ZERO, whole).eulerParameters(), List.of(spin.x(), spin.y(), spin.z()));
    }
    double reference = references.getOrDefault(joint.name(), 0.0);
    return new Start(
        List.of(q.map(p -> p.get(0) - reference).orElse(0.0)),
        List.of(v.map(all -> all.get(0)).orElse(0.0)));
  }

  private static Vector3 vector(List<Double> all, int from) {
    return new Vector3(all.get(from), all.get(from + 1), all.get(from + 2));
  }

  private static Rotation turn(List<Double> wxyz) {
    double[] e = wxyz.stream().mapToDouble(Double::doubleValue).toArray();
    return Frame.rotation(e[0], e[1], e[2], e[3]);
  }
}
