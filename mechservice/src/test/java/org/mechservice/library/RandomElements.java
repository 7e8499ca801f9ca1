package org.mechservice.library;

import java.util.Locale;
import java.util.Random;

/**
 * Random models with an element of every later kind: states, a filter, a controller, a sampled one,
 * an input, tables, a map, a driven ball, gravity over time, couplings with backlash, an elastic
 * rope over a pulley, contacts with friction that sticks, a tyre; closed ones with a coupling, a
 * rolling wheel and a rope of fixed length as well.
 *
 * <pre>
 *   Ground --- hoist (P along z) --- load            hangs on the rope
 *          --- b1 (R) --- b2 (R or P) --- ...        two to four bodies, the last above the ground
 *          --- cart (P along x) --- wheel (R about y)
 *          --- head (S, driven) --- arm (R about y)
 *          --- left, right (P along z)             closed ones: on one rope over a drum
 * </pre>
 */
final class RandomElements {
  private final Random random;
  private final boolean closed;
  private final int bodies;

  RandomElements(long seed, boolean closed) {
    random = new Random(seed);
    this.closed = closed;
    bodies = 2 + random.nextInt(3);
  }

  private String number(double low, double high) {
    return String.format(Locale.ROOT, "%.4f", low + (high - low) * random.nextDouble());
  }

