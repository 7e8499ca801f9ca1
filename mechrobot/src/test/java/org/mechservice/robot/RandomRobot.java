package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * A robot of random joints, as URDF and as what URDF means by it: written from the format's
 * definition, with nothing of the importer's.
 *
 * <p>Joint i leads to link i + 1; link 0 is the root.
 */
final class RandomRobot {
  private static final String[] TYPES = {
    "revolute", "continuous", "prismatic", "fixed", "floating", "planar"
  };
  private static final double GRAVITY = 9.81;

  /** A joint and the link beyond it. */
  @SuppressWarnings("ArrayRecordComponent") // three numbers are nothing but themselves here
  private record Part(
      int parent,
      String type,
      double[] xyz,
      double[] rpy,
      double[] axis,
      double mass,
      double[] com,
      double[] turn,
      double[] moments) {}

  private final Random random;
  private final List<Part> parts = new ArrayList<>();

  /** Draws a robot with joints of every type. */
  RandomRobot(long seed) {
    random = new Random(seed);
    for (int i = 0; i < 2 * TYPES.length; i++) {
      String type = TYPES[i % TYPES.length];
      double[] axis = type.equals("planar") ? new double[] {0, 0, 1} : unit(three(1));
      double a = 0.02 + 0.1 * random.nextDouble();
      double[] moments = {a, 1.1 * a, 1.2 * a, 0.1 * a, -0.05 * a, 0.08 * a};
      parts.add(
          new Part(
              random.nextInt(i + 1),
              type,
              three(0.5),
              three(2),
              axis,
              0.5 + random.nextDouble(),
              three(0.3),
              three(2),
              moments));
    }
  }

  private double[] three(double size) {
    return new double[] {
      size * random.nextGaussian(), size * random.nextGaussian(), size * random.nextGaussian()
    };
  }

  /** Returns the robot in URDF. */
  String urdf() {
    StringBuilder text = new StringBuilder("<robot name=\"random\">\n  <link name=\"l0\"/>\n");
    for (int i = 0; i < parts.size(); i++) {
      Part part = parts.get(i);
      double[] m = part.moments;
      text.append(
          """
            <link name="l%d">
              <inertial>
                <origin xyz="%s" rpy="%s"/>
                <mass value="%s"/>
                <inertia ixx="%s" iyy="%s" izz="%s" ixy="%s" ixz="%s" iyz="%s"/>
              </inertial>
            </link>
            <joint name="j%d" type="%s">
              <origin xyz="%s" rpy="%s"/>
              <parent link="l%d"/>
              <child link="l%d"/>
              <axis xyz="%s"/>
              <limit lower="-1e3" upper="1e3"/>
            </joint>
          """
              .formatted(
                  i + 1,
                  words(part.com),
                  words(part.turn),
                  part.mass,
                  m[0],
                  m[1],
                  m[2],
                  m[3],
                  m[4],
                  m[5],
                  i,
                  part.type,
                  words(part.xyz),
                  words(part.rpy),
                  part.parent,
                  i + 1,
                  words(part.axis)));
    }
    return text.append("</robot>\n").toString();
  }

  private static String words(double[] xyz) {
    return String.format(Locale.ROOT, "%s %s %s", xyz[0], xyz[1], xyz[2]);
  }

