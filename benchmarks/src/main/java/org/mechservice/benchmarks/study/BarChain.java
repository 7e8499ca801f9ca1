package org.mechservice.benchmarks.study;

import java.util.Locale;

/**
 * A hanging chain of bars of 1 m on hinges about one axis, as MechML.
 *
 * @param bars how many
 * @param firstMass of the bar at the root, kg
 * @param massRatio of the last bar to the first; masses between grow evenly in logarithms
 * @param stiffness of every hinge, N·m/rad; its rest is at angle 0
 * @param damping of every hinge, N·m·s/rad
 * @param angle of every hinge at the start, rad; the first turns from the horizontal
 * @param end of the run, s
 */
record BarChain(
    int bars,
    double firstMass,
    double massRatio,
    double stiffness,
    double damping,
    double angle,
    double end) {

  /** Returns the scene as text. */
  String text() {
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\"?>\n");
    text.append("<!DOCTYPE MechML SYSTEM \"MechML.dtd\">\n<MechML><MBSsimulation><dynamic>");
    add(text, "<timeSet tini=\"0\" tend=\"%s\" tstep=\"%s\"/>", end, end / 10);
    text.append("<integrator name=\"auto\" relTol=\"1e-6\" absTol=\"1e-8\"/></dynamic>");
    text.append("</MBSsimulation><MBSmodel name=\"chain\" massUnits=\"kg\" lengthUnits=\"m\">");
    text.append("<Bodies><body name=\"Ground\"><point name=\"p1\" x=\"0\" y=\"0\" z=\"0\"/>");
    text.append("<vector name=\"y\" vx=\"0\" vy=\"1\" vz=\"0\"/></body>\n");
    for (int i = 1; i <= bars; i++) {
      double part = bars == 1 ? 0 : (double) (i - 1) / (bars - 1);
      double mass = firstMass * Math.pow(massRatio, part);
      add(text, "<body name=\"bar%d\"><point name=\"p1\" x=\"0\" y=\"0\" z=\"0\"/>", i);
      text.append("<point name=\"p2\" x=\"1\" y=\"0\" z=\"0\"/>");
      text.append("<vector name=\"y\" vx=\"0\" vy=\"1\" vz=\"0\"/>");
      add(text, "<cog x=\"0.5\" y=\"0\" z=\"0\"/><mass value=\"%s\"/>", mass);
      add(text, "<inertiaTensor Ixx=\"0\" Iyy=\"%1$s\" Izz=\"%1$s\"/></body>\n", mass / 12);
    }
    text.append("</Bodies><Joints>\n");
    for (int i = 1; i <= bars; i++) {
      add(text, "<joint name=\"j%d\" type=\"R\"", i);
      if (stiffness > 0 || damping > 0) {
        add(text, " stiffness=\"%s\" damping=\"%s\"", stiffness, damping);
      }
      String first = i == 1 ? "Ground\" point=\"p1" : "bar" + (i - 1) + "\" point=\"p2";
      add(text, "><body1 name=\"%s\" vector=\"y\"/>", first);
      add(text, "<body2 name=\"bar%d\" point=\"p1\" vector=\"y\"/></joint>\n", i);
    }
    text.append("</Joints><Forces><gravity gx=\"0\" gy=\"0\" gz=\"-9.81\"/></Forces>");
    text.append("<topology><root name=\"Ground\"/><relCoorVals>\n");
    for (int i = 1; i <= bars; i++) {
      add(text, "<jointVal name=\"j%d\" posVals=\"%s\" velVals=\"0\"/>\n", i, angle);
    }
    return text.append("</relCoorVals></topology></MBSmodel></MechML>\n").toString();
  }

  private static void add(StringBuilder text, String pattern, Object... values) {
    text.append(String.format(Locale.ROOT, pattern, values));
  }
}
