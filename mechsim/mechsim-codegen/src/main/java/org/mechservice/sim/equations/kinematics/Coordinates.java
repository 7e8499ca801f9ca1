package org.mechservice.sim.equations.kinematics;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import org.mechservice.solver.links.Labels;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.step.EulerParameterTerms;
import org.mechservice.solver.step.JointTerms;
import org.mechservice.solver.step.LinkNumbers;
import org.mechservice.solver.step.LinkStep;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/** Coordinates of the links in one program, with their sines and cosines. */
public final class Coordinates {
  private static final int NONE = -1;

  private final Program program;
  private final Expressions expressions;
  private final TimeFunctions functions;
  private final Differentiation byTime;
  private final IdentityHashMap<Link, ScalarMatrix> rotations = new IdentityHashMap<>();
  private final IdentityHashMap<Link, LinkStep> steps = new IdentityHashMap<>();
  private final int derivative;
  private Function<Link, DoubleFunction<Scalar>> forms;

  /** Creates coordinates with zero joint accelerations, except those of driven joints. */
  public Coordinates(Program program, Links links) {
    this(program, links, NONE);
  }

  /**
   * Creates coordinates with joint accelerations as inputs; y' begins at input {@code derivative}.
   */
  public Coordinates(Program program, Links links, int derivative) {
    this.program = program;
    this.derivative = derivative;
    this.expressions = program.expressions();
    this.functions = new TimeFunctions(expressions);
    this.byTime =
        new Differentiation(
            expressions, Map.of(expressions.input(Program.TIME), expressions.one()));
    this.forms = link -> expressions::constant;
    nameParameters(links.mechanism().parameters());
  }

  /**
   * Writes the equations of the links of a large mechanism so that many share a form ({@link
   * LinkForms}): for recursions, whose sections each belong to one link. Returns this.
   */
  public Coordinates inSharedForms(Links links) {
    forms = new LinkForms(expressions, links.links())::numbers;
    return this;
  }

  private void nameParameters(List<Parameter> parameters) {
    for (int i = 0; i < parameters.size(); i++) {
      String name = "p_" + Labels.sanitized(parameters.get(i).name());
      program.named(name, expressions.input(Program.PARAMETER + i));
    }
  }

  /** Returns the link's coordinate, rad or m. */
  public Scalar position(Link link) {
    return named("q_", link, drivenOr(link, link.position()));
  }

  /** Returns the link's velocity, rad/s or m/s. */
  public Scalar velocity(Link link) {
    return link.isDriven()
        ? named("v_", link, byTime.of(position(link)))
        : named("v_", link, expressions.input(link.velocity()));
  }

  /** Returns the known joint acceleration of the link: 0 unless it is driven or an input. */
  public Scalar knownAcceleration(Link link) {
    if (link.isDriven()) {
      return named("a_", link, byTime.of(velocity(link)));
    }
    return derivative == NONE
        ? expressions.zero()
        : named("a_", link, expressions.input(derivative + link.velocity()));
  }

  /** Returns the known joint acceleration of a ball, in the axes of {@link #ballVelocity}. */
  public ScalarVector knownBallAcceleration(Link link) {
    if (link.isDriven()) {
      List<Scalar> rates = eulerParameters(link).e().stream().map(byTime::of).toList();
      return program.named(
          "a_" + link.jointLabel(), turnRate(link, rates.stream().map(byTime::of).toList()));
    }
    return derivative == NONE
        ? ScalarVector.zero(expressions)
        : program.named("a_" + link.jointLabel(), inputs(derivative + link.velocity()));
  }

  private Scalar drivenOr(Link link, int input) {
    return link.isDriven() ? functions.scalar(link.motion().get(0)) : expressions.input(input);
  }

