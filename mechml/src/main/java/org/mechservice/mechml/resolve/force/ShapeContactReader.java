package org.mechservice.mechml.resolve.force;

import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.call;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.isZero;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.larger;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.minus;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.negated;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.product;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.quotient;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.root;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.smaller;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.square;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.sum;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.times;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FrameReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Reads {@code sphereContact}, {@code discContact}, {@code boxContact} and a {@code contact} that
 * sticks: contacts of shapes whose depth, normal and place are formulas of the relative pose.
 */
final class ShapeContactReader {
  /** Keeps the distance from a surface differentiable where it is zero, m². */
  private static final Expression TINY = Expression.of(1e-200);

  /** Keeps the direction to the lowest point of a disc defined where the disc lies flat. */
  private static final Expression FLAT = Expression.of(1e-24);

  private final FormulaReader formulas;
  private final MechanismNames names;
  private final FrameReader frames;
  private final ContactLawReader laws;
  private final List<FurtherState> states;
  private final Diagnostics diagnostics;

  /**
   * @param states receives the states of friction that sticks
   */
  ShapeContactReader(
      ValueReader values,
      FormulaReader formulas,
      MechanismNames names,
      List<FurtherState> states,
      Diagnostics diagnostics) {
    this.formulas = formulas;
    this.names = names;
    this.frames = new FrameReader(names, diagnostics);
    this.laws = new ContactLawReader(values, formulas, diagnostics);
    this.states = states;
    this.diagnostics = diagnostics;
  }

  /** Returns a contact of two shapes; empty after a reported error. */
  Optional<PairForce> read(Element element) {
    return switch (element.name()) {
      case "sphereContact" -> sphere(element);
      case "discContact" -> disc(element);
      case "boxContact" -> box(element);
      default -> ball(element);
    };
  }

  private Optional<ContactFormulas> contact(
      Element element, Optional<BodyFrame> frame1, Optional<BodyFrame> frame2) {
    Optional<ContactCoefficients> law = laws.read(element);
    if (law.isEmpty() || frame1.isEmpty() || frame2.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new ContactFormulas(
            element.required("name"),
            law.get(),
            RelativeFrames.of(frame1.get(), frame2.get()),
            states,
            names.origin(element)));
  }

  private Optional<BodyFrame> plane(Element element) {
    Element carrier = element.requiredChild("body1");
    boolean normal = frames.direction(carrier, "the normal of the surface").isPresent();
    return normal ? frames.read(carrier) : Optional.empty();
  }

  private static double number(Expression value) {
    return value instanceof Expression.Constant constant ? constant.value() : 0;
  }

  /** A sphere or point on a plane: its lowest point is its radius below the centre. */
  private Optional<PairForce> ball(Element element) {
    Optional<Expression> radius = formulas.notNegative(element, "radius", Quantity.LENGTH);
    Optional<BodyFrame> frame1 = plane(element);
    Optional<BodyFrame> frame2 = frames.read(element.requiredChild("body2"));
    Optional<ContactFormulas> contact = contact(element, frame1, frame2);
    if (contact.isEmpty() || radius.isEmpty()) {
      return Optional.empty();
    }
    RelativeFrames motion = contact.get().frames();
    contact
        .get()
        .add(
            minus(radius.get(), motion.displacement().z()),
            ExpressionVector.Z,
            ExpressionVector.Z.times(negated(radius.get())));
    return Optional.of(
        contact.get().force("contact", radius.get(), new PairForce.Sphere(number(radius.get()))));
  }

