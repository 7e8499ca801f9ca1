package org.mechservice.library.proof;

import static org.mechservice.library.proof.SceneText.ends;

import java.util.List;
import java.util.Optional;
import java.util.Random;

/**
 * Drops and hits: bodies that fly for a while, touch something for a short time and part again.
 * Each is written a second time as a {@link LineHit} or a {@link TurningHit}.
 */
final class Hits implements ProofSet {
  private enum Kind {
    BALL_ON_PLATE,
    BALL_ON_BALL,
    BALL_ON_CAPSULE,
    BALL_ON_PLANE,
    DISC_ON_PLANE,
    BOX_ON_PLANE,
    STOP_OF_A_SLIDER,
    STOP_OF_A_HINGE,
    BUFFER_AT_A_WALL,
    SLACK_ROPE,
    ELASTIC_ROPE,
    ONE_SIDED_COUPLING,
    BACKLASH,
    BALLS_COLLIDE,
    BALL_HITS_CAPSULE,
    BUFFER_BETWEEN_BODIES,
    ROPE_BETWEEN_BODIES,
    BOB_HITS_BALL,
    ROTOR_HITS_PAWL,
    ROTOR_WHIPS_MASS
  }

  @Override
  public String title() {
    return "drops and hits";
  }

  @Override
  public int size() {
    return 1000;
  }

  @Override
  public String before() {
    return "173 of 928";
  }

  @Override
  public Optional<Scene> scene(long seed) {
    Random random = new Random(7919 * seed);
    Kind kind = Kind.values()[(int) ((seed - 1) % Kind.values().length)];
    return switch (kind) {
      case BALLS_COLLIDE, BALL_HITS_CAPSULE, BUFFER_BETWEEN_BODIES, ROPE_BETWEEN_BODIES ->
          twoBodies(kind, random);
      case BOB_HITS_BALL -> bob(random);
      case ROTOR_HITS_PAWL -> pawl(random);
      case ROTOR_WHIPS_MASS -> whip(random);
      default -> oneBody(kind, random);
    };
  }

  private static String name(Kind kind) {
    return kind.name().toLowerCase(java.util.Locale.ROOT).replace('_', ' ');
  }

  /** Returns a law that lets a mass of a speed in by a depth, with or without damping. */
  private static Law law(Random random, double mass, double speed, double depth, double exponent) {
    double k =
        Spread.rounded(mass * speed * speed / 2 * (exponent + 1) / Math.pow(depth, exponent + 1));
    double ratio = random.nextInt(5) < 2 ? Spread.log(random, 0.003, 0.3) : 0;
    double c = Spread.rounded(2 * ratio * Math.sqrt(k * Math.pow(depth, exponent - 1) * mass));
    return new Law(k, exponent, c);
  }

  private static String coefficients(Law law) {
    return " stiffness='"
        + law.k()
        + "' exponent='"
        + law.n()
        + "'"
        + (law.c() == 0 ? "" : " damping='" + law.c() + "'");
  }

  private static String spring(Law law) {
    return " k='" + law.k() + "'" + (law.c() == 0 ? "" : " c='" + law.c() + "'");
  }

