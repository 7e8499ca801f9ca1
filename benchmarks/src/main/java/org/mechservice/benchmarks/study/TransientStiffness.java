package org.mechservice.benchmarks.study;

import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * Scenes that are stiff for a while, again and again, or only just: runs of about a millisecond.
 */
final class TransientStiffness {
  /** Bars of 1 m, 1 kg, that fall from 0.3 rad below the horizontal. */
  private static final BarChain FALLING = new BarChain(3, 1, 1, 0, 0, 0.3, 1);

  private TransientStiffness() {}

  /** Returns the scenes' texts by their names. */
  static Map<String, String> scenes() {
    Map<String, String> scenes = new TreeMap<>();
    scenes.put("chain, gripped", gripped("smoothStep((t-0.4)/0.01)*smoothStep((0.5-t)/0.01)"));
    scenes.put("chain, gripped 8 times", gripped("smoothStep(8*sin(50*t)-6)"));
    scenes.put("chain, gripped late", gripped("smoothStep((t-0.7)/0.05)"));
    scenes.put("block, dropped", block());
    scenes.put("vehicle", vehicle());
    return scenes;
  }

  /** A brake in the second hinge, 5000 N·m·s/rad where a formula is 1. */
  private static String gripped(String formula) {
    String brake =
        "<jointForce name=\"brake\" joint=\"j2\" expression=\"-5e3*" + formula + "*j2.v\"/>";
    return StudyContext.replaced(FALLING.text(), "</Forces>", brake + "</Forces>");
  }

  /** A bar with feet at both ends that falls on hard ground, tumbling, and comes to rest there. */
  private static String block() {
    StringBuilder text = new StringBuilder();
    begin(text, "block", 1);
    text.append("<body name=\"bar\"><point name=\"p1\" x=\"0\" y=\"0\" z=\"0\"/>");
    text.append("<point name=\"left\" x=\"-0.5\" y=\"0\" z=\"0\"/>");
    text.append("<point name=\"right\" x=\"0.5\" y=\"0\" z=\"0\"/>");
    text.append("<cog x=\"0\" y=\"0\" z=\"0\"/><mass value=\"1\"/>");
    text.append("<inertiaTensor Ixx=\"0.1\" Iyy=\"0.2\" Izz=\"0.3\"/></body>\n</Bodies><Joints>");
    text.append("<joint name=\"free\" type=\"F\"><body1 name=\"Ground\" point=\"p1\"/>");
    text.append("<body2 name=\"bar\" point=\"p1\"/></joint></Joints><Forces>");
    text.append("<gravity gx=\"0\" gy=\"0\" gz=\"-9.81\"/>\n");
    for (String foot : new String[] {"left", "right"}) {
      text.append("<contact name=\"").append(foot).append("\" stiffness=\"1e5\" damping=\"1e3\"");
      text.append(" smoothing=\"1e-4\" friction=\"0.3\" frictionSpeed=\"0.01\">");
      text.append("<body1 name=\"Ground\" point=\"p1\" vector=\"z\" vector2=\"x\"/>");
      text.append("<body2 name=\"bar\" point=\"").append(foot).append("\"/></contact>\n");
    }
    text.append("</Forces><topology><root name=\"Ground\"/><relCoorVals>");
    text.append("<jointVal name=\"free\" posVals=\"1;0;0;0;0;0;0.1\" velVals=\"0;0.5;0;1;0;0\"/>");
    return text.append("</relCoorVals></topology></MBSmodel></MechML>\n").toString();
  }

