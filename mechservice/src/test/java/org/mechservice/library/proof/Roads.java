package org.mechservice.library.proof;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;

/**
 * Quarters of cars that meet a bump after a while: over speed, length of the bump, kind of road,
 * contact or tyre, driven or rolling along. A sphere on a road without corners has a {@link
 * RoadCar} as its reference; one on a road with corners and a tyre has the same model in steps of a
 * thirtieth of the bump.
 */
final class Roads implements ProofSet {
  private enum Wheel {
    SPHERE_ON_SMOOTH_ROAD,
    SPHERE_THAT_ROLLS_FREE,
    SPHERE,
    TYRE
  }

  private enum Road {
    PROFILE,
    FORMULA,
    TABLE;

    Window.Kind shape(Random random) {
      return switch (this) {
        case PROFILE -> Window.Kind.SMOOTH_STEP;
        case FORMULA ->
            Spread.one(
                random,
                Window.Kind.SMOOTH_STEP,
                Window.Kind.GAUSS,
                Window.Kind.PARABOLA,
                Window.Kind.RAMP,
                Window.Kind.TRIANGLE,
                Window.Kind.ABSOLUTE);
        case TABLE ->
            Spread.one(
                random, Window.Kind.LINEAR_TABLE, Window.Kind.AKIMA_TABLE, Window.Kind.CUBIC_TABLE);
      };
    }
  }

  @Override
  public String title() {
    return "roads";
  }

  @Override
  public int size() {
    return 1000;
  }

  private static boolean isSmooth(Window.Kind kind) {
    return kind == Window.Kind.SMOOTH_STEP
        || kind == Window.Kind.GAUSS
        || kind == Window.Kind.PARABOLA;
  }

  @Override
  public String before() {
    return "15 of 44 of an earlier draw";
  }

