package org.mechservice.robot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.robot.Robot.BodyForce;
import org.mechservice.robot.Robot.Force;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.Mark;
import org.mechservice.solver.spatial.Vector3;

/**
 * The medium around an MJCF model: each body is felt as the box with its inertia. Along its axis i,
 * with the sides b, the velocity u of its centre against the wind and the angular velocity w, act
 *
 * <pre>
 * force  = -3 π d η u_i    - ρ b_j b_k |u_i| u_i / 2
 * torque = -π d³ η w_i     - ρ b_i (b_j⁴ + b_k⁴) |w_i| w_i / 64
 * </pre>
 *
 * with the mean side d, the density ρ and the viscosity η. Source: MuJoCo documentation,
 * Computation, "Fluid forces", inertia-based model.
 *
 * <p>In MechML these are expressions of four marks of the body: its centre, and one at the distance
 * of 1 m along each axis, whose places and velocities give the axes, u and w.
 */
final class MjcfMedium {
  /** MuJoCo's least mass of a body that feels the medium, kg, and least moment, kg·m². */
  private static final double LEAST = 1e-15;

  /** Part of the largest moment by which two differ at least if their axes are to be defined. */
  private static final double EQUAL = 1e-9;

  private static final List<String> AXES = List.of("x", "y", "z");

  private final double density;
  private final double viscosity;
  private final Vector3 wind;
  private final ImportLosses losses;

  MjcfMedium(MjcfOptions options, ImportLosses losses) {
    this.losses = losses;
    density = options.density();
    viscosity = options.viscosity();
    wind = options.wind();
  }

  /** Returns the marks and the force of a body; none if it has no mass or the medium is empty. */
  List<Force> around(Link link) {
    boolean acts = density > 0 || viscosity > 0;
    return link.inertial()
        .filter(inertial -> acts && inertial.mass() >= LEAST)
        .map(inertial -> around(link, inertial))
        .orElse(List.of());
  }

  private List<Force> around(Link link, Inertial inertial) {
    PrincipalAxes axes = PrincipalAxes.of(inertial.moments());
    if (density > 0 && isOpen(inertial, axes.moments())) {
      losses.motion(
          link.element(),
          "two of its principal moments are equal, so the sides of its box in the medium are any;"
              + " MuJoCo may have taken others");
    }
    Vector3 centre = inertial.frame().at();
    List<Force> all = new ArrayList<>();
    Mark middle = new Mark(link.element(), link.name() + " medium", link.name(), centre);
    all.add(middle);
    List<Mark> ends = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      Vector3 axis = inertial.frame().turn().apply(axes.axis(i));
      Mark end =
          new Mark(
              link.element(),
              link.name() + " medium " + AXES.get(i),
              link.name(),
              centre.plus(axis));
      ends.add(end);
    }
    all.addAll(ends);
    double[] box = box(axes.moments(), inertial.mass());
    List<String> forces = new ArrayList<>();
    List<String> torques = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      String slide =
          along(
              middle,
              ends.get(i),
              List.of(middle.part("vx"), middle.part("vy"), middle.part("vz")),
              wind);
      String turn = along(middle, ends.get(k), relative(middle, ends.get(j)), Vector3.ZERO);
      double d = (box[0] + box[1] + box[2]) / 3;
      forces.add(law(slide, 3 * Math.PI * d * viscosity, 0.5 * density * box[j] * box[k]));
      torques.add(
          law(
              turn,
              Math.PI * d * d * d * viscosity,
              density * box[i] * (Math.pow(box[j], 4) + Math.pow(box[k], 4)) / 64));
    }
    all.add(
        new BodyForce(
            link.element(),
            link.name() + " in medium",
            link.name(),
            centre,
            false,
            inWorld(middle, ends, forces),
            inWorld(middle, ends, torques)));
    return all;
  }

  /** Returns whether the axes of two moments may lie anywhere in their plane. */
  private static boolean isOpen(Inertial inertial, double[] moments) {
    double[] m = moments.clone();
    Arrays.sort(m);
    boolean turned = inertial.moments().subList(3, 6).stream().anyMatch(x -> x != 0);
    return turned && Math.min(m[1] - m[0], m[2] - m[1]) < EQUAL * m[2];
  }

  /** Returns the sides of the box with a mass and moments, m. */
  private static double[] box(double[] moments, double mass) {
    double[] box = new double[3];
    for (int i = 0; i < 3; i++) {
      double rest = moments[(i + 1) % 3] + moments[(i + 2) % 3] - moments[i];
      box[i] = Math.sqrt(Math.max(LEAST, rest) / mass * 6);
    }
    return box;
  }

  private static List<String> relative(Mark from, Mark to) {
    return AXES.stream()
        .map(x -> "(" + to.part("v" + x) + " - " + from.part("v" + x) + ")")
        .toList();
  }

  /** Returns the component of a velocity less another one along the axis to a mark. */
  private static String along(Mark middle, Mark end, List<String> velocity, Vector3 less) {
    double[] taken = {less.x(), less.y(), less.z()};
    List<String> products = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      String moving =
          taken[i] == 0
              ? velocity.get(i)
              : "(" + velocity.get(i) + " - (" + MechmlText.number(taken[i]) + "))";
      products.add(moving + "*" + axis(middle, end, AXES.get(i)));
    }
    return "(" + String.join(" + ", products) + ")";
  }

  private static String axis(Mark middle, Mark end, String component) {
    return "(" + end.part(component) + " - " + middle.part(component) + ")";
  }

  private static String law(String speed, double linear, double square) {
    List<String> parts = new ArrayList<>();
    if (linear != 0) {
      parts.add(MechmlText.number(linear));
    }
    if (square != 0) {
      parts.add(MechmlText.number(square) + "*abs(" + speed + ")");
    }
    return "-(" + String.join(" + ", parts) + ")*" + speed;
  }

  private static List<String> inWorld(Mark middle, List<Mark> ends, List<String> local) {
    return AXES.stream()
        .map(
            x -> {
              List<String> parts = new ArrayList<>();
              for (int i = 0; i < 3; i++) {
                parts.add("(" + local.get(i) + ")*" + axis(middle, ends.get(i), x));
              }
              return String.join(" + ", parts);
            })
        .toList();
  }
}
