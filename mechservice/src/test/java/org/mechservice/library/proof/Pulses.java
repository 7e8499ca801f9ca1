package org.mechservice.library.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;

/**
 * Pulses in time, down to 1e-6 of the interval, in everything that may be a function of time. All
 * scenes are linear, so their ends are integrals of the pulse with the response to an impulse
 * (Duhamel), by quadrature between the corners of the pulse.
 */
final class Pulses implements ProofSet {
  private enum Target {
    JOINT_FORCE,
    FORCE_TORQUE,
    GRAVITY,
    STATE,
    FILTER,
    TRANSFER_FUNCTION,
    STATE_THAT_PUSHES,
    COUPLING,
    CONTROLLER,
    INPUT_TABLE,
    DRIVE,
    CONSTRAINT
  }

  @Override
  public String title() {
    return "pulses in time";
  }

  @Override
  public int size() {
    return 500;
  }

  @Override
  public String before() {
    return "252 of 465";
  }

  @Override
  public Optional<Scene> scene(long seed) {
    Random random = new Random(104729 * seed);
    Target target = Target.values()[(int) ((seed - 1) % Target.values().length)];
    boolean driven = target == Target.DRIVE || target == Target.CONSTRAINT;
    double end = Spread.log(random, 0.1, 100);
    Sweep sweep = Sweep.any(random, end, target == Target.INPUT_TABLE || random.nextInt(3) == 0);
    if (driven && sweep.kind() == Sweep.Kind.FRACTION) {
      // a drive must not jump
      sweep = new Sweep(Sweep.Kind.PLAIN, end, sweep.rate());
    }
    Window.Kind kind;
    do {
      kind = Window.any(random);
    } while ((driven && !kind.drives()) || (target == Target.INPUT_TABLE && !kind.isTable()));
    if (driven && random.nextBoolean()) {
      kind = Window.Kind.RISE;
    }
    // a carriage that is back at once moves its passenger by its width
    double least = !driven ? 1e-6 : kind == Window.Kind.RISE ? 1e-3 : 0.03;
    double width = Spread.log(random, least, 0.1) * end;
    double from = Spread.even(random, 0.1, 0.85) * end;
    Window window = sweep.window(kind, from, width);
    if (driven && window.values().applyAsDouble(sweep.at(0)) > 1e-12) {
      // the carriage starts at rest
      sweep = new Sweep(Sweep.Kind.PLAIN, end, sweep.rate());
      window = sweep.window(kind, from, width);
    }
    if (!(window.high() - window.low() > 1e-7 * Math.abs(window.high()))) {
      // a wave at its crest: wider, or its digits are lost
      window = new Window(kind, window.low() - 1e-6, window.high() + 1e-6);
    }
    Sweep along = sweep;
    DoubleUnaryOperator shape = window.values();
    DoubleUnaryOperator pulse = t -> shape.applyAsDouble(along.at(t));
    double[] places = along.inverse(window.places());
    double content = Quadrature.of(pulse, places, 0, end);
    if (!(content > 1e-9 * end)) {
      return Optional.empty();
    }
    Method any = Method.any(random);
    Method method = target == Target.CONSTRAINT ? any.forLoops() : any;
    double mass = Spread.log(random, 0.1, 10);
    boolean springs =
        driven || target == Target.COUPLING || target == Target.CONTROLLER || random.nextBoolean();
    double own = springs ? Spread.rounded(2 * Math.PI * Spread.log(random, 0.3, 5) / end) : 0;
    double ratio = springs && random.nextBoolean() ? Spread.log(random, 0.01, 0.5) : 0;
    if (driven || target == Target.COUPLING) {
      // the damper would follow the pulse, too
      ratio = 0;
    }
    boolean moves = springs && !driven && random.nextInt(3) == 0;
    double q0 = moves ? Spread.even(random, -1, 1) : 0;
    double v0 = moves ? Spread.even(random, -1, 1) * own : 0;
    // an impulse that changes the velocity by some m/s
    double change = Spread.log(random, 0.3, 3);
    double size = driven ? Spread.log(random, 0.03, 0.3) : Spread.rounded(change / content);
    String text = window.text(along.text("t"));
    double k = Spread.rounded(mass * own * own);
    double c = Spread.rounded(2 * ratio * own * mass);
    SceneText scene = new SceneText().table(window.tables()).body("a", mass, 0.01);
    String spring = springs ? "stiffness='" + k + "' damping='" + c + "'" : "";
    double gain = size;
    switch (target) {
      case JOINT_FORCE, INPUT_TABLE -> {
        String value = text;
        if (target == Target.INPUT_TABLE) {
          scene.state("<input name='u' table='narrow'/>");
          value = "u";
        }
        scene.force(
            "<jointForce name='f' joint='x' expression='" + mass * size + "*" + value + "'/>");
      }
      case FORCE_TORQUE ->
          scene.force(
              "<forceTorque name='f' body='a' point='o' fx='" + mass * size + "*" + text + "'/>");
      case GRAVITY -> scene.gravity(size + "*" + text, "0", "0");
      case STATE -> {
        scene.state("<state name='s' derivative='" + size + "*" + text + "'/>");
        return Optional.of(
            ofStates(
                target,
                sweep,
                window,
                scene,
                spring,
                end,
                random,
                method,
                size * content,
                size * content,
                "s"));
      }
      case FILTER, TRANSFER_FUNCTION -> {
        double lag = Spread.rounded(end * Spread.log(random, 0.3, 3));
        double amount = Spread.rounded(size * lag);
        scene.state(
            target == Target.FILTER
                ? "<state name='s' derivative='(" + amount + "*" + text + " - s)/" + lag + "'/>"
                : "<transferFunction name='s' input='"
                    + amount
                    + "*"
                    + text
                    + "' num='1' den='"
                    + lag
                    + ";1'/>");
        scene.output("y", "s");
        double value =
            Quadrature.of(
                t -> amount / lag * pulse.applyAsDouble(t) * Math.exp(-(end - t) / lag),
                places,
                0,
                end);
        return Optional.of(
            ofStates(
                target,
                sweep,
                window,
                scene,
                spring,
                end,
                random,
                method,
                value,
                size * content,
                target == Target.FILTER ? "s" : "s.x1"));
      }
      case STATE_THAT_PUSHES -> {
        scene
            .state("<state name='s' derivative='" + size + "*" + text + "'/>")
            .force("<jointForce name='f' joint='x' expression='" + mass + "*s'/>");
        spring = "";
        q0 = 0;
        v0 = 0;
      }
      case COUPLING -> {
        spring = "";
        gain = size;
        scene.force(
            "<couplingSpringDamper name='f' k='"
                + k
                + "' expression='x.q - "
                + Spread.rounded(mass * size / k)
                + "*"
                + text
                + "'/>");
        gain = Spread.rounded(mass * size / k) * k / mass;
      }
      case CONTROLLER -> {
        double damping = c;
        spring = damping == 0 ? "" : "damping='" + damping + "'";
        double amount = Spread.rounded(mass * size / k);
        scene
            .state(
                "<pid name='r' kp='"
                    + k
                    + "' measured='x.q' setpoint='"
                    + amount
                    + "*"
                    + text
                    + "'/>")
            .force("<jointForce name='f' joint='x' expression='r'/>");
        gain = amount * k / mass;
      }
      default -> {
        scene.body("d", 1, 0.01);
        if (target == Target.CONSTRAINT) {
          scene.startText("");
        }
      }
    }
    if (driven) {
      return drivenScene(
          target,
          sweep,
          window,
          scene,
          spring,
          end,
          random,
          method,
          // as in the file, whose stiffness is rounded
          k / mass,
          pulse,
          places,
          size,
          text,
          own);
    }
    double by = springs && target != Target.STATE_THAT_PUSHES ? k / mass : 0;
    Oscillator exact =
        by == 0
            ? new Oscillator(0, 0)
            : new Oscillator(Math.sqrt(by), c == 0 ? 0 : c / (2 * mass * Math.sqrt(by)));
    double weight = gain;
    double q;
    double v;
    if (target == Target.STATE_THAT_PUSHES) {
      q = Quadrature.of(t -> weight * pulse.applyAsDouble(t) * square(end - t) / 2, places, 0, end);
      v = Quadrature.of(t -> weight * pulse.applyAsDouble(t) * (end - t), places, 0, end);
    } else {
      q =
          Quadrature.of(
              t -> weight * pulse.applyAsDouble(t) * exact.response(end - t), places, 0, end);
      v = Quadrature.of(t -> weight * pulse.applyAsDouble(t) * exact.rate(end - t), places, 0, end);
    }
    double right = q + exact.position(q0, v0, end);
    double speed = v + exact.velocity(q0, v0, end);
    scene.joint("x", "P", "Ground", "o", "a", "x", spring);
    if (moves && target != Target.STATE_THAT_PUSHES) {
      scene.start("x", q0, v0);
    }
    double slow = Math.max(exact.frequency(), 1 / end);
    double effect = Math.hypot(v, slow * q);
    double allowedQ = method.allowed(Math.abs(right) + effect / slow);
    double allowedV = method.allowed(Math.abs(speed) + effect);
    List<Expected> expected =
        List.of(
            new Expected("x.q", right, allowedQ + allowedV / slow, effect / slow),
            new Expected("x.v", speed, allowedV + slow * allowedQ, effect));
    return Optional.of(scene(target, sweep, window, scene, end, random, method, expected));
  }