  @Override
  public Optional<Scene> scene(long seed) {
    Random random = new Random(32452843 * seed);
    Wheel wheel = Wheel.values()[(int) ((seed - 1) % Wheel.values().length)];
    Road road = Road.values()[(int) ((seed - 1) / Wheel.values().length % Road.values().length)];
    Window.Kind shape = road.shape(random);
    boolean exact = wheel == Wheel.SPHERE_ON_SMOOTH_ROAD || wheel == Wheel.SPHERE_THAT_ROLLS_FREE;
    if (exact && !isSmooth(shape)) {
      road = Road.FORMULA;
      shape = Spread.one(random, Window.Kind.SMOOTH_STEP, Window.Kind.GAUSS, Window.Kind.PARABOLA);
    }
    double speed = Spread.log(random, 1, 60);
    double length = Spread.log(random, 0.03, 5);
    double way = Spread.log(random, 2, exact ? 200 : 20);
    Window bump = new Window(shape, way, Spread.rounded(way + length));
    double high = Spread.rounded(Math.min(0.1, length * Spread.even(random, 0.03, 0.3)));
    if (random.nextInt(4) == 0) {
      high = -high;
    }
    double amount = high;
    double wheelMass = Spread.even(random, 15, 60);
    double bodyMass = Spread.even(random, 150, 500);
    double stiffness = Spread.log(random, 8e3, 4e4);
    double damping = Spread.log(random, 300, 3000);
    double k = Spread.log(random, 2e5, 2e6);
    boolean damps = isSmooth(shape) && random.nextBoolean();
    double c = damps ? Spread.log(random, 30, 600) : 0;
    double wheelRadius = Spread.even(random, 0.2, 0.4);
    // a sphere fits into the foot of the bump
    double fitting = Spread.rounded(length * length / (200 * Math.abs(amount)));
    double radius =
        switch (wheel) {
          case TYRE -> wheelRadius;
          default -> Math.min(wheelRadius, fitting);
        };
    double end =
        Spread.rounded(
            (way + length) / speed + Spread.even(random, 0.01, 0.2) + 0.1 * length / speed);
    Method method = Method.any(random, 1e-4);
    double sag = (wheelMass + bodyMass) * RoadCar.G / k;
    double strut = bodyMass * RoadCar.G / stiffness;
    double free = 0.5;
    boolean rolls = wheel == Wheel.SPHERE_THAT_ROLLS_FREE;
    double carrier = 20;
    SceneText scene = new SceneText();
    if (rolls) {
      scene.body("car", carrier, 1);
    } else {
      scene.carrier("car");
    }
    scene
        .body("w", wheelMass, 1)
        .body("b", bodyMass, 1)
        .joint("x", "P", "Ground", "o", "car", "x", "")
        .joint("w", "P", "car", "o", "w", "z", "")
        .joint(
            "z",
            "P",
            "w",
            "o",
            "b",
            "z",
            "stiffness='" + stiffness + "' damping='" + damping + "' freePosition='" + free + "'")
        .gravity("0", "0", "-9.81");
    String height = amount + "*" + bump.text("s");
    String profile = "";
    String heightAttribute = " height='" + height + "'";
    if (road == Road.PROFILE && wheel != Wheel.TYRE) {
      double edge = 0.2 * (bump.high() - bump.low());
      profile =
          "<profile stations='"
              + bump.low()
              + ";"
              + (bump.low() + edge)
              + ";"
              + (bump.high() - edge)
              + ";"
              + bump.high()
              + "' heights='0;"
              + amount
              + ";"
              + amount
              + ";0'/>";
      heightAttribute = "";
    }
    if (road == Road.TABLE) {
      scene.table(bump.tables());
    }
    String law = " stiffness='" + k + "'" + (c == 0 ? "" : " damping='" + c + "'");
    if (wheel == Wheel.TYRE) {
      scene.force(
          "<tyre name='c' radius='"
              + radius
              + "'"
              + law
              + heightAttribute
              + " load='3000' longitudinal='100e3;0.11;3200;0.5;2900'"
              + " lateral='55e3;0.18;3000;0.6;2700'>"
              + "<body1 name='Ground' point='o' vector='z' vector2='x'/><body2 name='w' point='o'"
              + " vector='y'/></tyre>");
    } else {
      scene.force(
          "<contact name='c' radius='"
              + radius
              + "'"
              + law
              + heightAttribute
              + "><body1 name='Ground' point='o' vector='z' vector2='x'/><body2 name='w'"
              + " point='o'/>"
              + profile
              + "</contact>");
    }
    scene.start("w", radius - sag, 0).start("z", free - strut, 0);
    if (rolls) {
      scene.start("x", 0, speed);
    } else {
      scene.driven("x", speed + "*t");
    }
    double row = Spread.rounded(end / Spread.one(random, 1, 5, 20, 100));
    double fine = Math.min(1e-3, length / speed / 30);
    String name =
        wheel.name().toLowerCase(Locale.ROOT).replace('_', ' ')
            + " on "
            + road.name().toLowerCase(Locale.ROOT);
    String detail =
        "(%s, %.3g m at %.3g m/s)".formatted(shape.name().toLowerCase(Locale.ROOT), length, speed);
    String text = scene.with(end, row, method);
    Scene bare = new Scene(name, detail, method, text, 10 * fine, List.of());
    double[] start = {0, radius - sag, -strut, speed, 0, 0};
    if (!exact) {
      return ShortSteps.of(
              scene.with(end, end, method.at(1e-12, 1e-14).within(fine)),
              new String[] {"w.q", "z.q", "w.v", "z.v"},
              new double[] {radius - sag, free - strut, 0, 0},
              end,
              method)
          .map(bare::expecting);
    }
    DoubleUnaryOperator values = bump.values();
    DoubleUnaryOperator slope = isSmooth(shape) ? bump::slope : s -> 0;
    List<Double> corners =
        Arrays.stream(bump.places())
            .filter(s -> s > bump.low() - 3 * length && s < bump.high() + 3 * length)
            .sorted()
            .distinct()
            .boxed()
            .toList();
    RoadCar on =
        new RoadCar(
            wheelMass,
            bodyMass,
            rolls ? carrier + wheelMass + bodyMass : Double.POSITIVE_INFINITY,
            stiffness,
            damping,
            radius,
            new Law(k, 1, c),
            s -> amount * values.applyAsDouble(s),
            s -> amount * slope.applyAsDouble(s),
            corners,
            true,
            fine);
    RoadCar off =
        new RoadCar(
            wheelMass,
            bodyMass,
            on.carried(),
            stiffness,
            damping,
            radius,
            on.law(),
            on.height(),
            on.slope(),
            corners,
            false,
            fine);
    // the suspension is measured from its free length in the reference
    Optional<List<Expected>> expected =
        Ends.of(
            new String[] {"", "w.q", "z.q", rolls ? "x.v" : "", "w.v", "z.v"},
            on,
            off,
            start,
            end,
            method);
    return expected.map(
        list ->
            bare.expecting(
                list.stream().map(e -> e.column().equals("z.q") ? e.plus(free) : e).toList()));
  }
}
