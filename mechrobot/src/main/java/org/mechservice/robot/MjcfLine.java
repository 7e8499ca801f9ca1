package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.mechservice.robot.Robot.Around;
import org.mechservice.robot.Robot.Branch;
import org.mechservice.robot.Robot.Eye;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Waypoint;
import org.mechservice.solver.force.law.Wrap;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The line of a spatial tendon from site to site, also around spheres and cylinders. Its length is
 * the sum of the parts, of which those behind a pulley count less.
 */
final class MjcfLine {
  private static final List<Vector3> AXES =
      List.of(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1));

  /** A part between two eyes, straight or around a shape, and how much of its length counts. */
  private record Part(Eye from, Optional<Around> around, Eye to, double share) {}

  /** Where the frame of a link and a frame in it are, with the bodies in given places. */
  interface Placing extends BiFunction<String, Frame, Frame> {}

  private final List<Waypoint> stops;
  private final List<Part> parts = new ArrayList<>();

  /**
   * @param stops eyes at both ends, and on both sides of each shape and branch
   */
  MjcfLine(List<Waypoint> stops) {
    this.stops = List.copyOf(stops);
    double share = 1;
    for (int i = 0; i < stops.size(); i++) {
      if (stops.get(i) instanceof Branch branch) {
        share = branch.share();
      } else if (i > 0 && stops.get(i) instanceof Eye to) {
        if (stops.get(i - 1) instanceof Eye from) {
          parts.add(new Part(from, Optional.empty(), to, share));
        } else if (stops.get(i - 1) instanceof Around around) {
          parts.add(new Part((Eye) stops.get(i - 2), Optional.of(around), to, share));
        }
      }
    }
  }

  /** Returns what it passes. */
  List<Waypoint> stops() {
    return stops;
  }

  /** Returns its length with the bodies in given places, m. */
  double length(Placing placing) {
    return parts.stream()
        .mapToDouble(part -> part.share() * lengthAndSlopes(part, placing)[0])
        .sum();
  }

  private static Vector3 at(Eye eye, Placing placing) {
    return placing.apply(eye.link(), new Frame(eye.at(), Rotation.IDENTITY)).at();
  }

  /** Returns the length of a part, then its slopes by the places of its ends. */
  private static double[] lengthAndSlopes(Part part, Placing placing) {
    Vector3 from = at(part.from(), placing);
    Vector3 to = at(part.to(), placing);
    Program program = new Program();
    Expressions e = program.expressions();
    Scalar length = length(e, part, ends(e, 0), ends(e, 3), placing);
    program.section("length and slopes", "length");
    program.output(0, length);
    for (int i = 0; i < 6; i++) {
      program.output(1 + i, new Differentiation(e, Map.of(e.input(i), e.one())).of(length));
    }
    double[] values = new double[7];
    program.evaluate(new double[] {from.x(), from.y(), from.z(), to.x(), to.y(), to.z()}, values);
    return values;
  }

  private static ScalarVector ends(Expressions e, int first) {
    return new ScalarVector(e.input(first), e.input(first + 1), e.input(first + 2));
  }

  private static Scalar length(
      Expressions e, Part part, ScalarVector from, ScalarVector to, Placing placing) {
    if (part.around().isEmpty()) {
      ScalarVector way = to.minus(from);
      return way.dot(way).squareRoot();
    }
    Around shape = part.around().get();
    Frame frame = placing.apply(shape.link(), shape.frame());
    ScalarVector centre = ScalarVector.of(e, frame.at());
    List<ScalarVector> axes =
        AXES.stream().map(one -> ScalarVector.of(e, frame.turn().apply(one))).toList();
    Wrap wrap =
        new Wrap(
            e,
            from.minus(centre),
            to.minus(centre),
            shape.cylinder() ? Optional.of(axes.get(2)) : Optional.empty(),
            e.constant(shape.radius()));
    if (shape.inside()) {
      return wrap.inside(axes, RobotActions.TOLERANCE_OF_MUJOCO).length();
    } else if (shape.side().isPresent()) {
      ScalarVector side = ScalarVector.of(e, at(shape.side().get(), placing));
      return wrap.beside(side.minus(centre)).length();
    }
    return wrap.shortest().length();
  }

  /**
   * Returns what the line pulls at if it grew, with the bodies in places. Only the motion of the
   * ends beside the shape counts, so that a shape is pulled at both ends in the opposite way.
   */
  List<RobotInertia.Pull> pulls(Placing placing) {
    List<RobotInertia.Pull> all = new ArrayList<>();
    for (Part part : parts) {
      Vector3 from = at(part.from(), placing);
      Vector3 to = at(part.to(), placing);
      double[] slopes = lengthAndSlopes(part, placing);
      Vector3 atStart = new Vector3(slopes[1], slopes[2], slopes[3]).times(part.share());
      Vector3 atEnd = new Vector3(slopes[4], slopes[5], slopes[6]).times(part.share());
      all.add(new RobotInertia.Pull(part.to().link(), to, atEnd));
      all.add(new RobotInertia.Pull(part.from().link(), from, atStart));
      part.around()
          .ifPresent(
              shape -> {
                all.add(new RobotInertia.Pull(shape.link(), to, atEnd.negated()));
                all.add(new RobotInertia.Pull(shape.link(), from, atStart.negated()));
              });
    }
    return all;
  }

  /** Returns its ends if it is one straight part. */
  Optional<List<Eye>> straight() {
    boolean one = stops.size() == 2 && parts.size() == 1;
    return one ? Optional.of(List.of(parts.get(0).from(), parts.get(0).to())) : Optional.empty();
  }
}
