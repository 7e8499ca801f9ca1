package org.mechservice.library.proof;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The text of a model, from its parts. Every body has a point {@code o} at its origin and the
 * vectors {@code x}, {@code y}, {@code z} along its axes; the root is {@code Ground}.
 */
final class SceneText {
  private static final String AXES =
      "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector"
          + " name='z' vx='0' vy='0' vz='1'/>";

  private final Map<String, StringBuilder> points = new LinkedHashMap<>();
  private final Map<String, String> inertia = new LinkedHashMap<>();
  private final StringBuilder tables = new StringBuilder();
  private final StringBuilder joints = new StringBuilder();
  private final StringBuilder constraints = new StringBuilder();
  private final StringBuilder states = new StringBuilder();
  private final StringBuilder forces = new StringBuilder();
  private final StringBuilder outputs = new StringBuilder();
  private final StringBuilder starts = new StringBuilder();

  SceneText() {
    body("Ground", "");
  }

  private void body(String name, String content) {
    points.put(name, new StringBuilder("<point name='o' x='0' y='0' z='0'/>"));
    inertia.put(name, content);
  }

  /** Adds a body with its centre of gravity at its origin; moments of inertia are all the same. */
  SceneText body(String name, double mass, double moment) {
    body(
        name,
        "<mass value='"
            + mass
            + "'/>"
            + (moment == 0
                ? ""
                : "<inertiaTensor Ixx='"
                    + moment
                    + "' Iyy='"
                    + moment
                    + "' Izz='"
                    + moment
                    + "'/>"));
    return this;
  }

  /** Adds a body of small moments of inertia with its centre of gravity at (0, 0, z). */
  SceneText bob(String name, double mass, double moment, double z) {
    body(name, mass, moment);
    inertia.put(name, "<cog x='0' y='0' z='" + z + "'/>" + inertia.get(name));
    return this;
  }

  /** Adds a body without mass, for driven joints. */
  SceneText carrier(String name) {
    body(name, "");
    return this;
  }

  SceneText point(String body, String name, double x, double y, double z) {
    StringBuilder of = points.get(body);
    if (of == null) {
      throw new IllegalArgumentException("no body " + body);
    }
    of.append("<point name='" + name + "' x='" + x + "' y='" + y + "' z='" + z + "'/>");
    return this;
  }

  /** Adds a joint at the origin of body2; {@code more} are further attributes. */
  SceneText joint(
      String name,
      String type,
      String body1,
      String point,
      String body2,
      String axis,
      String more) {
    String vector = axis.isEmpty() ? "" : " vector='" + axis + "'";
    joints.append("<joint name='" + name + "' type='" + type + "' " + more + "><body1 name='");
    joints.append(body1 + "' point='" + point + "'" + vector + "/><body2 name='" + body2);
    joints.append("' point='o'" + vector + "/></joint>");
    return this;
  }

  SceneText table(String text) {
    tables.append(text);
    return this;
  }

  SceneText constraint(String text) {
    constraints.append(text);
    return this;
  }

  SceneText state(String text) {
    states.append(text);
    return this;
  }

  SceneText force(String text) {
    forces.append(text);
    return this;
  }

  SceneText output(String name, String expression) {
    outputs.append("<output name='" + name + "' expression='" + expression + "'/>");
    return this;
  }

  SceneText gravity(String gx, String gy, String gz) {
    return force("<gravity gx='" + gx + "' gy='" + gy + "' gz='" + gz + "'/>");
  }

  SceneText start(String joint, double q, double v) {
    starts.append("<jointVal name='" + joint + "' posVals='" + q + "' velVals='" + v + "'/>");
    return this;
  }

  SceneText driven(String joint, String expression) {
    starts.append("<jointVal name='" + joint + "' driven='" + expression + "'/>");
    return this;
  }

  SceneText startText(String text) {
    starts.append(text);
    return this;
  }

  /** Returns the ends of an element between two points. */
  static String ends(String body1, String point1, String more1, String body2, String point2) {
    return "<body1 name='"
        + body1
        + "' point='"
        + point1
        + "'"
        + more1
        + "/><body2 name='"
        + body2
        + "' point='"
        + point2
        + "'/>";
  }

  /** Returns the model with a run. */
  String with(double end, double row, Method method) {
    StringBuilder bodies = new StringBuilder();
    points.forEach(
        (name, of) ->
            bodies
                .append("<body name='" + name + "'>")
                .append(of)
                .append(AXES)
                .append(inertia.get(name))
                .append("</body>\n"));
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='"
        + end
        + "' tstep='"
        + row
        + "'/>"
        + method.text()
        + (outputs.isEmpty() ? "" : "<output columns='joints; outputs'/>")
        + "</dynamic></MBSsimulation>\n<MBSmodel name='m' massUnits='kg' lengthUnits='m'>\n"
        + section("Tables", tables)
        + "<Bodies>\n"
        + bodies
        + "</Bodies>\n<Joints>"
        + joints
        + "</Joints>\n"
        + section("Constraints", constraints)
        + section("States", states)
        + section("Forces", forces)
        + section("Outputs", outputs)
        + "<topology><root name='Ground'/><relCoorVals>"
        + starts
        + "</relCoorVals></topology>\n</MBSmodel></MechML>\n";
  }

  private static String section(String name, StringBuilder content) {
    return content.isEmpty() ? "" : "<" + name + ">" + content + "</" + name + ">\n";
  }
}
