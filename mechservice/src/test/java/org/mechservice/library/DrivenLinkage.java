package org.mechservice.library;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.random.RandomGenerator;

/**
 * A planar linkage with a driven crank at the origin, made of dyads: two bars from two known points
 * to a common joint, or one bar to a slider. Its positions are closed forms of the angle of the
 * crank: each dyad stays on its side, since the joint would have to pass the line of the two points
 * to change it.
 *
 * <pre>
 *          C------E         crank O A, dyad A C B, six-bars with a second dyad P E F from a point P
 *         / \     |         of the coupler (Stephenson III) or of the rocker (Watt II)
 *    A---+   \    |
 *   /         B   F
 *  O
 * </pre>
 */
final class DrivenLinkage {
  /** How time moves the crank. */
  enum Drive {
    TREE_JOINT,
    CUT_JOINT,
    CONSTRAINT
  }

  /** A bar that ends in a joint; its angle is measured from the x axis of the ground. */
  private record Bar(String name, double length) {}

  private final Drive drive;
  private final double start;
  private final double speed;
  private final double crank;
  private final List<Step> steps = new ArrayList<>();

  /** Two bars, or a bar and a slider, that follow what came before. */
  private sealed interface Step {}

  /**
   * Two bars from points of two bodies, each at a place in polar coordinates about the axis of its
   * body.
   */
  private record Dyad(
      String body, double radius, double turn, double x, double y, Bar near, Bar far, int side)
      implements Step {}

  /** A bar from the crank's end to a slider on a line parallel to the x axis. */
  private record Slide(double offset, Bar rod, int side) implements Step {}

  private DrivenLinkage(Drive drive, double start, double speed, double crank) {
    this.drive = drive;
    this.start = start;
    this.speed = speed;
    this.crank = crank;
  }

  /** Returns a four-bar linkage with the pivot of its rocker at (ground, 0). */
  static DrivenLinkage fourBar(
      Drive drive,
      double start,
      double speed,
      double crank,
      double coupler,
      double rocker,
      double ground,
      int side) {
    DrivenLinkage linkage = new DrivenLinkage(drive, start, speed, crank);
    Bar near = new Bar("coupler", coupler);
    linkage.steps.add(
        new Dyad("crank", crank, 0, ground, 0, near, new Bar("rocker", rocker), side));
    return linkage;
  }

  static DrivenLinkage sliderCrank(
      Drive drive, double start, double speed, double crank, double rod, double offset, int side) {
    DrivenLinkage linkage = new DrivenLinkage(drive, start, speed, crank);
    linkage.steps.add(new Slide(offset, new Bar("rod", rod), side));
    return linkage;
  }

  /** Adds a second dyad from a point of the coupler or the rocker to a pivot at (x, y). */
  DrivenLinkage with(
      String body,
      double radius,
      double turn,
      double x,
      double y,
      double near,
      double far,
      int side) {
    steps.add(new Dyad(body, radius, turn, x, y, new Bar("link", near), new Bar("arm", far), side));
    return this;
  }

  double speed() {
    return speed;
  }

  double angle(double t) {
    return start + speed * t;
  }

  /** A coordinate of the model and its value. */
  record Coordinate(String name, double value, boolean isAngle) {}

  /** Returns the coordinates at an angle of the crank; NaN where the linkage cannot be closed. */
  List<Coordinate> positions(double angle) {
    List<Coordinate> found = new ArrayList<>();
    double[] of = {angle, Double.NaN, Double.NaN};
    for (Step step : steps) {
      if (step instanceof Slide slide) {
        double up = slide.offset - crank * Math.sin(angle);
        double along = slide.side * Math.sqrt(slide.rod.length * slide.rod.length - up * up);
        double bar = Math.atan2(up, along);
        found.add(new Coordinate("rod", bar - angle, true));
        found.add(new Coordinate("slider", crank * Math.cos(angle) + along, false));
      } else if (step instanceof Dyad dyad) {
        double[] pivot = pivot(dyad.body, angle);
        double host =
            dyad.body.equals("crank") ? of[0] : dyad.body.equals("coupler") ? of[1] : of[2];
        double px = pivot[0] + dyad.radius * Math.cos(host + dyad.turn);
        double py = pivot[1] + dyad.radius * Math.sin(host + dyad.turn);
        double dx = dyad.x - px;
        double dy = dyad.y - py;
        double distance = Math.hypot(dx, dy);
        double a = dyad.near.length;
        double b = dyad.far.length;
        double cosine = (a * a + distance * distance - b * b) / (2 * a * distance);
        double near = Math.atan2(dy, dx) + dyad.side * Math.acos(cosine);
        double cx = px + a * Math.cos(near);
        double cy = py + a * Math.sin(near);
        double far = Math.atan2(cy - dyad.y, cx - dyad.x);
        found.add(new Coordinate(dyad.near.name, near - host, true));
        found.add(new Coordinate(dyad.far.name, far, true));
        if (dyad.body.equals("crank")) {
          of[1] = near;
          of[2] = far;
        }
      }
    }
    return found;
  }