  /**
   * A sphere beside a box, a capsule or a sphere, which are all boxes with rounded edges: the
   * closest point of the box to the centre r has the components r between −h and h; a centre within
   * the box is pushed out through the closest face.
   */
  private Optional<PairForce> sphere(Element element) {
    Optional<Expression> radius2 = formulas.notNegative(element, "radius2", Quantity.LENGTH);
    Optional<Expression> radius1 = formulas.notNegative(element, "radius1", Quantity.LENGTH);
    Optional<Expression> length = formulas.notNegative(element, "length1", Quantity.LENGTH);
    boolean box = element.attribute("box1").isPresent();
    if (box && element.attribute("length1").isPresent()) {
      refuse(element, "box1 and length1 exclude each other: body1 is a box or a capsule");
      return Optional.empty();
    }
    if (!box && element.attribute("radius1").isEmpty()) {
      refuse(element, "neither radius1 nor box1 is given; one of them is the shape of body1");
      return Optional.empty();
    }
    Optional<ExpressionVector> half =
        box ? half(element, "box1") : Optional.of(ExpressionVector.ZERO);
    Optional<ContactFormulas> contact =
        contact(
            element,
            frames.read(element.requiredChild("body1")),
            frames.read(element.requiredChild("body2")));
    boolean read = radius1.isPresent() && radius2.isPresent() && length.isPresent();
    if (!read || half.isEmpty() || contact.isEmpty()) {
      return Optional.empty();
    }
    ExpressionVector segment =
        new ExpressionVector(Expression.ZERO, Expression.ZERO, times(0.5, length.get()));
    Surface surface = new Surface(contact.get().frames().displacement(), half.get().plus(segment));
    Expression reach = sum(radius1.get(), radius2.get());
    contact
        .get()
        .add(
            minus(reach, surface.distance()),
            surface.normal(),
            surface.normal().times(negated(radius2.get())));
    // A centre that is inside the other shape, or a point that is behind the middle of a box.
    List<Expression> sizes =
        box && isZero(radius2.get())
            ? half.get().components()
            : box ? List.of(radius2.get()) : List.of(radius1.get(), radius2.get());
    Expression most = leastSize(sizes);
    return Optional.of(
        contact
            .get()
            .force("contact of a sphere", most, new PairForce.Sphere(number(radius2.get()))));
  }

  /** Returns the smallest of sizes that are not zero, m; zero if all are. */
  private static Expression leastSize(List<Expression> sizes) {
    return sizes.stream()
        .filter(size -> !isZero(size))
        .reduce(ExpressionAlgebra::smaller)
        .orElse(Expression.ZERO);
  }

  /** Distance of a point r from a box of half edges h, negative inside, and its gradient. */
  private record Surface(Expression distance, ExpressionVector normal) {
    Surface(ExpressionVector r, ExpressionVector h) {
      this(parts(r, h), r, h);
    }

    private Surface(List<Expression> way, ExpressionVector r, ExpressionVector h) {
      this(distance(way, r, h), normal(way, r, h));
    }

    /** r less its closest point of the box. */
    private static List<Expression> parts(ExpressionVector r, ExpressionVector h) {
      List<Expression> way = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        Expression at = r.components().get(i);
        Expression half = h.components().get(i);
        way.add(isZero(half) ? at : minus(at, larger(negated(half), smaller(half, at))));
      }
      return way;
    }

    private static Expression outside(List<Expression> way) {
      ExpressionVector e = ExpressionVector.of(way);
      return root(sum(e.dot(e), TINY));
    }

    private static boolean isBox(ExpressionVector h) {
      return h.components().stream().noneMatch(ExpressionAlgebra::isZero);
    }

