package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.solver.spatial.Vector3;

/**
 * The inertia that the joints of a robot hold, in the pose where all coordinates are zero: the
 * entries of its mass matrix by composite bodies. Source: Featherstone, Rigid Body Dynamics
 * Algorithms, 2008, §6.2, in world coordinates.
 */
final class RobotInertia {
  /** Freedoms up to which the mass matrix is inverted: beyond, that takes seconds. */
  private static final int MOST = 300;

  /** A body with all beyond it: mass, mass times centre, moments about the world's origin. */
  private static final class Composite {
    private double mass;
    private Vector3 moment = Vector3.ZERO;
    private final double[] tensor = new double[6];

    void add(Composite other) {
      mass += other.mass;
      moment = moment.plus(other.moment);
      for (int i = 0; i < tensor.length; i++) {
        tensor[i] += other.tensor[i];
      }
    }

    void add(Inertial inertial, Frame link) {
      Frame frame = link.times(inertial.frame());
      double m = inertial.mass();
      Vector3 c = frame.at();
      double[] j = MechmlRobot.turned(frame.turn(), inertial.moments());
      double cc = c.dot(c);
      mass += m;
      moment = moment.plus(c.times(m));
      tensor[0] += j[0] + m * (cc - c.x() * c.x());
      tensor[1] += j[1] + m * (cc - c.y() * c.y());
      tensor[2] += j[2] + m * (cc - c.z() * c.z());
      tensor[3] += j[3] - m * c.x() * c.y();
      tensor[4] += j[4] - m * c.x() * c.z();
      tensor[5] += j[5] - m * c.y() * c.z();
    }

    /** Returns momentum and angular momentum about the origin of a motion. */
    Motion times(Motion s) {
      Vector3 turned =
          new Vector3(
              tensor[0] * s.turn.x() + tensor[3] * s.turn.y() + tensor[4] * s.turn.z(),
              tensor[3] * s.turn.x() + tensor[1] * s.turn.y() + tensor[5] * s.turn.z(),
              tensor[4] * s.turn.x() + tensor[5] * s.turn.y() + tensor[2] * s.turn.z());
      return new Motion(
          turned.plus(moment.cross(s.slide)), s.slide.times(mass).minus(moment.cross(s.turn)));
    }
  }

  /** An angular velocity with the velocity of the point at the world's origin, or a momentum. */
  private record Motion(Vector3 turn, Vector3 slide) {
    double dot(Motion other) {
      return turn.dot(other.turn) + slide.dot(other.slide);
    }
  }

  /** One freedom: the joint that has it, its motion and the freedoms nearer the root. */
  private record Column(Joint joint, Motion motion) {}

  private final Map<String, Composite> beyond = new LinkedHashMap<>();
  private final Map<String, Joint> above = new HashMap<>();
  private final Map<String, List<Integer>> ofJoint = new HashMap<>();
  private final List<Column> columns = new ArrayList<>();
  private Optional<double[][]> factor = Optional.empty();

  /**
   * @param links of the robot
   * @param joints of the robot, a parent's before its child's as far as the root is reached; the
   *     second joint of a link is left out
   */
  RobotInertia(List<Link> links, List<Joint> joints) {
    Map<String, Link> byName = new HashMap<>();
    links.forEach(link -> byName.put(link.name(), link));
    Map<String, List<Joint>> below = new HashMap<>();
    for (Joint joint : joints) {
      if (above.putIfAbsent(joint.child(), joint) == null) {
        below.computeIfAbsent(joint.parent(), key -> new ArrayList<>()).add(joint);
      }
    }
    Map<String, Frame> frames = new LinkedHashMap<>();
    List<String> open = new ArrayList<>();
    links.stream()
        .map(Link::name)
        .filter(name -> !above.containsKey(name))
        .forEach(
            root -> {
              frames.put(root, Frame.SAME);
              open.add(root);
            });
    for (int i = 0; i < open.size(); i++) {
      String parent = open.get(i);
      Frame frame = frames.getOrDefault(parent, Frame.SAME);
      for (Joint joint : below.getOrDefault(parent, List.of())) {
        if (byName.containsKey(joint.child()) && !frames.containsKey(joint.child())) {
          frames.put(joint.child(), frame.times(joint.place().frame()));
          open.add(joint.child());
          addColumns(joint, frame);
        }
      }
    }
    for (String name : open) {
      Composite own = new Composite();
      Optional.ofNullable(byName.get(name))
          .flatMap(Link::inertial)
          .ifPresent(one -> own.add(one, frames.getOrDefault(name, Frame.SAME)));
      beyond.put(name, own);
    }
    for (int i = open.size() - 1; i >= 0; i--) {
      Joint joint = above.get(open.get(i));
      Composite parent = joint == null ? null : beyond.get(joint.parent());
      if (parent != null) {
        parent.add(beyond.getOrDefault(open.get(i), new Composite()));
      }
    }
  }

