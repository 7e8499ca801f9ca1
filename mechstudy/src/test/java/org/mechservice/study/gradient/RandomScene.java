package org.mechservice.study.gradient;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.study.Reduction;

/**
 * A random model with parameters and results to differentiate: of five seeds one is a smooth tree,
 * one has dry friction, one an impact, one a contact with a stop that pushes by a step, and one is
 * a four-bar whose loop is closed at the start.
 *
 * @param kind in words
 * @param model with tolerances near those of the arithmetic
 * @param by parameters, and a start value if there is no loop
 * @param results reductions
 */
record RandomScene(String kind, MechModel model, List<String> by, List<Reduction> results) {
  private static final String[] KINDS = {"smooth tree", "dry friction", "impact", "stop", "loop"};
  private static final double RELATIVE = 1e-12;
  private static final double ABSOLUTE = 1e-13;

  static RandomScene of(long seed) throws MechmlException {
    Random random = new Random(seed);
    String kind = KINDS[(int) (seed % KINDS.length)];
    boolean isLoop = kind.equals("loop");
    int joints = isLoop ? 3 : 1 + random.nextInt(4);
    List<String> by = new ArrayList<>();
    StringBuilder parameters = new StringBuilder();
    StringBuilder bodies = new StringBuilder("<body name='ground'/>");
    StringBuilder pairs = new StringBuilder();
    StringBuilder forces = new StringBuilder();
    StringBuilder start = new StringBuilder();
    StringBuilder event = new StringBuilder();
    double[] at = {0, 0, 0};
    for (int j = 1; j <= joints; j++) {
      double[] next = isLoop ? fourBar(random, j) : moved(random, at);
      bodies.append(
          text(
              "<body name='b%d'><cylinder from='%s' to='%s' radius='0.03' density='2000'/></body>",
              j, place(at), place(next)));
      boolean slides = !isLoop && random.nextInt(4) == 0;
      String parent = j == 1 ? "ground" : "b" + (j - 1);
      pairs.append(joint("j" + j, slides ? "P" : "R", parent, "b" + j, at, axis(random, isLoop)));
      String expression =
          text(
              "g%1$d*sin(%2$.4f*t+%3$.4f)-k%1$d*j%1$d.q*(1+0.3*j%1$d.q^2)-d%1$d*j%1$d.v",
              j, 2 + 4 * random.nextDouble(), 3 * random.nextDouble());
      for (String name : List.of("k", "d", "g")) {
        double size = name.equals("d") ? 0.5 : 5;
        parameters.append(parameter(name + j, size * (0.5 + random.nextDouble())));
        by.add(name + j);
      }
      if (j == 1) {
        double velocity = 1 + random.nextDouble();
        start.append(text("<jointVal name='j1' posVals='0' velVals='%.4f'/>", velocity));
        switch (kind) {
          case "dry friction" -> {
            parameters.append(parameter("f", 0.2 + 0.2 * random.nextDouble()));
            by.add("f");
            expression += "-f*signum(j1.v)";
          }
          case "impact" -> {
            parameters.append(parameter("e", 0.4 + 0.4 * random.nextDouble()));
            by.add("e");
            event.append(
                "<event name='hit' expression='j1.q-0.1' direction='rising' action='set'><set"
                    + " name='j1' velVals='-e*j1.v'/></event>");
          }
          case "stop" -> {
            parameters.append(parameter("s", 200 * (1 + random.nextDouble())));
            by.add("s");
            expression += "-(0.2+s*(j1.q-0.08))*step(j1.q-0.08)";
          }
          default -> {}
        }
      }
      forces.append(text("<jointForce name='f%d' joint='j%d' expression='%s'/>", j, j, expression));
      at = next;
    }
    if (isLoop) {
      double[] axis = {0, 1, 0};
      pairs.append(joint("close", "R", "ground", "b3", new double[] {0.3, 0, 0}, axis));
    } else {
      by.add("j1.v");
    }
    String model =
        text(
            "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.6' tstep='0.1'/>%s</dynamic>"
                + "</MBSsimulation><MBSmodel name='Random' massUnits='kg' lengthUnits='m'>"
                + "<Parameters>%s</Parameters><Bodies>%s</Bodies><Joints>%s</Joints><Forces>%s"
                + "<gravity gx='0' gy='0' gz='-9.81'/></Forces><topology><root name='ground'/>"
                + "<relCoorVals>%s</relCoorVals></topology></MBSmodel></MechML>",
            event, parameters, bodies, pairs, forces, start);
    List<Reduction> results =
        List.of(
            Reduction.parse("last(j" + joints + ".q)"),
            Reduction.parse("rms(j1.v)"),
            Reduction.parse("at(energy.kinetic,0.37)"));
    MechModel read = MechModel.of("random" + seed + ".xml", model).integrator("ode113");
    return new RandomScene(kind, read.tolerances(RELATIVE, ABSOLUTE), by, results);
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }

  private static String parameter(String name, double value) {
    return text("<parameter name='%s' value='%.6f' tunable='true'/>", name, value);
  }

  private static String joint(
      String name, String type, String first, String second, double[] at, double[] axis) {
    return text(
        "<joint name='%s' type='%s' body1='%s' body2='%s' at='%s' axis='%s'/>",
        name, type, first, second, place(at), place(axis));
  }

  private static String place(double[] x) {
    return text("%.5f;%.5f;%.5f", x[0], x[1], x[2]);
  }

  private static double[] moved(Random random, double[] at) {
    double[] next = at.clone();
    for (int i = 0; i < next.length; i++) {
      next[i] += 0.1 + 0.2 * random.nextDouble();
    }
    return next;
  }

  private static double[] axis(Random random, boolean isLoop) {
    double[] axis = {0, 1, 0};
    for (int i = 0; i < axis.length && !isLoop; i++) {
      axis[i] += random.nextDouble();
    }
    return axis;
  }

  /** Returns the far end of crank, coupler and rocker. */
  private static double[] fourBar(Random random, int link) {
    double off = 0.02 * random.nextDouble();
    return switch (link) {
      case 1 -> new double[] {0.01 + off, 0, 0.1};
      case 2 -> new double[] {0.3 + off, 0, 0.25};
      default -> new double[] {0.3, 0, 0};
    };
  }
}