  /** Draws a state: positions of all joints, then velocities. */
  double[] state() {
    List<Double> q = new ArrayList<>();
    List<Double> v = new ArrayList<>();
    for (Part part : parts) {
      switch (part.type) {
        case "fixed" -> {}
        case "floating" -> {
          double[] e = unit(new double[] {gauss(), gauss(), gauss(), gauss()});
          for (double x : e) {
            q.add(x);
          }
          draw(q, 3);
          draw(v, 6);
        }
        case "planar" -> {
          draw(q, 3);
          draw(v, 3);
        }
        default -> {
          draw(q, 1);
          draw(v, 1);
        }
      }
    }
    q.addAll(v);
    return q.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private void draw(List<Double> values, int count) {
    for (int i = 0; i < count; i++) {
      values.add(gauss());
    }
  }

  private double gauss() {
    return random.nextGaussian();
  }

  /** Returns kinetic and potential energy in a state, J. */
  double[] energy(double[] y, int positions) {
    int links = parts.size() + 1;
    double[][][] turn = new double[links][][];
    double[][] at = new double[links][];
    double[][] speed = new double[links][];
    double[][] spin = new double[links][];
    turn[0] = new double[][] {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    at[0] = new double[3];
    speed[0] = new double[3];
    spin[0] = new double[3];
    double[] energy = new double[2];
    int q = 0;
    int v = positions;
    for (int i = 0; i < parts.size(); i++) {
      Part part = parts.get(i);
      int p = part.parent;
      double[][] zero = product(turn[p], rpy(part.rpy));
      double[][] r = zero;
      double[] arm = times(turn[p], part.xyz);
      double[] slide = new double[3];
      double[] relativeSpin = new double[3];
      double[] axis = times(zero, part.axis);
      switch (part.type) {
        case "fixed" -> {}
        case "prismatic" -> {
          arm = plus(arm, axis, y[q++]);
          slide = plus(slide, axis, y[v++]);
        }
        case "floating" -> {
          double[] e = {y[q], y[q + 1], y[q + 2], y[q + 3]};
          r = product(turn[p], quaternion(e));
          arm = plus(arm, times(turn[p], new double[] {y[q + 4], y[q + 5], y[q + 6]}), 1);
          relativeSpin = times(turn[p], new double[] {y[v], y[v + 1], y[v + 2]});
          slide = times(turn[p], new double[] {y[v + 3], y[v + 4], y[v + 5]});
          q += 7;
          v += 6;
        }
        case "planar" -> {
          arm = plus(arm, times(zero, new double[] {y[q], y[q + 1], 0}), 1);
          slide = times(zero, new double[] {y[v], y[v + 1], 0});
          r = product(zero, about(part.axis, y[q + 2]));
          relativeSpin = plus(relativeSpin, axis, y[v + 2]);
          q += 3;
          v += 3;
        }
        default -> {
          r = product(zero, about(part.axis, y[q++]));
          relativeSpin = plus(relativeSpin, axis, y[v++]);
        }
      }
      turn[i + 1] = r;
      at[i + 1] = plus(at[p], arm, 1);
      spin[i + 1] = plus(spin[p], relativeSpin, 1);
      speed[i + 1] = plus(plus(speed[p], cross(spin[p], arm), 1), slide, 1);
      add(part, r, at[i + 1], speed[i + 1], spin[i + 1], energy);
    }
    return energy;
  }

  private static void add(
      Part part, double[][] r, double[] at, double[] speed, double[] spin, double[] energy) {
    double[] arm = times(r, part.com);
    double[] u = plus(speed, cross(spin, arm), 1);
    double[][] axes = product(r, rpy(part.turn));
    double[] w = new double[3];
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        w[i] += axes[k][i] * spin[k];
      }
    }
    double[] m = part.moments;
    double rotation =
        m[0] * w[0] * w[0]
            + m[1] * w[1] * w[1]
            + m[2] * w[2] * w[2]
            + 2 * (m[3] * w[0] * w[1] + m[4] * w[0] * w[2] + m[5] * w[1] * w[2]);
    energy[0] += 0.5 * (part.mass * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]) + rotation);
    energy[1] += part.mass * GRAVITY * (at[2] + arm[2]);
  }

  /** Roll about x, then pitch about y, then yaw about z, all of them fixed axes. */
  private static double[][] rpy(double[] angles) {
    double[][] yaw = about(new double[] {0, 0, 1}, angles[2]);
    double[][] pitch = about(new double[] {0, 1, 0}, angles[1]);
    return product(product(yaw, pitch), about(new double[] {1, 0, 0}, angles[0]));
  }

  /** Rodrigues' formula. */
  private static double[][] about(double[] n, double angle) {
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    double[][] r = new double[3][3];
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        r[i][k] = (1 - c) * n[i] * n[k] + (i == k ? c : 0);
      }
    }
    r[0][1] -= s * n[2];
    r[1][0] += s * n[2];
    r[0][2] += s * n[1];
    r[2][0] -= s * n[1];
    r[1][2] -= s * n[0];
    r[2][1] += s * n[0];
    return r;
  }

  private static double[][] quaternion(double[] e) {
    double angle = 2 * Math.acos(Math.max(-1, Math.min(1, e[0])));
    double sine = Math.sqrt(1 - e[0] * e[0]);
    return about(new double[] {e[1] / sine, e[2] / sine, e[3] / sine}, angle);
  }

  private static double[] unit(double[] x) {
    double sum = 0;
    for (double c : x) {
      sum += c * c;
    }
    double[] unit = x.clone();
    for (int i = 0; i < x.length; i++) {
      unit[i] /= Math.sqrt(sum);
    }
    return unit;
  }

  private static double[][] product(double[][] a, double[][] b) {
    double[][] c = new double[3][3];
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        c[i][k] = a[i][0] * b[0][k] + a[i][1] * b[1][k] + a[i][2] * b[2][k];
      }
    }
    return c;
  }

  private static double[] times(double[][] a, double[] x) {
    double[] y = new double[3];
    for (int i = 0; i < 3; i++) {
      y[i] = a[i][0] * x[0] + a[i][1] * x[1] + a[i][2] * x[2];
    }
    return y;
  }

  private static double[] plus(double[] a, double[] b, double factor) {
    return new double[] {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
  }

  private static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }
}