  /** Returns 2 E(e) d for the Euler parameters e of a ball: ω of d = e′, and ω′ of d = e″. */
  private ScalarVector turnRate(Link link, List<Scalar> d) {
    List<Scalar> e = eulerParameters(link).e();
    Scalar[] rate = new Scalar[3];
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      Scalar along = e.get(0).times(d.get(i + 1)).minus(e.get(i + 1).times(d.get(0)));
      Scalar across = e.get(j + 1).times(d.get(k + 1)).minus(e.get(k + 1).times(d.get(j + 1)));
      rate[i] = along.plus(across).times(2);
    }
    return new ScalarVector(rate[0], rate[1], rate[2]);
  }

  private Scalar named(String kind, Link link, Scalar value) {
    return program.named(kind + link.jointLabel(), value);
  }

  /** Returns the displacement along z, m. */
  public Scalar way(Link link) {
    return position(link).times(link.way());
  }

  /** Returns its rate, m/s. */
  public Scalar wayRate(Link link) {
    return velocity(link).times(link.way());
  }

  /** Returns the sine of a turning link's angle. */
  public Scalar sine(Link link) {
    return named("sin_", link, expressions.sine(position(link)));
  }

  /** Returns the cosine of a turning link's angle. */
  public Scalar cosine(Link link) {
    return named("cos_", link, expressions.cosine(position(link)));
  }

  /** Returns the angular velocity of the file's body 2 relative to body 1, in body 1's axes. */
  public ScalarVector ballVelocity(Link link) {
    return program.named(
        "v_" + link.jointLabel(),
        link.isDriven()
            ? turnRate(link, eulerParameters(link).e().stream().map(byTime::of).toList())
            : inputs(link.velocity()));
  }

  private ScalarVector inputs(int first) {
    return new ScalarVector(
        expressions.input(first), expressions.input(first + 1), expressions.input(first + 2));
  }

  /** Returns the Euler parameters of the state, or of unit length those of a motion. */
  public EulerParameterTerms eulerParameters(Link link) {
    Scalar[] e = new Scalar[4];
    for (int i = 0; i < 4; i++) {
      e[i] =
          link.isDriven()
              ? functions.scalar(link.motion().get(i))
              : expressions.input(link.position() + i);
      program.named("e" + i + "_" + link.jointLabel(), e[i]);
    }
    return new EulerParameterTerms(List.of(e));
  }

  /** Returns the rotation from the link's axes to its parent's, by R(e/|e|) or its transpose. */
  public ScalarMatrix ballRotation(Link link) {
    ScalarMatrix known = rotations.get(link);
    if (known == null) {
      ScalarMatrix rotation = eulerParameters(link).rotation();
      known = link.inverse() ? rotation.transposed() : rotation;
      program.named("R_" + link.jointLabel(), known);
      rotations.put(link, known);
    }
    return known;
  }

  /**
   * Returns a number of a link as a scalar, in the form in which the equations of that link are
   * written.
   */
  public Scalar number(Link link, double value) {
    return forms.apply(link).apply(value);
  }

  /** Returns a vector of a link in scalars, likewise. */
  public ScalarVector numbers(Link link, Vector3 v) {
    return new ScalarVector(number(link, v.x()), number(link, v.y()), number(link, v.z()));
  }

  /** Returns the step from a link's parent to the link and back. */
  public LinkStep step(Link link) {
    return steps.computeIfAbsent(
        link,
        key ->
            new LinkStep(
                expressions, LinkNumbers.of(expressions, key, forms.apply(key)), new Terms(key)));
  }

  /** The coordinates of a link's joint. */
  private final class Terms implements JointTerms {
    private final Link link;

    Terms(Link link) {
      this.link = link;
    }

    @Override
    public Scalar cosine() {
      return Coordinates.this.cosine(link);
    }

    @Override
    public Scalar sine() {
      return Coordinates.this.sine(link);
    }

    @Override
    public Scalar way() {
      return Coordinates.this.way(link);
    }

    @Override
    public Scalar wayRate() {
      return Coordinates.this.wayRate(link);
    }

    @Override
    public Scalar velocity() {
      return Coordinates.this.velocity(link);
    }

    @Override
    public Scalar knownAcceleration() {
      return Coordinates.this.knownAcceleration(link);
    }

    @Override
    public ScalarMatrix ballRotation() {
      return Coordinates.this.ballRotation(link);
    }

    @Override
    public ScalarVector ballVelocity() {
      return Coordinates.this.ballVelocity(link);
    }

    @Override
    public ScalarVector knownBallAcceleration() {
      return Coordinates.this.knownBallAcceleration(link);
    }
  }

  /**
   * Converts rates or moments of a ball to the form of the state: those of the file's body 2
   * relative to its body 1, in the axes of body 1.
   *
   * @param inLink in link axes, of the link relative to its parent
   */
  public ScalarVector ballToState(Link link, ScalarVector inLink) {
    return step(link).ballToState(inLink);
  }
}
