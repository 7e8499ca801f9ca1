package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.program.Trajectory;

/**
 * A belt of beads on a turning drum. Each bead turns the tension by δ = φ/n and presses with N = (T
 * + T') sin(δ/2); where it slips, (T − T') cos(δ/2) = μ N. So the tension falls by a = (cos δ/2 − μ
 * sin δ/2) / (cos δ/2 + μ sin δ/2) at each, and aⁿ goes to exp(−μ φ) (Euler 1769) with the square
 * of δ.
 */
final class BeltFrictionTest {
  private static final double FRICTION = 0.3;
  private static final double WRAP = Math.PI / 2;
  private static final double DRUM = 0.1;
  private static final double BEAD = 0.01;
  private static final double PULL = 10;

  /** Length of the free end, m: its direction stays. */
  private static final double FREE = 5;

  private static final double STIFFNESS = 1e5;

  /** Stiffness of the contacts, N/m. */
  private static final double CONTACT = 1e6;

  /** Returns a. */
  private static double fall(int beads) {
    double half = WRAP / beads / 2;
    double normal = FRICTION * Math.sin(half);
    return (Math.cos(half) - normal) / (Math.cos(half) + normal);
  }

  /** Springs and contacts have the lengths that give these forces where the beads begin. */
  private static String belt(int beads) {
    double radius = DRUM + BEAD;
    double delta = WRAP / beads;
    double last = delta * (beads - 0.5);
    double farX = radius * Math.cos(last) - FREE * Math.sin(WRAP);
    double farZ = radius * Math.sin(last) + FREE * Math.cos(WRAP);
    StringBuilder bodies =
        new StringBuilder(
            "<body name='ground'><point name='o' x='0' y='0' z='0'/><point name='far' x='"
                + farX
                + "' y='0' z='"
                + farZ
                + "'/><vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1'"
                + " vz='0'/></body><body name='drum'><point name='o' x='0' y='0' z='0'/><vector"
                + " name='y' vx='0' vy='1' vz='0'/><mass value='1'/><inertiaTensor Ixx='1' Iyy='1'"
                + " Izz='1'/></body>");
    StringBuilder joints =
        new StringBuilder(
            "<joint name='spin' type='R'><body1 name='ground' point='o' vector='y'/><body2"
                + " name='drum' point='o' vector='y'/></joint>");
    StringBuilder forces = new StringBuilder("<gravity gx='0' gy='0' gz='0'/>");
    StringBuilder starts = new StringBuilder("<jointVal name='spin' driven='-10*t'/>");
    double x = Double.NaN;
    double z = Double.NaN;
    for (int k = 1; k <= beads; k++) {
      double beforeX = x;
      double beforeZ = z;
      x = radius * Math.cos(delta * (k - 0.5));
      z = radius * Math.sin(delta * (k - 0.5));
      double tension = PULL * Math.pow(fall(beads), k);
      double pressed = (tension + tension / fall(beads)) * Math.sin(delta / 2);
      bodies.append(
          "<body name='c%d'><point name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/><vector name='z' vx='0' vy='0' vz='1'/></body><body name='b%d'><point name='o' x='0' y='0' z='0'/><vector name='z' vx='0' vy='0' vz='1'/><mass value='0.01'/></body>"
              .formatted(k, k));
      joints.append(
          "<joint name='x%1$d' type='P'><body1 name='ground' point='o' vector='x'/><body2 name='c%1$d' point='o' vector='x'/></joint><joint name='z%1$d' type='P'><body1 name='c%1$d' point='o' vector='z'/><body2 name='b%1$d' point='o' vector='z'/></joint>"
              .formatted(k));
      starts.append(
          "<jointVal name='x%1$d' posVals='%2$s'/><jointVal name='z%1$d' posVals='%3$s'/>"
              .formatted(k, x, z));
      forces.append(
          "<sphereContact name='n%d' radius1='%s' length1='1' radius2='%s' stiffness='%s' damping='100' smoothing='1e-7' friction='%s' frictionSpeed='1e-3'><body1 name='drum' point='o' vector='y'/><body2 name='b%d' point='o'/></sphereContact>"
              .formatted(k, DRUM, BEAD + pressed / CONTACT, CONTACT, FRICTION, k));
      if (k == 1) {
        forces.append(
            "<forceTorque name='pull' body='b1' point='o' frame='world' fz='%s'/>"
                .formatted(-PULL));
      } else {
        double length = Math.hypot(x - beforeX, z - beforeZ);
        double before = tension / fall(beads);
        forces.append(link("t" + (k - 1), "b" + (k - 1), length - before / STIFFNESS));
        forces.append("<body2 name='b%d' point='o'/></springDamper>".formatted(k));
      }
    }
    double end = PULL * Math.pow(fall(beads), beads);
    forces.append(link("end", "b" + beads, FREE - end / STIFFNESS));
    forces.append("<body2 name='ground' point='far'/></springDamper>");
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='1'/><integrator"
        + " name='ode15s' relTol='1e-8' absTol='1e-11'/><output"
        + " columns='forces'/></dynamic></MBSsimulation><MBSmodel name='belt' massUnits='kg'"
        + " lengthUnits='m'><Bodies>"
        + bodies
        + "</Bodies><Joints>"
        + joints
        + "</Joints><Forces>"
        + forces
        + "</Forces><topology><root name='ground'/><relCoorVals>"
        + starts
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static String link(String name, String from, double length) {
    return "<springDamper name='%s' k='%s' c='20' length0='%s'><body1 name='%s' point='o'/>"
        .formatted(name, STIFFNESS, length, from);
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 6, 12})
  void tensionFallsAsEulerSays(int beads) throws Exception {
    Trajectory run = MechModel.of("belt.xml", belt(beads)).simulate();
    double[] tension = run.column("end.tension");
    double left = tension[tension.length - 1] / PULL;
    double half = WRAP / beads / 2;
    // friction is short of Coulomb's by (frictionSpeed / slip)² / 2 = 5e-7
    assertThat(left).isCloseTo(Math.pow(fall(beads), beads), within(1e-6));
    // the first term of what beads are off by: μ φ δ² (1 + μ²) / 12 of the whole
    double off = FRICTION * WRAP * 4 * half * half * (1 + FRICTION * FRICTION) / 12;
    double euler = Math.exp(-FRICTION * WRAP);
    assertThat(1 - left / euler).isCloseTo(off, within(0.2 * off));
  }
}