  /** A body of 1200 kg on four sprung wheels of 30 kg, whose tyres roll over waves at 15 m/s. */
  private static String vehicle() {
    StringBuilder text = new StringBuilder();
    begin(text, "vehicle", 2);
    text.append("<body name=\"car\"><point name=\"p1\" x=\"0\" y=\"0\" z=\"0\"/>");
    for (int i = 0; i < 4; i++) {
      String x = i < 2 ? "1.2" : "-1.2";
      String y = i % 2 == 0 ? "0.7" : "-0.7";
      add(text, "<point name=\"w%d\" x=\"%s\" y=\"%s\" z=\"0\"/>", i, x, y);
    }
    text.append("<vector name=\"z\" vx=\"0\" vy=\"0\" vz=\"1\"/><cog x=\"0\" y=\"0\" z=\"0\"/>");
    text.append(
        "<mass value=\"1200\"/><inertiaTensor Ixx=\"400\" Iyy=\"1500\" Izz=\"1700\"/></body>\n");
    for (int i = 0; i < 4; i++) {
      add(text, "<body name=\"wheel%d\"><point name=\"p1\" x=\"0\" y=\"0\" z=\"0\"/>", i);
      text.append("<vector name=\"z\" vx=\"0\" vy=\"0\" vz=\"1\"/><cog x=\"0\" y=\"0\" z=\"0\"/>");
      text.append("<mass value=\"30\"/><inertiaTensor Ixx=\"1\" Iyy=\"2\" Izz=\"1\"/></body>\n");
    }
    text.append(
        "</Bodies><Joints><joint name=\"free\" type=\"F\"><body1 name=\"Ground\" point=\"p1\"/>");
    text.append("<body2 name=\"car\" point=\"p1\"/></joint>\n");
    for (int i = 0; i < 4; i++) {
      add(text, "<joint name=\"strut%d\" type=\"P\" stiffness=\"3e4\" damping=\"2e3\"", i);
      add(text, " freePosition=\"-0.2\"><body1 name=\"car\" point=\"w%d\" vector=\"z\"/>", i);
      add(text, "<body2 name=\"wheel%d\" point=\"p1\" vector=\"z\"/></joint>\n", i);
    }
    text.append("</Joints><Forces><gravity gx=\"0\" gy=\"0\" gz=\"-9.81\"/>\n");
    for (int i = 0; i < 4; i++) {
      add(text, "<contact name=\"tyre%d\" radius=\"0.3\" stiffness=\"1e6\" damping=\"2e4\"", i);
      text.append(" smoothing=\"1e-4\" friction=\"0.8\" frictionSpeed=\"0.1\"");
      text.append(" height=\"0.02*sin(3*s)\">");
      text.append("<body1 name=\"Ground\" point=\"p1\" vector=\"z\" vector2=\"x\"/>");
      add(text, "<body2 name=\"wheel%d\" point=\"p1\"/></contact>\n", i);
    }
    text.append("</Forces><topology><root name=\"Ground\"/><relCoorVals>");
    text.append("<jointVal name=\"free\" posVals=\"1;0;0;0;0;0;0.6\" velVals=\"0;0;0;15;0;0\"/>");
    for (int i = 0; i < 4; i++) {
      add(text, "<jointVal name=\"strut%d\" posVals=\"-0.25\"/>", i);
    }
    return text.append("</relCoorVals></topology></MBSmodel></MechML>\n").toString();
  }

  private static void begin(StringBuilder text, String name, double end) {
    text.append("<?xml version=\"1.0\"?>\n<!DOCTYPE MechML SYSTEM \"MechML.dtd\">\n");
    text.append("<MechML><MBSsimulation><dynamic>");
    add(text, "<timeSet tini=\"0\" tend=\"%s\" tstep=\"%s\"/>", end, end / 20);
    text.append("<integrator name=\"auto\" relTol=\"1e-6\" absTol=\"1e-8\"/></dynamic>");
    add(text, "</MBSsimulation><MBSmodel name=\"%s\" massUnits=\"kg\" lengthUnits=\"m\">", name);
    text.append("<Bodies><body name=\"Ground\"><point name=\"p1\" x=\"0\" y=\"0\" z=\"0\"/>");
    text.append("<vector name=\"x\" vx=\"1\" vy=\"0\" vz=\"0\"/>");
    text.append("<vector name=\"z\" vx=\"0\" vy=\"0\" vz=\"1\"/></body>\n");
  }

  private static void add(StringBuilder text, String format, Object... values) {
    text.append(String.format(Locale.ROOT, format, values));
  }
}