  /** A body that comes against something fixed, by its weight or with a speed. */
  private static Optional<Scene> oneBody(Kind kind, Random random) {
    boolean turns = kind == Kind.STOP_OF_A_HINGE;
    boolean pulls = kind == Kind.SLACK_ROPE || kind == Kind.ELASTIC_ROPE || kind == Kind.BACKLASH;
    boolean linear =
        pulls
            || turns
            || kind == Kind.STOP_OF_A_SLIDER
            || kind == Kind.BUFFER_AT_A_WALL
            || kind == Kind.ONE_SIDED_COUPLING;
    boolean straight = kind != Kind.BALL_ON_BALL && kind != Kind.BALL_ON_CAPSULE;
    double exponent = linear ? 1 : Spread.one(random, 1.0, 1.5, 2.0);
    double mass = Spread.log(random, 0.1, 10);
    double size = Spread.log(random, 0.005, 0.2);
    double more = Spread.log(random, 0.005, 0.4);
    boolean falls = !turns && random.nextBoolean();
    double speed = Spread.log(random, 0.5, falls ? 10 : 50);
    double way = falls ? Spread.rounded(speed * speed / 2 / 9.81) : Spread.log(random, 0.1, 50);
    // R, and the depth that there is before the body is through
    double radius;
    double room;
    double offset = 0;
    switch (kind) {
      case BALL_ON_PLATE -> {
        radius = size + more / 2;
        room = size + 0.4 * more;
      }
      case BALL_ON_BALL, BALL_ON_CAPSULE -> {
        radius = size + more;
        offset = Spread.rounded(radius * Spread.even(random, 0, 0.6));
        room = 0.5 * (radius - offset);
      }
      case BUFFER_AT_A_WALL -> {
        radius = size;
        room = 0.7 * size;
      }
      default -> {
        radius = size;
        room = size;
      }
    }
    double depth = room * Spread.log(random, 0.002, 0.8);
    Law law = law(random, mass, speed, depth, exponent);
    double acceleration = falls ? (pulls ? 9.81 : -9.81) : 0;
    double contact = Math.sqrt(Math.max(0, radius * radius - offset * offset));
    double start = pulls ? (kind == Kind.BACKLASH ? 0 : Math.max(0, radius - way)) : contact + way;
    if (pulls && kind != Kind.BACKLASH) {
      // ropes become as long as the way
      radius = Spread.rounded(start + way);
    }
    if (kind == Kind.BACKLASH) {
      way = radius;
    }
    double velocity = falls ? 0 : pulls ? speed : -speed;
    if (kind == Kind.BACKLASH && falls) {
      velocity = 0;
      speed = Math.sqrt(2 * 9.81 * radius);
      law = law(random, mass, speed, depth, exponent);
    }
    double touch = falls ? Math.sqrt(2 * way / 9.81) : way / speed;
    double duration = Math.PI * depth / speed;
    double back = falls ? 2 * touch : 2 * way / speed;
    double end =
        Spread.rounded(touch + duration + Spread.even(random, 0.1, 0.9) * Math.min(back, 3));
    int count = kind == Kind.BOX_ON_PLANE ? 4 : 1;
    Law whole = law;
    Law one = law.times(1.0 / count);
    double fine =
        Math.min(duration / 20, 0.2 * (straight ? depth : Math.min(depth, contact)) / speed);
    double carried = turns ? mass * 0.1 : mass;
    Law acting = turns ? whole.times(0.1) : whole;
    LineHit on =
        new LineHit(
            carried,
            Double.POSITIVE_INFINITY,
            acceleration,
            offset,
            radius,
            pulls,
            acting,
            true,
            fine);
    LineHit off =
        new LineHit(
            carried,
            Double.POSITIVE_INFINITY,
            acceleration,
            offset,
            radius,
            pulls,
            acting,
            false,
            fine);
    Method method = Method.any(random);
    double[] begin = {start, velocity};
    Optional<List<Expected>> expected =
        Ends.of(new String[] {"j.q", "j.v"}, on, off, begin, end, method);
    SceneText text =
        new SceneText()
            .body("a", mass, turns ? carried : 0.001 * mass)
            .point("Ground", "p", offset, 0, 0);
    if (acceleration != 0) {
      text.gravity("0", "0", Double.toString(acceleration));
    }
    String more1 = "";
    switch (kind) {
      case BALL_ON_PLATE ->
          text.force(
              "<sphereContact name='c' box1='1;1;"
                  + more
                  + "' radius2='"
                  + size
                  + "'"
                  + coefficients(one)
                  + ">"
                  + ends("Ground", "o", " vector='z'", "a", "o")
                  + "</sphereContact>");
      case BALL_ON_BALL, BALL_ON_CAPSULE ->
          text.force(
              "<sphereContact name='c' radius1='"
                  + more
                  + "' radius2='"
                  + size
                  + "'"
                  + (kind == Kind.BALL_ON_CAPSULE ? " length1='0.5'" : "")
                  + coefficients(one)
                  + ">"
                  + ends("Ground", "o", " vector='y'", "a", "o")
                  + "</sphereContact>");
      case BALL_ON_PLANE ->
          text.force(
              "<contact name='c' radius='"
                  + size
                  + "'"
                  + coefficients(one)
                  + ">"
                  + ends("Ground", "o", " vector='z'", "a", "o")
                  + "</contact>");
      case DISC_ON_PLANE -> {
        double edge = Spread.rounded(size / 8);
        text.force(
            "<discContact name='c' radius='"
                + (size - edge)
                + "' edge='"
                + edge
                + "'"
                + coefficients(one)
                + ">"
                + ends("Ground", "o", " vector='z'", "a", "o")
                    .replace("name='a' point='o'", "name='a' point='o' vector='y'")
                + "</discContact>");
      }
      case BOX_ON_PLANE ->
          text.force(
              "<boxContact name='c' box='0.4;0.3;"
                  + 2 * size
                  + "'"
                  + coefficients(one)
                  + ">"
                  + ends("Ground", "o", " vector='z'", "a", "o")
                  + "</boxContact>");
      case STOP_OF_A_SLIDER, STOP_OF_A_HINGE ->
          more1 =
              "lower='"
                  + radius
                  + "' stopStiffness='"
                  + acting.k()
                  + "' stopDamping='"
                  + acting.c()
                  + "'";
      case BUFFER_AT_A_WALL, SLACK_ROPE ->
          text.force(
              "<springDamper name='c' side='"
                  + (pulls ? "tension" : "compression")
                  + "' length0='"
                  + radius
                  + "'"
                  + spring(law)
                  + ">"
                  + ends("Ground", "o", "", "a", "o")
                  + "</springDamper>");
      case ELASTIC_ROPE ->
          text.force(
              "<elasticRope name='c' length0='"
                  + radius
                  + "'"
                  + spring(law)
                  + "><via name='Ground' point='o'/><via name='a' point='o'/></elasticRope>");
      case ONE_SIDED_COUPLING ->
          text.force(
              "<couplingSpringDamper name='c' side='compression' expression='j.q' rest='"
                  + radius
                  + "'"
                  + spring(law)
                  + "/>");
      default ->
          text.force(
              "<couplingSpringDamper name='c' expression='j.q' backlash='"
                  + 2 * radius
                  + "'"
                  + spring(law)
                  + "/>");
    }
    boolean away = kind == Kind.BALL_ON_BALL || kind == Kind.BALL_ON_CAPSULE;
    text.joint("j", turns ? "R" : "P", "Ground", away ? "p" : "o", "a", "z", more1);
    text.start("j", start, velocity);
    double row = Spread.rounded(end / Spread.one(random, 1, 5, 20, 100));
    return expected.map(
        list -> new Scene(name(kind), "", method, text.with(end, row, method), 5 * fine, list));
  }