  private static double square(double x) {
    return x * x;
  }

  private static Scene scene(
      Target target,
      Sweep sweep,
      Window window,
      SceneText scene,
      double end,
      Random random,
      Method method,
      List<Expected> expected) {
    double row = Spread.rounded(end / Spread.one(random, 1, 5, 20, 100));
    String kind = target.name().toLowerCase(java.util.Locale.ROOT).replace('_', ' ');
    String detail =
        " ("
            + window.kind().name().toLowerCase(java.util.Locale.ROOT)
            + " of "
            + sweep.kind().name().toLowerCase(java.util.Locale.ROOT)
            + ")";
    return new Scene(
        kind,
        detail.strip(),
        method,
        scene.with(end, row, method),
        sweep.shortest(window),
        expected);
  }

  private static Scene ofStates(
      Target target,
      Sweep sweep,
      Window window,
      SceneText scene,
      String spring,
      double end,
      Random random,
      Method method,
      double value,
      double peak,
      String column) {
    scene.joint("x", "P", "Ground", "o", "a", "x", spring);
    List<Expected> expected = new ArrayList<>();
    expected.add(
        new Expected(column, value, method.allowed(peak), Math.min(Math.abs(value), peak)));
    return scene(target, sweep, window, scene, end, random, method, expected);
  }

