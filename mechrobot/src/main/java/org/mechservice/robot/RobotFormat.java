package org.mechservice.robot;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.document.Element;

/** A format of robots that the import reads; the outermost element of a file tells it. */
public enum RobotFormat {
  /** Unified Robot Description Format of ROS: a tree of links. */
  URDF("URDF", "robot", false),
  /** Simulation Description Format of Gazebo; joints may close loops. */
  SDF("SDF", "sdf", true),
  /** The models of MuJoCo: nested bodies. */
  MJCF("MJCF", "mujoco", false);

  private final String title;
  private final String root;
  private final boolean loops;

  RobotFormat(String title, String root, boolean loops) {
    this.title = title;
    this.root = root;
    this.loops = loops;
  }

  /** Returns the name of the format. */
  public String title() {
    return title;
  }

  /** Returns whether joints of the format may close loops. */
  boolean mayCloseLoops() {
    return loops;
  }

  /** Returns the format of a file; empty if it is none of these. */
  static Optional<RobotFormat> of(Element outermost) {
    return Arrays.stream(values()).filter(f -> f.root.equals(outermost.name())).findFirst();
  }

  /** Returns the outermost element of a file, for messages: {@code <robot> (URDF)}. */
  String outermost() {
    return "<" + root + "> (" + title + ")";
  }

  /** Returns the outermost elements of all formats, for messages. */
  static String roots() {
    return Arrays.stream(values()).map(RobotFormat::outermost).collect(Collectors.joining(", "));
  }
}