  /** Returns where the axis of a body is. */
  private double[] pivot(String body, double angle) {
    if (body.equals("coupler")) {
      return new double[] {crank * Math.cos(angle), crank * Math.sin(angle)};
    }
    return body.equals("rocker") && steps.get(0) instanceof Dyad first
        ? new double[] {first.x, first.y}
        : new double[2];
  }

  /**
   * Returns the least angle between the two bars of a dyad, or between the rod and the normal of a
   * slider's path, over a turn of the crank, in rad; NaN if it cannot turn.
   */
  double leastTransmissionAngle() {
    double least = Math.PI;
    int count = 7200;
    for (int i = 0; i < count; i++) {
      double angle = 2 * Math.PI * i / count;
      List<Coordinate> at = positions(angle);
      double[] of = {angle, angle + at.get(0).value, at.get(1).value};
      for (int s = 0; s < steps.size(); s++) {
        double turned;
        if (steps.get(s) instanceof Dyad dyad) {
          double host =
              dyad.body.equals("crank") ? of[0] : dyad.body.equals("coupler") ? of[1] : of[2];
          turned = host + at.get(2 * s).value - at.get(2 * s + 1).value;
        } else {
          turned = of[1] + Math.PI / 2;
        }
        least = Math.min(least, Math.abs(Math.asin(Math.sin(turned))));
      }
    }
    return least;
  }