  /** A passenger on a spring, whose carriage follows the pulse. */
  private static Optional<Scene> drivenScene(
      Target target,
      Sweep sweep,
      Window window,
      SceneText scene,
      String spring,
      double end,
      Random random,
      Method method,
      double square,
      DoubleUnaryOperator pulse,
      double[] places,
      double size,
      String text,
      double own) {
    Oscillator exact = new Oscillator(Math.sqrt(square), 0);
    double z =
        Quadrature.of(
            t -> square * size * pulse.applyAsDouble(t) * exact.response(end - t), places, 0, end);
    double v =
        Quadrature.of(
            t -> square * size * pulse.applyAsDouble(t) * exact.rate(end - t), places, 0, end);
    scene
        .joint("d", "P", "Ground", "o", "d", "x", "")
        .joint("x", "P", "d", "o", "a", "x", spring)
        .output("z", "a.o.x")
        .output("w", "a.o.vx");
    if (target == Target.DRIVE) {
      scene.driven("d", size + "*" + text);
    } else {
      scene.constraint("<CoordConstraint name='c' expression='d.q - " + size + "*" + text + "'/>");
    }
    double effect = Math.hypot(v, own * z);
    if (effect < 0.01 * size * own) {
      return Optional.empty();
    }
    double fastest = size / (window.high() - window.low());
    double allowedQ = method.allowed(size);
    double allowedV = method.allowed(Math.max(effect, fastest));
    List<Expected> expected =
        List.of(
            new Expected("z", z, allowedQ + allowedV / own, effect / own),
            new Expected("w", v, allowedV + own * allowedQ, effect));
    return Optional.of(scene(target, sweep, window, scene, end, random, method, expected));
  }
}