    /** |r| − h of each axis: how far beyond the faces. */
    private static List<Expression> beyond(ExpressionVector r, ExpressionVector h) {
      List<Expression> beyond = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        beyond.add(minus(call(MathFunction.ABS, r.components().get(i)), h.components().get(i)));
      }
      return beyond;
    }

    private static Expression distance(
        List<Expression> way, ExpressionVector r, ExpressionVector h) {
      if (!isBox(h)) {
        return outside(way);
      }
      List<Expression> q = beyond(r, h);
      Expression furthest = larger(larger(q.get(0), q.get(1)), q.get(2));
      return sum(outside(way), smaller(Expression.ZERO, furthest));
    }

    private static ExpressionVector normal(
        List<Expression> way, ExpressionVector r, ExpressionVector h) {
      ExpressionVector away =
          ExpressionVector.of(way).times(quotient(Expression.of(1), outside(way)));
      if (!isBox(h)) {
        return away;
      }
      List<Expression> q = beyond(r, h);
      Expression inside =
          call(MathFunction.STEP, negated(larger(larger(q.get(0), q.get(1)), q.get(2))));
      Expression one = Expression.of(1);
      Expression x = call(MathFunction.STEP, minus(q.get(0), larger(q.get(1), q.get(2))));
      Expression y = product(minus(one, x), call(MathFunction.STEP, minus(q.get(1), q.get(2))));
      Expression z = minus(minus(one, x), y);
      ExpressionVector face =
          new ExpressionVector(
              product(x, call(MathFunction.SIGNUM, r.x())),
              product(y, call(MathFunction.SIGNUM, r.y())),
              product(z, call(MathFunction.SIGNUM, r.z())));
      return away.plus(face.times(inside));
    }
  }

  /**
   * The edge of a disc on a plane: with the axle a the lowest point of the circle is R (a_z a − z)
   * / √(a_x² + a_y²) from the centre, and that of a rounded edge its radius lower.
   */
  private Optional<PairForce> disc(Element element) {
    Optional<Expression> radius = formulas.positive(element, "radius", Quantity.LENGTH);
    Optional<Expression> edge = formulas.notNegative(element, "edge", Quantity.LENGTH);
    Element wheel = element.requiredChild("body2");
    boolean axle = frames.direction(wheel, "the axis of the disc").isPresent();
    Optional<ContactFormulas> contact =
        contact(element, plane(element), axle ? frames.read(wheel) : Optional.empty());
    if (contact.isEmpty() || radius.isEmpty() || edge.isEmpty()) {
      return Optional.empty();
    }
    RelativeFrames motion = contact.get().frames();
    ExpressionVector a = motion.axis2(2);
    Expression tilt = root(sum(sum(square(a.x()), square(a.y())), FLAT));
    ExpressionVector down = a.times(a.z()).less(ExpressionVector.Z);
    ExpressionVector arm =
        down.times(quotient(radius.get(), tilt)).less(ExpressionVector.Z.times(edge.get()));
    contact.get().add(negated(sum(motion.displacement().z(), arm.z())), ExpressionVector.Z, arm);
    double shown = number(radius.get()) + number(edge.get());
    return Optional.of(
        contact.get().force("contact of a disc", radius.get(), new PairForce.Disc(shown)));
  }

  /** The eight corners of a box on a plane. */
  private Optional<PairForce> box(Element element) {
    Optional<ExpressionVector> half = half(element, "box");
    Optional<ContactFormulas> contact =
        contact(element, plane(element), frames.read(element.requiredChild("body2")));
    if (contact.isEmpty() || half.isEmpty()) {
      return Optional.empty();
    }
    RelativeFrames motion = contact.get().frames();
    List<Expression> h = half.get().components();
    for (int corner = 0; corner < 8; corner++) {
      ExpressionVector arm = ExpressionVector.ZERO;
      for (int axis = 0; axis < 3; axis++) {
        double sign = (corner >> axis & 1) == 0 ? -1 : 1;
        arm = arm.plus(motion.axis2(axis).times(times(sign, h.get(axis))));
      }
      contact.get().add(negated(sum(motion.displacement().z(), arm.z())), ExpressionVector.Z, arm);
    }
    Vector3 edges = new Vector3(2 * number(h.get(0)), 2 * number(h.get(1)), 2 * number(h.get(2)));
    return Optional.of(
        contact.get().force("contact of a box", leastSize(h), new PairForce.Box(edges)));
  }

  /** Returns half of three edges, which must be positive. */
  private Optional<ExpressionVector> half(Element element, String attribute) {
    List<Expression> half = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      formulas
          .item(element, attribute, 3, i, Quantity.LENGTH)
          .filter(e -> formulas.satisfies(element, attribute, e, x -> x > 0, "must be positive"))
          .ifPresent(edge -> half.add(times(0.5, edge)));
    }
    return half.size() == 3 ? Optional.of(ExpressionVector.of(half)) : Optional.empty();
  }

  private void refuse(Element element, String message) {
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES, element.position(), element.label() + ": " + message);
  }
}