  /** Two bodies on parallel lines. */
  private static Optional<Scene> twoBodies(Kind kind, Random random) {
    boolean pulls = kind == Kind.ROPE_BETWEEN_BODIES;
    boolean springs = pulls || kind == Kind.BUFFER_BETWEEN_BODIES;
    double m1 = Spread.log(random, 0.1, 10);
    double m2 = Spread.log(random, 0.1, 10);
    double speed = Spread.log(random, 0.5, 50);
    double carried = Spread.even(random, -1, 1) * Spread.one(random, 0.0, 1.0, 10.0);
    double r1 = Spread.log(random, 0.005, 0.2);
    double r2 = Spread.log(random, 0.005, 0.2);
    double radius = springs ? r1 : r1 + r2;
    double offset =
        (kind == Kind.BALLS_COLLIDE && random.nextBoolean()) || kind == Kind.BALL_HITS_CAPSULE
            ? Spread.rounded(radius * Spread.even(random, 0, 0.6))
            : 0;
    double way = Spread.log(random, 0.1, 50);
    double contact = Math.sqrt(radius * radius - offset * offset);
    double start = pulls ? 0 : -(contact + way);
    if (pulls) {
      radius = way;
    }
    double reduced = m1 * m2 / (m1 + m2);
    double room = (pulls ? 0.5 : springs ? 0.6 : 0.4) * (radius - offset);
    double depth = room * Spread.log(random, 0.002, 0.8);
    Law law = law(random, reduced, speed, depth, springs ? 1 : Spread.one(random, 1.0, 1.5, 2.0));
    double duration = Math.PI * depth / speed;
    double end =
        Spread.rounded(
            way / speed + duration + Spread.even(random, 0.1, 0.9) * Math.min(3, way / speed));
    double fine = Math.min(duration / 20, 0.2 * Math.min(depth, contact) / speed);
    LineHit on = new LineHit(m1, m2, 0, offset, radius, pulls, law, true, fine);
    LineHit off = new LineHit(m1, m2, 0, offset, radius, pulls, law, false, fine);
    Method method = Method.any(random);
    // the second stands at a place of its own, so that no body is at zero
    double place = Spread.even(random, -1, 1);
    double[] begin = {place + start, place, carried + speed, carried};
    Optional<List<Expected>> expected =
        Ends.of(new String[] {"x.q", "y.q", "x.v", "y.v"}, on, off, begin, end, method);
    SceneText text =
        new SceneText()
            .body("a", m1, 0.001 * m1)
            .body("b", m2, 0.001 * m2)
            .point("Ground", "p", 0, 0, offset)
            .joint("x", "P", "Ground", "o", "a", "x", "")
            .joint("y", "P", "Ground", "p", "b", "x", "")
            .start("x", begin[0], begin[2])
            .start("y", begin[1], begin[3]);
    if (springs) {
      text.force(
          "<springDamper name='c' side='"
              + (pulls ? "tension" : "compression")
              + "' length0='"
              + radius
              + "'"
              + spring(law)
              + ">"
              + ends("a", "o", "", "b", "o")
              + "</springDamper>");
    } else {
      text.force(
          "<sphereContact name='c' radius1='"
              + r1
              + "' radius2='"
              + r2
              + "'"
              + (kind == Kind.BALL_HITS_CAPSULE ? " length1='0.3'" : "")
              + coefficients(law)
              + ">"
              + ends("a", "o", " vector='y'", "b", "o")
              + "</sphereContact>");
    }
    double row = Spread.rounded(end / Spread.one(random, 1, 5, 20, 100));
    return expected.map(
        list -> new Scene(name(kind), "", method, text.with(end, row, method), 5 * fine, list));
  }

