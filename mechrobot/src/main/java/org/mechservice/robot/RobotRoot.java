package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Freedom;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.Place;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;
import org.mechservice.solver.spatial.Vector3;

/**
 * The root of a robot in URDF: at rest, as Pinocchio and MuJoCo take it, or free, as Gazebo, Drake
 * and Bullet do. It is free where somebody asks for it, and where the robot is one link, since
 * nothing would move otherwise. A root named {@code world} is the world.
 */
final class RobotRoot {
  private static final String WORLD = "world";

  private RobotRoot() {}

  /**
   * Returns the robot with its root free if it is to be.
   *
   * @param floating whether somebody asks for it
   * @param notes receives what was chosen
   */
  static Robot of(Robot robot, boolean floating, String fileName, List<Diagnostic> notes) {
    if (robot.format() != RobotFormat.URDF) {
      return robot;
    }
    Set<String> below = new HashSet<>();
    robot.joints().forEach(joint -> below.add(joint.child()));
    List<Link> roots = robot.links().stream().filter(link -> !below.contains(link.name())).toList();
    if (roots.size() != 1 || roots.get(0).name().equals(WORLD)) {
      return robot;
    }
    Link root = roots.get(0);
    boolean free = floating || robot.joints().isEmpty();
    boolean heavy = root.inertial().filter(one -> one.mass() > 0).isPresent();
    if (free || heavy) {
      notes.add(note(root, free, floating, fileName));
    }
    return free ? freed(robot, root) : robot;
  }

  private static Diagnostic note(Link root, boolean free, boolean asked, String fileName) {
    String what =
        !free
            ? "the root rests, though it has mass; --floating lets it move freely"
            : asked ? "the root moves freely" : "the only link moves freely";
    return new Diagnostic(
        Severity.INFO,
        MessageCode.ROBOT_ROOT,
        "link " + Quoted.of(root.name()) + ": " + what,
        fileName,
        root.element().position().line(),
        root.element().position().column(),
        root.element().position().path());
  }

  private static Robot freed(Robot robot, Link root) {
    Set<String> taken = new HashSet<>();
    robot.links().forEach(link -> taken.add(link.name()));
    String world = free(WORLD, taken);
    Set<String> joints = new HashSet<>();
    robot.joints().forEach(joint -> joints.add(joint.name()));
    List<Link> links = new ArrayList<>();
    links.add(new Link(root.element(), world, Optional.empty()));
    links.addAll(robot.links());
    List<Joint> all = new ArrayList<>();
    all.add(
        new Joint(
            root.element(),
            free(root.name() + "_free", joints),
            Freedom.FLOATING,
            world,
            root.name(),
            Place.at(Frame.SAME, new Vector3(1, 0, 0)),
            Coordinate.FREE));
    all.addAll(robot.joints());
    return robot.with(links, all);
  }

  private static String free(String wished, Set<String> taken) {
    String name = wished;
    while (!taken.add(name)) {
      name += "_";
    }
    return name;
  }
}