  private void addColumns(Joint joint, Frame parent) {
    Frame child = parent.times(joint.place().frame());
    Vector3 axis = child.turn().apply(joint.place().axis());
    Vector3 point = child.at().plus(child.turn().apply(joint.place().point()));
    List<Vector3> axes = List.of(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1));
    switch (joint.type()) {
      case REVOLUTE, CONTINUOUS -> turning(joint, axis, point);
      case SCREW -> {
        Motion turn = new Motion(axis, point.cross(axis));
        add(
            joint,
            new Motion(axis, turn.slide().plus(axis.times(joint.place().lead() / (2 * Math.PI)))));
      }
      case PRISMATIC -> add(joint, new Motion(Vector3.ZERO, axis));
      case SPHERICAL -> axes.forEach(one -> turning(joint, one, point));
      case FLOATING -> {
        axes.forEach(one -> turning(joint, one, point));
        axes.forEach(one -> add(joint, new Motion(Vector3.ZERO, one)));
      }
      case PLANAR -> {
        Vector3 side = child.turn().apply(joint.place().side());
        add(joint, new Motion(Vector3.ZERO, side));
        add(joint, new Motion(Vector3.ZERO, axis.cross(side)));
        turning(joint, axis, point);
      }
      case FIXED -> {
        // It has no freedom.
      }
    }
  }

  private void turning(Joint joint, Vector3 axis, Vector3 point) {
    add(joint, new Motion(axis, point.cross(axis)));
  }

  private void add(Joint joint, Motion motion) {
    ofJoint.computeIfAbsent(joint.name(), key -> new ArrayList<>()).add(columns.size());
    columns.add(new Column(joint, motion));
  }

  private double entry(Column i, Column j) {
    Composite all = beyond.get(j.joint().child());
    double inertia = all == null ? 0 : i.motion().dot(all.times(j.motion()));
    return i.equals(j) ? inertia + i.joint().coordinate().armature() : inertia;
  }

  /**
   * Returns the mean inertia of all beyond a joint about or along its axes while nothing else
   * moves, kg or kg·m².
   */
  double about(String joint) {
    return ofJoint.getOrDefault(joint, List.of()).stream()
        .mapToDouble(i -> entry(columns.get(i), columns.get(i)))
        .average()
        .orElse(0);
  }

  /**
   * Returns the inertia that a force along a joint's coordinate moves while all other joints are
   * free, kg or kg·m²; {@link #about} where a chain without mass leaves it undefined.
   */
  double free(String joint) {
    if (columns.size() > MOST || !ofJoint.containsKey(joint)) {
      return about(joint);
    }
    double sum = 0;
    List<Integer> own = ofJoint.getOrDefault(joint, List.of());
    for (int i : own) {
      double[] along = new double[columns.size()];
      along[i] = 1;
      sum += mobility(along);
    }
    return sum > 0 && Double.isFinite(sum) ? own.size() / sum : about(joint);
  }

  /**
   * Returns the inertia that a force along a sum of coordinates moves while all joints are free.
   *
   * @param terms factors by joint
   * @return kg or kg·m²; 0 if it is not defined
   */
  double free(Map<String, Double> terms) {
    return inertia(along(terms));
  }

  private double[] along(Map<String, Double> terms) {
    double[] along = new double[columns.size()];
    terms.forEach(
        (joint, factor) -> ofJoint.getOrDefault(joint, List.of()).forEach(i -> along[i] += factor));
    return along;
  }

  /**
   * A point of a link that is pulled.
   *
   * @param at in the world, m
   * @param direction and strength
   */
  record Pull(String link, Vector3 at, Vector3 direction) {}

  /**
   * Returns the inertia that pulls at points move together while all joints are free.
   *
   * @return kg; 0 if it is not defined
   */
  double free(List<Pull> pulls) {
    return inertia(along(pulls));
  }

  /**
   * Returns the size of the vector of accelerations of all joints by a unit of force that pulls at
   * points: rad/s² and m/s², as MuJoCo has it in {@code actuator_acc0}; 0 if it is not defined.
   */
  double mobility(List<Pull> pulls) {
    return size(along(pulls));
  }

  /** Returns the same of a force along a sum of coordinates. */
  double mobility(Map<String, Double> terms) {
    return size(along(terms));
  }

  private double[] along(List<Pull> pulls) {
    double[] along = new double[columns.size()];
    for (Pull pull : pulls) {
      for (Joint joint = above.get(pull.link()); joint != null; joint = above.get(joint.parent())) {
        for (int i : ofJoint.getOrDefault(joint.name(), List.of())) {
          Motion motion = columns.get(i).motion();
          Vector3 velocity = motion.slide().plus(motion.turn().cross(pull.at()));
          along[i] += pull.direction().dot(velocity);
        }
      }
    }
    return along;
  }

  private double size(double[] along) {
    double[][] l = columns.size() > MOST ? new double[0][] : factor();
    double[] x = forward(l, along);
    double square = 0;
    for (int i = x.length - 1; i >= 0; i--) {
      double sum = x[i];
      for (int k = i + 1; k < x.length; k++) {
        sum -= l[k][i] * x[k];
      }
      x[i] = sum / l[i][i];
      square += x[i] * x[i];
    }
    return Math.sqrt(square);
  }

  private double inertia(double[] along) {
    double mobility = columns.size() > MOST ? 0 : mobility(along);
    return mobility > 0 && Double.isFinite(mobility) ? 1 / mobility : 0;
  }

  /** Returns Jᵀ M⁻¹ J = |L⁻¹ J|² with M = L Lᵀ; 0 if the mass matrix is singular. */
  private double mobility(double[] along) {
    double square = 0;
    for (double x : forward(factor(), along)) {
      square += x * x;
    }
    return square;
  }

  private double[][] factor() {
    double[][] l = factor.orElseGet(this::factorise);
    factor = Optional.of(l);
    return l;
  }

  /** Returns L⁻¹ b. */
  private static double[] forward(double[][] l, double[] b) {
    double[] x = new double[l.length];
    for (int i = 0; i < l.length; i++) {
      double sum = b[i];
      for (int k = 0; k < i; k++) {
        sum -= l[i][k] * x[k];
      }
      x[i] = sum / l[i][i];
    }
    return x;
  }

  /** Returns the factor L of the mass matrix M = L Lᵀ; empty if it is singular. */
  private double[][] factorise() {
    int n = columns.size();
    double[][] m = new double[n][n];
    for (int j = 0; j < n; j++) {
      Column column = columns.get(j);
      Joint joint = column.joint();
      while (joint != null) {
        for (int i : ofJoint.getOrDefault(joint.name(), List.of())) {
          m[i][j] = entry(columns.get(i), column);
          m[j][i] = m[i][j];
        }
        joint = above.get(joint.parent());
      }
    }
    double[][] l = new double[n][n];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = m[i][j];
        for (int k = 0; k < j; k++) {
          sum -= l[i][k] * l[j][k];
        }
        if (i == j && !(sum > 1e-12 * m[i][i])) {
          return new double[0][];
        }
        l[i][j] = i == j ? Math.sqrt(sum) : sum / l[j][j];
      }
    }
    return l;
  }
}