  /** A pendulum whose bob strikes a ball on a rail near its lowest point. */
  private static Optional<Scene> bob(Random random) {
    double arm = Spread.log(random, 0.3, 3);
    double mass = Spread.log(random, 0.1, 5);
    double ball = Spread.log(random, 0.1, 5);
    double r1 = Spread.rounded(arm * Spread.log(random, 0.01, 0.1));
    double r2 = Spread.rounded(arm * Spread.log(random, 0.01, 0.1));
    double radius = r1 + r2;
    double angle = Spread.even(random, 0.3, 2.5);
    double place = Spread.rounded(radius * Spread.even(random, 0.3, 1));
    double speed = Math.sqrt(2 * 9.81 * arm * (1 - Math.cos(angle)));
    double own = 1e-4 * mass * arm * arm;
    double inertia = mass * arm * arm + own;
    double reduced = mass * ball / (mass + ball);
    double depth = 0.3 * radius * Spread.log(random, 0.01, 0.8);
    Law law = law(random, reduced, speed, depth, Spread.one(random, 1.0, 1.5));
    double end = Spread.rounded(Spread.even(random, 2.5, 4) * Math.sqrt(arm / 9.81));
    double fine = 0.15 * depth / speed;
    TurningHit on =
        new TurningHit(
            inertia,
            mass * 9.81 * arm,
            arm,
            ball,
            arm,
            -place,
            0,
            -1,
            0,
            0,
            radius,
            false,
            law,
            true,
            fine);
    TurningHit off =
        new TurningHit(
            inertia,
            mass * 9.81 * arm,
            arm,
            ball,
            arm,
            -place,
            0,
            -1,
            0,
            0,
            radius,
            false,
            law,
            false,
            fine);
    Method method = Method.any(random);
    double[] begin = {angle, 0, 0, 0};
    Optional<List<Expected>> expected =
        Ends.of(new String[] {"h.q", "x.q", "h.v", "x.v"}, on, off, begin, end, method);
    SceneText text =
        new SceneText()
            .bob("p", mass, own, -arm)
            .body("b", ball, 1e-4)
            .point("p", "b", 0, 0, -arm)
            .point("Ground", "r", place, 0, -arm)
            .joint("h", "R", "Ground", "o", "p", "y", "")
            .joint("x", "P", "Ground", "r", "b", "x", "")
            .gravity("0", "0", "-9.81")
            .force(
                "<sphereContact name='c' radius1='"
                    + r1
                    + "' radius2='"
                    + r2
                    + "'"
                    + coefficients(law)
                    + ">"
                    + ends("p", "b", " vector='z'", "b", "o")
                    + "</sphereContact>")
            .start("h", angle, 0);
    double row = Spread.rounded(end / Spread.one(random, 1, 5, 20, 100));
    return expected.map(
        list ->
            new Scene(
                name(Kind.BOB_HITS_BALL), "", method, text.with(end, row, method), 5 * fine, list));
  }

