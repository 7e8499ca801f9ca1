package org.mechservice.solver.mechanism.force;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Condition;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * An elastic joint: forces and moments from the displacement and rotation of a frame of body 2
 * relative to a frame of body 1.
 *
 * <p>All quantities are relative to body 1, in the axes of frame 1: r, the origin of frame 2 from
 * that of frame 1; φ, the rotation vector (axis times angle, |φ| &lt; π) that turns frame 1 into
 * frame 2; their rates r′ and φ′; the angular velocity ω of frame 2. Stiffness and damping are 6 ×
 * 6, displacements before rotations. The load on body 2 at the origin of frame 2 is
 *
 * <ul>
 *   <li>{@code ENERGY}: the force f and the moment m that belong to [f; m̂] = preload − K [r; φ] −
 *       C [r′; φ′] by their power, m · ω = m̂ · φ′. With symmetric K it is conservative: energy ½
 *       [r; φ]ᵀ K [r; φ] − preloadᵀ [r; φ];
 *   <li>{@code LINEAR}: [f; m] = preload − K [r; φ] − C [r′; ω] without conversion. The two laws
 *       agree to first order in φ; this one has an energy only if K has no rotational stiffness.
 * </ul>
 *
 * The load on body 1 is the opposite force on the same line and the opposite moment. Power lost:
 * [r′; φ′]ᵀ C [r′; φ′], with ω for φ′ in {@code LINEAR}. A rotation of half a turn ends the run
 * with a message naming the force.
 *
 * @param name name in the model file
 * @param frame1 on body 1; its axes carry K and C
 * @param frame2 on body 2
 * @param stiffness K row by row, 36: N/m, N/rad, N·m/m, N·m/rad
 * @param damping C row by row, 36: N·s/m, N·s/rad, N·s, N·m·s/rad
 * @param preload force and moment on body 2 at rest, 6: N, N·m
 * @param law relation of moment and rotation vector
 * @param origin position in the model file
 */
public record Bushing(
    String name,
    BodyFrame frame1,
    BodyFrame frame2,
    List<Expression> stiffness,
    List<Expression> damping,
    List<Expression> preload,
    Law law,
    Origin origin)
    implements ForceElement {

  /** Relation of the moment and the rotation vector. */
  public enum Law {
    /** The moment follows from its power; conservative for a symmetric K. */
    ENERGY,
    /** The moment equals the components directly. */
    LINEAR
  }

  public Bushing {
    stiffness = List.copyOf(stiffness);
    damping = List.copyOf(damping);
    preload = List.copyOf(preload);
    if (stiffness.size() != 36 || damping.size() != 36 || preload.size() != 6) {
      throw new IllegalArgumentException(
          "bushing " + name + " needs 36 stiffnesses, 36 dampings and 6 preloads");
    }
  }

  /** {@inheritDoc} Displacement, rotation vector, force and moment on body 2, axes of frame 1. */
  @Override
  public List<Variable> values(Function<Coordinate, Joint> jointOf) {
    return List.of(
        new Variable("x", "m"),
        new Variable("y", "m"),
        new Variable("z", "m"),
        new Variable("rx", "rad"),
        new Variable("ry", "rad"),
        new Variable("rz", "rad"),
        new Variable("fx", "N"),
        new Variable("fy", "N"),
        new Variable("fz", "N"),
        new Variable("tx", "N·m"),
        new Variable("ty", "N·m"),
        new Variable("tz", "N·m"));
  }

  /** {@inheritDoc} K, C and preload. */
  @Override
  public List<Coefficient> coefficients() {
    List<Coefficient> all = new ArrayList<>();
    stiffness.forEach(k -> all.add(new Coefficient("stiffness", k, Condition.FINITE)));
    damping.forEach(c -> all.add(new Coefficient("damping", c, Condition.FINITE)));
    preload.forEach(f -> all.add(new Coefficient("preload", f, Condition.FINITE)));
    return all;
  }

  /** Returns its law. */
  public PairLaw pairLaw() {
    return law == Law.ENERGY ? PairLaw.BUSHING : PairLaw.LINEAR_BUSHING;
  }

  @Override
  public String kind() {
    return "bushing";
  }

  @Override
  public <R> R accept(ForceVisitor<R> visitor) {
    return visitor.bushing(this);
  }

  @Override
  public List<Integer> bodies() {
    return List.of(frame1.body(), frame2.body());
  }
}
