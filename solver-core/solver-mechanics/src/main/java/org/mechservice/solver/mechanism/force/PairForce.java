package org.mechservice.solver.mechanism.force;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A force between two bodies given by formulas of their relative motion: contacts of spheres, boxes
 * and discs, tyres. The wrench acts on body 2 at the origin of frame 2, and its opposite along the
 * same line on body 1.
 *
 * <p>The formulas consist of {@link Expression.RelativeMotion} of exactly these two frames, further
 * states, parameters and numbers. They share parts: the same object may stand in several places.
 *
 * @param name name in the model file
 * @param kind kind in words, such as {@code tyre}
 * @param frame1 on body 1
 * @param frame2 on body 2
 * @param wrench three components of the moment, N·m, then three of the force, N, in the axes of
 *     frame 1
 * @param potential potential energy, J
 * @param potentialRate its derivative by time, W
 * @param outputs values that are columns of results: first how deep the bodies are in each other,
 *     then the load between them, N, which is zero while they are apart
 * @param mostDepth penetration beyond which one shape is inside or behind the other and the
 *     formulas mean nothing, m; zero where there is no such depth
 * @param shape what touches, as pictures show it at frame 2
 * @param origin position in the model file
 */
public record PairForce(
    String name,
    String kind,
    BodyFrame frame1,
    BodyFrame frame2,
    List<Expression> wrench,
    Expression potential,
    Expression potentialRate,
    List<Value> outputs,
    Expression mostDepth,
    Shape shape,
    Origin origin)
    implements ForceElement {
  /**
   * An output value.
   *
   * @param name its name after that of the force
   * @param unit in SI
   * @param expression of the same leaves as the wrench
   */
  public record Value(String name, String unit, Expression expression) {}

  /** What a body touches with. */
  public sealed interface Shape {
    /** Nothing that pictures could show. */
    Shape POINT = new Sphere(0);
  }

  /**
   * A sphere about the origin of the frame.
   *
   * @param radius m; 0 for a point
   */
  public record Sphere(double radius) implements Shape {}

  /**
   * A disc, wheel or tyre about the z axis of the frame.
   *
   * @param radius m
   */
  public record Disc(double radius) implements Shape {}

  /**
   * A box about the origin of the frame.
   *
   * @param edges lengths along the axes of the frame, m
   */
  public record Box(Vector3 edges) implements Shape {}

  public PairForce {
    wrench = List.copyOf(wrench);
    outputs = List.copyOf(outputs);
    if (wrench.size() != 6) {
      throw new IllegalArgumentException(
          "force " + name + " needs 6 components, not " + wrench.size());
    }
  }

  /** Returns the penetration, m: positive while the bodies touch. */
  public Expression depth() {
    return outputs.get(0).expression();
  }

  /** Returns the load between the bodies, N: zero while they are apart. */
  public Expression load() {
    return outputs.get(1).expression();
  }

  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return outputs.stream().map(value -> new Variable(value.name(), value.unit())).toList();
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.pairForce(this);
  }

  @Override
  public List<Integer> bodies() {
    return List.of(frame1.body(), frame2.body());
  }

  @Override
  public List<Formula> formulas() {
    List<Formula> formulas = new ArrayList<>();
    wrench.forEach(component -> formulas.add(new Formula("wrench", component)));
    formulas.add(new Formula("potential energy", potential));
    outputs.forEach(value -> formulas.add(new Formula(value.name(), value.expression())));
    return formulas;
  }
}