  /** A rotor whose tooth strikes a spring-loaded weight. */
  private static Optional<Scene> pawl(Random random) {
    double arm = Spread.log(random, 0.1, 1);
    double moment = Spread.log(random, 0.01, 1);
    double weight = Spread.log(random, 0.05, 1);
    double r1 = Spread.rounded(arm * Spread.log(random, 0.02, 0.1));
    double r2 = Spread.rounded(arm * Spread.log(random, 0.02, 0.1));
    double radius = r1 + r2;
    double turning = Spread.log(random, 1, 30);
    double speed = turning * arm;
    double place = Spread.rounded(arm + radius * Spread.even(random, 0.3, 0.9));
    double start = Spread.even(random, 0.8, 2);
    double reduced = 1 / (1 / weight + arm * arm / moment);
    double depth = 0.3 * radius * Spread.log(random, 0.01, 0.8);
    Law law = law(random, reduced, speed, depth, Spread.one(random, 1.0, 1.5));
    double stiffness = Spread.rounded(weight * turning * turning * Spread.log(random, 0.3, 30));
    double damping =
        Spread.rounded(2 * Spread.even(random, 0.2, 1) * Math.sqrt(stiffness * weight));
    double end =
        Spread.rounded(
            (2 * Math.PI - start + 2 * Math.PI * random.nextInt(3) + Spread.even(random, 1, 5))
                / turning);
    double fine = 0.15 * depth / speed;
    TurningHit on =
        new TurningHit(
            moment, 0, arm, weight, place, 0, 1, 0, stiffness, damping, radius, false, law, true,
            fine);
    TurningHit off =
        new TurningHit(
            moment, 0, arm, weight, place, 0, 1, 0, stiffness, damping, radius, false, law, false,
            fine);
    Method method = Method.any(random);
    double[] begin = {start, 0, turning, 0};
    Optional<List<Expected>> expected =
        Ends.of(new String[] {"h.q", "x.q", "h.v", "x.v"}, on, off, begin, end, method);
    SceneText text =
        new SceneText()
            .body("r", 1, moment)
            .body("w", weight, 1e-4)
            .point("r", "t", arm, 0, 0)
            .point("Ground", "p", place, 0, 0)
            .joint("h", "R", "Ground", "o", "r", "z", "")
            .joint(
                "x",
                "P",
                "Ground",
                "p",
                "w",
                "x",
                "stiffness='" + stiffness + "' damping='" + damping + "'")
            .force(
                "<sphereContact name='c' radius1='"
                    + r1
                    + "' radius2='"
                    + r2
                    + "'"
                    + coefficients(law)
                    + ">"
                    + ends("r", "t", "", "w", "o")
                    + "</sphereContact>")
            .start("h", start, turning);
    double row = Spread.rounded(end / Spread.one(random, 1, 5, 20, 100));
    return expected.map(
        list ->
            new Scene(
                name(Kind.ROTOR_HITS_PAWL),
                "",
                method,
                text.with(end, row, method),
                5 * fine,
                list));
  }

  /** A rotor that pulls a slow mass by a rope, once a turn. */
  private static Optional<Scene> whip(Random random) {
    double arm = Spread.log(random, 0.02, 0.1);
    double moment = Spread.log(random, 0.1, 1);
    double mass = Spread.log(random, 1, 10);
    double turning = Spread.log(random, 20, 1000);
    double radius = Spread.rounded(arm * Spread.even(random, 1.5, 3));
    double start = Spread.rounded(radius + arm * Spread.even(random, -0.9, 0.5));
    double own = Spread.rounded(mass * Spread.log(random, 1, 30));
    double k = Spread.rounded(own * Spread.log(random, 0.3, 3));
    double c = random.nextBoolean() ? 0 : Spread.rounded(0.01 * Math.sqrt(k * mass));
    Law law = new Law(k, 1, c);
    double period = 2 * Math.PI / turning;
    double fine = period / 100;
    double slow = 2 * Math.PI / Math.sqrt((own + k) / mass);
    double end = Spread.rounded(Math.min(60 * period, Spread.even(random, 0.3, 1) * slow));
    TurningHit on =
        new TurningHit(moment, 0, arm, mass, 0, 0, 1, 0, own, 0, radius, true, law, true, fine);
    TurningHit off =
        new TurningHit(moment, 0, arm, mass, 0, 0, 1, 0, own, 0, radius, true, law, false, fine);
    Method method = Method.any(random);
    double[] begin = {0, start, turning, 0};
    Optional<List<Expected>> expected =
        Ends.of(new String[] {"", "x.q", "", "x.v"}, on, off, begin, end, method);
    SceneText text =
        new SceneText()
            .body("r", 1, moment)
            .body("w", mass, 1e-3)
            .point("r", "e", arm, 0, 0)
            .joint("h", "R", "Ground", "o", "r", "z", "")
            .joint("x", "P", "Ground", "o", "w", "x", "stiffness='" + own + "'")
            .force(
                "<springDamper name='c' side='tension' length0='"
                    + radius
                    + "'"
                    + spring(law)
                    + ">"
                    + ends("r", "e", "", "w", "o")
                    + "</springDamper>")
            .start("h", 0, turning)
            .start("x", start, 0);
    double row = Spread.rounded(end / Spread.one(random, 1, 5, 20, 100));
    return expected.map(
        list ->
            new Scene(
                name(Kind.ROTOR_WHIPS_MASS),
                "",
                method,
                text.with(end, row, method),
                5 * fine,
                list));
  }
}