  /** Returns the model as text. */
  String text() {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.15' tstep='0.05'/>"
        + "<integrator name='ode113' relTol='1e-10' absTol='1e-11'/></dynamic></MBSsimulation>"
        + "<MBSmodel name='m' massUnits='kg' lengthUnits='m'><Tables><table name='pulse'"
        + " method='akima' x='0; 0.05; 0.1; 0.2' y='0; "
        + number(1, 3)
        + "; 1; 0'/><map name='drag' method='akima' x='-8; -2; 2; 8' y='-1; 0; 1' z='"
        + number(4, 6)
        + "; 5; 6; 1; 1.2; 2; -1; -1.5; -2; -4; -5; -7'/></Tables><Bodies>"
        + bodyTexts()
        + "</Bodies><Joints>"
        + joints()
        + "</Joints>"
        + constraints()
        + states()
        + forces()
        + "<topology><root name='Ground'/><relCoorVals>"
        + starts()
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static final String AXES =
      "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector"
          + " name='z' vx='0' vy='0' vz='1'/><point name='o' x='0' y='0' z='0'/>";

  private String bodyTexts() {
    StringBuilder text = new StringBuilder("<body name='Ground'>" + AXES);
    text.append("<point name='eye' x='-2' y='0' z='0'/><point name='head' x='0.1' y='0' z='2'/>")
        .append("<point name='before' x='4.8' y='0' z='-1'/><point name='behind' x='5.2' y='0'")
        .append(" z='-1'/><point name='drum' x='5' y='0' z='0'/>")
        .append("<point name='side' x='0.3' y='0' z='-1'/><point name='floor' x='0' y='0' z='")
        .append(closed ? "-0.3" : "-0.2999")
        .append("'/></body>")
        .append(solid("load", "2"));
    for (int i = 1; i <= bodies; i++) {
      text.append(solid("b" + i, number(0.5, 2)));
    }
    text.append(solid("cart", number(2, 4))).append(solid("wheel", "1.5"));
    text.append(solid("head", "1")).append(solid("arm", number(0.5, 1)));
    if (closed) {
      text.append(solid("left", number(1, 2))).append(solid("right", "1.2"));
    }
    return text.toString();
  }

  private String solid(String name, String mass) {
    return "<body name='"
        + name
        + "'>"
        + AXES
        + "<point name='end' x='"
        + number(0.2, 0.4)
        + "' y='0' z='0'/><cog x='0' y='0' z='0'/><mass value='"
        + mass
        + "'/><inertiaTensor Ixx='0.05' Iyy='0.06' Izz='0.07'/></body>";
  }

  private static String joint(
      String name, String type, String body1, String point, String body2, String axis) {
    return "<joint name='"
        + name
        + "' type='"
        + type
        + "'><body1 name='"
        + body1
        + "' point='"
        + point
        + "' vector='"
        + axis
        + "'/><body2 name='"
        + body2
        + "' point='o' vector='"
        + axis
        + "'/></joint>";
  }

  private String joints() {
    StringBuilder text = new StringBuilder(joint("hoist", "P", "Ground", "side", "load", "z"));
    for (int i = 1; i <= bodies; i++) {
      String type = i > 1 && random.nextInt(3) == 0 ? "P" : "R";
      String axis = random.nextInt(3) == 0 ? "z" : "y";
      text.append(
          joint(
              "j" + i,
              type,
              i == 1 ? "Ground" : "b" + (i - 1),
              i == 1 ? "head" : "end",
              "b" + i,
              axis));
    }
    text.append(joint("slide", "P", "Ground", "o", "cart", "x"))
        .append(joint("axle", "R", "cart", "o", "wheel", "y"))
        .append("<joint name='neck' type='S'><body1 name='Ground' point='head'/><body2 name='head'")
        .append(" point='o'/></joint>")
        .append(joint("elbow", "R", "head", "end", "arm", "y"));
    if (closed) {
      text.append(joint("up", "P", "Ground", "before", "left", "z"))
          .append(joint("down", "P", "Ground", "behind", "right", "z"));
    }
    return text.toString();
  }

  private String constraints() {
    return closed
        ? "<Constraints><CoordConstraint name='gear' constant='0'><term joint='j1' factor='1'/><term"
            + " joint='j2' factor='-0.3'/></CoordConstraint><Rolling name='rolls' radius='0.3'>"
            + "<body1 name='Ground' point='floor' vector='z'/><body2 name='wheel' point='o'"
            + " vector='y'/></Rolling><Rope name='tackle' length='2 + 0.2*PI'><plane name='Ground'"
            + " point='o' vector='y'/><via name='left' point='o'/><pulley name='Ground'"
            + " point='drum' radius='0.2' side='left'/><via name='right' point='o'/></Rope>"
            + "</Constraints>"
        : "";
  }

  private String states() {
    return "<States><state name='lag' derivative='("
        + number(2, 5)
        + "*j1.v - lag)/0.03' x0='0.1'/><transferFunction name='filter' input='j2.q' num='1; "
        + number(5, 20)
        + "' den='0.01; 1; 20'/><pid name='servo' setpoint='0.2' measured='j1.q' kp='"
        + number(3, 8)
        + "' ki='4' kd='0.3' filter='0.02'/><pid name='sampled' setpoint='0.1' measured='hoist.q'"
        + " kp='30' ki='10' kd='1' filter='0.02' period='0.04'/><sampled name='held' period='0.03'"
        + " value='slide.v'/><input name='push' x0='"
        + number(-2, 2)
        + "'/></States>";
  }

  private String forces() {
    return "<Forces><jointForce name='f1' joint='j1' expression='servo - lag + 0.1*filter'/>"
        + "<jointForce name='f2' joint='slide' expression='push + pulse(t) - 0.5*held -"
        + " 0.2*slide.v*abs(slide.v)'/><jointForce name='f4' joint='elbow'"
        + " expression='drag(elbow.v, sin(elbow.q))'/><jointForce name='f3' joint='hoist' expression='sampled'/>"
        + "<couplingSpringDamper name='mesh' k='"
        + number(50, 200)
        + "' c='0.5' backlash='0.02' smoothing='1e-3'><term joint='j1' factor='0.1'/><term"
        + " joint='axle' factor='0.2'/></couplingSpringDamper><couplingSpringDamper name='twist'"
        + " quantity='angle' expression='j1.q - hypot(0.3 + b2.o.x, b2.o.z)' k='5' c='0.1'/>"
        + "<elasticRope name='rope' k='2000' c='10' length0='3.2' smoothing='1e-4'><plane"
        + " name='Ground' point='o' vector='y'/><via name='Ground' point='eye'/><pulley"
        + " name='Ground' point='o' radius='0.3' side='left'/><via name='load' point='o'/>"
        + "</elasticRope><springDamper name='spring' k='40' c='1' length0='1.5'><body1 name='cart'"
        + " point='o'/><body2 name='b"
        + bodies
        + "' point='end'/></springDamper><sphereContact name='touch' radius1='0.2' radius2='0.2'"
        + " stiffness='2000' damping='5' smoothing='0.002' friction='0.4' stickLength='0.002'>"
        + "<body1 name='cart' point='o'/><body2 name='load' point='o'/></sphereContact>"
        + (closed ? "" : tyre())
        + "<gravity gx='0.5*sin(20*t)' gy='0' gz='-9.81'/></Forces>";
  }

  private String tyre() {
    return "<tyre name='tyre' radius='0.3' stiffness='30000' damping='100' load='40' longitudinal='"
        + number(1000, 1400)
        + "; 0.1; 45; 0.4; 42' lateral='700; 0.15; 40; 0.5; 38'><body1 name='Ground' point='floor'"
        + " vector='z'/><body2 name='wheel' point='o' vector='y'/></tyre>";
  }

  private String starts() {
    double first = 0.4 * (random.nextDouble() - 0.5);
    double rate = random.nextDouble() - 0.5;
    double speed = 1 + random.nextDouble();
    return start("j1", first, rate)
        + start("j2", closed ? first / 0.3 : first, closed ? rate / 0.3 : 0)
        + start("slide", 0, speed)
        + start("axle", 0, speed / 0.3)
        + start("elbow", 0.3, rate)
        + "<jointVal name='neck' driven='2*t; 0.6; 5*t' rotation='zxz'/>";
  }

  private static String start(String joint, double position, double velocity) {
    return "<jointVal name='" + joint + "' posVals='" + position + "' velVals='" + velocity + "'/>";
  }
}
