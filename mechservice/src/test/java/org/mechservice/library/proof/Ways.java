package org.mechservice.library.proof;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;

/**
 * Forces, torques, states, tables and maps that act over a short way of a coordinate. The energy
 * gives the velocity, v²/2 = v0²/2 + ∫ a(x) dx, and the time to a place is ∫ dx/v: the run ends at
 * the time at which the body is at a chosen place, by quadrature between the corners.
 */
final class Ways implements ProofSet {
  private enum Target {
    /** The force pushes the body itself. */
    JOINT_FORCE,
    FORCE_TORQUE,
    TORQUE,
    /** It pushes another body by the place of this one. */
    OTHER_BODY,
    OTHER_BY_POINT,
    OTHER_BY_DRIVE,
    OTHER_BY_ROTOR,
    /** It is the rate of a state. */
    STATE,
    FILTER
  }

  @Override
  public String title() {
    return "short ways";
  }

  @Override
  public int size() {
    return 500;
  }

  @Override
  public String before() {
    return "379 of 456";
  }

  @Override
  public Optional<Scene> scene(long seed) {
    Random random = new Random(15485863 * seed);
    Target target = Target.values()[(int) ((seed - 1) % Target.values().length)];
    boolean pushesItself =
        target == Target.JOINT_FORCE || target == Target.FORCE_TORQUE || target == Target.TORQUE;
    boolean turns = target == Target.TORQUE || target == Target.OTHER_BY_ROTOR;
    double reach = Spread.log(random, 1, 200);
    Sweep sweep = Sweep.any(random, reach, random.nextInt(3) == 0);
    Window.Kind kind = Window.any(random);
    double width = Spread.log(random, 1e-5, 0.03) * reach;
    double from = Spread.even(random, 0.1, 0.85) * reach;
    Window window = sweep.window(kind, from, width);
    if (!(window.high() - window.low() > 1e-7 * Math.abs(window.high()))) {
      window = new Window(kind, window.low() - 1e-6, window.high() + 1e-6);
    }
    Window narrow = window;
    DoubleUnaryOperator shape = narrow.values();
    DoubleUnaryOperator bump = x -> shape.applyAsDouble(sweep.at(x));
    double[] places = sweep.inverse(narrow.places());
    double content = Quadrature.of(bump, places, 0, reach);
    if (!(content > 1e-9 * reach)) {
      return Optional.empty();
    }
    double speed = Spread.log(random, 0.5, 50);
    Method method = Method.any(random);
    double mass = Spread.log(random, 0.1, 10);
    SceneText scene = new SceneText().table(narrow.tables()).body("a", mass, turns ? mass : 0.01);
    String coordinate = "x.q";
    double end;
    List<Expected> expected;
    if (pushesItself) {
      // a tenth to twice of the energy
      double size = Spread.rounded(speed * speed / 2 / content * Spread.log(random, 0.1, 2));
      Passage passage = Passage.of(bump, size, places, reach, speed);
      end = passage.time();
      double v = passage.speed();
      if (target == Target.FORCE_TORQUE) {
        coordinate = "a.o.x";
      }
      String force = mass * size + "*" + narrow.text(sweep.text(coordinate));
      scene.force(
          target == Target.FORCE_TORQUE
              ? "<forceTorque name='f' body='a' point='o' fx='" + force + "'/>"
              : "<jointForce name='f' joint='x' expression='" + force + "'/>");
      double effect = v - speed;
      double allowedQ = method.allowed(reach);
      double allowedV = method.allowed(v);
      expected =
          List.of(
              new Expected(
                  "x.q",
                  reach,
                  allowedQ + end * allowedV,
                  Math.max(effect * end * 0.1, reach - speed * end)),
              new Expected("x.v", v, allowedV, effect));
    } else {
      double size = Spread.rounded(speed * Spread.log(random, 0.3, 3) / content);
      end = reach / speed;
      if (target == Target.OTHER_BY_POINT) {
        coordinate = "a.o.x";
      }
      String rate = size + "*" + narrow.text(sweep.text(coordinate));
      double timeOf = 1 / speed;
      if (target == Target.STATE) {
        double value = size * content * timeOf;
        scene.state("<state name='s' derivative='" + rate + "'/>");
        expected = List.of(new Expected("s", value, method.allowed(value), value));
      } else if (target == Target.FILTER) {
        double lag = Spread.rounded(end * Spread.log(random, 0.3, 3));
        double last = end;
        double value =
            Quadrature.of(
                x -> size * timeOf * bump.applyAsDouble(x) * Math.exp(-(last - x * timeOf) / lag),
                places,
                0,
                reach);
        scene.state("<state name='s' derivative='" + rate + " - s/" + lag + "'/>");
        double peak = size * content * timeOf;
        expected = List.of(new Expected("s", value, method.allowed(peak), value));
      } else {
        double other = Spread.log(random, 0.1, 10);
        double last = end;
        double v = size * content * timeOf;
        double q =
            Quadrature.of(
                x -> size * timeOf * bump.applyAsDouble(x) * (last - x * timeOf), places, 0, reach);
        scene
            .body("b", other, 0.01)
            .joint("y", "P", "Ground", "o", "b", "y", "")
            .force("<jointForce name='f' joint='y' expression='" + other + "*" + rate + "'/>");
        double allowedV = method.allowed(v);
        expected =
            List.of(
                new Expected(
                    "y.q", q, method.allowed(q) + end * allowedV, Math.max(q, 0.1 * v * end)),
                new Expected("y.v", v, allowedV, v));
      }
    }
    boolean driven = target == Target.OTHER_BY_DRIVE;
    scene.joint("x", turns ? "R" : "P", "Ground", "o", "a", turns ? "z" : "x", "");
    if (driven) {
      scene.driven("x", speed + "*t");
    } else {
      scene.start("x", 0, speed);
    }
    double row = Spread.rounded(end / Spread.one(random, 1, 5, 20, 100));
    String name = target.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    String detail =
        "("
            + kind.name().toLowerCase(Locale.ROOT)
            + " of "
            + sweep.kind().name().toLowerCase(Locale.ROOT)
            + ")";
    double shortest = sweep.shortest(narrow) / speed / 3;
    return Optional.of(
        new Scene(name, detail, method, scene.with(end, row, method), shortest, expected));
  }

  /**
   * A body of mass 1 that passes a force of its place.
   *
   * @param time to the end of the way, s
   * @param speed there
   */
  private record Passage(double time, double speed) {
    static Passage of(
        DoubleUnaryOperator bump, double size, double[] places, double reach, double speed) {
      double[] pieces = Quadrature.pieces(places, 0, reach);
      double square = speed * speed;
      double time = 0;
      for (int i = 0; i + 1 < pieces.length; i++) {
        double from = pieces[i];
        double before = square;
        time +=
            Quadrature.smooth(
                x -> 1 / Math.sqrt(before + 2 * size * Quadrature.smooth(bump, from, x)),
                from,
                pieces[i + 1]);
        square += 2 * size * Quadrature.smooth(bump, from, pieces[i + 1]);
      }
      return new Passage(time, Math.sqrt(square));
    }
  }
}