  /** Returns the model. */
  String mechml(double end, double step) {
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    StringBuilder values = new StringBuilder();
    StringBuilder grounds = new StringBuilder("<point name='o' x='0' y='0' z='0'/>");
    StringBuilder couplerPoints = new StringBuilder();
    StringBuilder rockerPoints = new StringBuilder();
    List<Coordinate> at = positions(start);
    joints.append(joint("crank", "R", "ground", "o", "crank", "o", "z", ""));
    for (int s = 0; s < steps.size(); s++) {
      if (steps.get(s) instanceof Dyad dyad) {
        boolean first = dyad.body.equals("crank");
        String host = first ? "e" : "p";
        grounds.append(point("g" + s, dyad.x, dyad.y));
        StringBuilder near = first ? couplerPoints : new StringBuilder();
        StringBuilder far = first ? rockerPoints : new StringBuilder();
        near.append(point("e", dyad.near.length, 0));
        far.append(point("e", dyad.far.length, 0));
        if (!first) {
          String place =
              point("p", dyad.radius * Math.cos(dyad.turn), dyad.radius * Math.sin(dyad.turn));
          (dyad.body.equals("coupler") ? couplerPoints : rockerPoints).append(place);
          bodies.append(body(dyad.near.name, near.toString(), dyad.near.length));
          bodies.append(body(dyad.far.name, far.toString(), dyad.far.length));
        }
        joints.append(joint(dyad.near.name, "R", dyad.body, host, dyad.near.name, "o", "z", ""));
        joints.append(joint(dyad.far.name, "R", "ground", "g" + s, dyad.far.name, "o", "z", ""));
        joints.append(
            joint("pin" + s, "R", dyad.near.name, "e", dyad.far.name, "e", "z", " cut='true'"));
      } else if (steps.get(s) instanceof Slide slide) {
        grounds.append(point("g", 0, slide.offset));
        bodies.append(body("rod", point("e", slide.rod.length, 0), slide.rod.length));
        bodies.append(body("slider", "", 0.1));
        joints.append(joint("rod", "R", "crank", "e", "rod", "o", "z", ""));
        joints.append(joint("slider", "P", "ground", "g", "slider", "o", "x", ""));
        joints.append(joint("pin", "R", "rod", "e", "slider", "o", "z", " cut='true'"));
      }
    }
    if (steps.get(0) instanceof Dyad dyad) {
      bodies.append(body("coupler", couplerPoints.toString(), dyad.near.length));
      bodies.append(body("rocker", rockerPoints.toString(), dyad.far.length));
    }
    bodies.append(body("crank", point("e", crank, 0), crank));
    for (Coordinate coordinate : at) {
      values.append(
          "<jointVal name='" + coordinate.name + "' posVals='" + coordinate.value + "'/>");
    }
    String path = start + (speed < 0 ? "-" : "+") + Math.abs(speed) + "*t";
    String constraints = "";
    switch (drive) {
      case TREE_JOINT -> values.append("<jointVal name='crank' driven='" + path + "'/>");
      case CUT_JOINT -> {
        joints.append(joint("motor", "R", "ground", "o", "crank", "o", "z", " cut='true'"));
        values.append("<jointVal name='motor' driven='" + path + "'/>");
        values.append("<jointVal name='crank' posVals='" + start + "'/>");
      }
      case CONSTRAINT -> {
        constraints =
            "<Constraints><CoordConstraint name='motor' expression='crank.q-("
                + path
                + ")'/></Constraints>";
        values.append("<jointVal name='crank' posVals='" + start + "'/>");
      }
    }
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='"
        + end
        + "' tstep='"
        + step
        + "'/></dynamic></MBSsimulation><MBSmodel name='linkage' massUnits='kg' lengthUnits='m'>"
        + "<Bodies><body name='ground'>"
        + grounds
        + AXES
        + "</body>"
        + bodies
        + "</Bodies><Joints>"
        + joints
        + "</Joints>"
        + constraints
        + "<Forces><gravity gx='0' gy='-9.81' gz='0'/></Forces><topology><root name='ground'/>"
        + "<relCoorVals>"
        + values
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static final String AXES =
      "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector"
          + " name='z' vx='0' vy='0' vz='1'/>";

  private static String point(String name, double x, double y) {
    return "<point name='" + name + "' x='" + x + "' y='" + y + "' z='0'/>";
  }

  private static String body(String name, String points, double length) {
    return "<body name='"
        + name
        + "'><point name='o' x='0' y='0' z='0'/>"
        + points
        + AXES
        + "<cog x='"
        + length / 2
        + "' y='0' z='0'/><mass value='1'/><inertiaTensor Ixx='0.02' Iyy='0.02' Izz='0.02'/></body>";
  }

  private static String joint(
      String name,
      String type,
      String on,
      String at,
      String of,
      String by,
      String axis,
      String cut) {
    return "<joint name='%s' type='%s'%s><body1 name='%s' point='%s' vector='%s'/><body2 name='%s' point='%s' vector='%s'/></joint>"
        .formatted(name, type, cut, on, at, axis, of, by, axis);
  }

  /** Returns a linkage whose crank turns with all transmission angles above one degree. */
  static DrivenLinkage random(RandomGenerator random) {
    while (true) {
      DrivenLinkage drawn = draw(random);
      if (drawn.leastTransmissionAngle() > Math.toRadians(1)) {
        return drawn;
      }
    }
  }

  private static DrivenLinkage draw(RandomGenerator random) {
    Drive drive = Drive.values()[random.nextInt(3)];
    double start = random.nextDouble(2 * Math.PI);
    double speed = Math.pow(10, random.nextDouble(-1, 2)) * (random.nextBoolean() ? 1 : -1);
    int side = random.nextBoolean() ? 1 : -1;
    int kind = random.nextInt(5);
    double crank = random.nextDouble(0.1, 1);
    if (kind == 0) {
      return sliderCrank(
          drive,
          start,
          speed,
          crank,
          random.nextDouble(0.1, 2),
          random.nextDouble(-0.5, 0.5),
          side);
    }
    DrivenLinkage four =
        fourBar(
            drive,
            start,
            speed,
            crank,
            random.nextDouble(0.1, 1.5),
            random.nextDouble(0.1, 1.5),
            kind == 1 ? random.nextDouble(0.05, crank) : random.nextDouble(crank, 2),
            side);
    return kind < 3
        ? four
        : four.with(
            kind == 3 ? "coupler" : "rocker",
            random.nextDouble(0.1, 0.8),
            random.nextDouble(-Math.PI, Math.PI),
            random.nextDouble(-1, 2),
            random.nextDouble(-1, 1),
            random.nextDouble(0.2, 2),
            random.nextDouble(0.2, 2),
            random.nextBoolean() ? 1 : -1);
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%s %.6g + %.6g t, crank %.6g, %s, least transmission angle %.3g degrees",
        drive,
        start,
        speed,
        crank,
        steps,
        Math.toDegrees(leastTransmissionAngle()));
  }
}
