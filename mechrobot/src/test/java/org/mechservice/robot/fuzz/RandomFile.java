package org.mechservice.robot.fuzz;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Draws files that obey the grammar: every element and attribute of the DTD occurs, with values
 * that are right in some files and now and then of the wrong kind in others. Three bodies hang on
 * Ground in a random tree, so that many of the files are models.
 */
final class RandomFile {
  private static final Pattern ELEMENT = Pattern.compile("<!ELEMENT (\\w+)\\s+([^>]+)>");
  private static final Pattern LIST = Pattern.compile("<!ATTLIST (\\w+)([^>]*)>");
  private static final Pattern ATTRIBUTE =
      Pattern.compile("(\\w+)\\s+(CDATA|\\([^)]*\\))\\s+#(REQUIRED|IMPLIED)");
  private static final Pattern TOKEN = Pattern.compile("\\w+|[(),|?*+]");

  private static final List<String> BODIES = List.of("Ground", "a", "b", "c");
  private static final List<String> JOINTS = List.of("j0", "j1", "j2", "j3");
  private static final List<String> PLACES = List.of("p", "q");
  private static final List<String> DIRECTIONS = List.of("u", "v", "w");
  private static final List<String> PLAIN = List.of("1", "2", "0.5", "PI/6", "sqrt(2)", "3e-2");
  private static final List<String> NUMBERS =
      List.of(
          "0",
          "1",
          "-1",
          "0.5",
          "2",
          "1e3",
          "1e-3",
          "PI/6",
          "k",
          "2*k",
          "sqrt(2)",
          "-.5",
          "1;2",
          "1;0;0;0",
          "1;0;0;0;0;0;1",
          "0;0;0;1;0;0",
          "1;1;1;1;1;1",
          "-3",
          "1e9",
          "1/3");
  private static final List<String> CALM_FORMULAS = List.of("1", "sin(2*t)", "exp(-t)");
  private static final List<String> FORMULAS =
      List.of(
          "1",
          "t",
          "sin(2*t)",
          "j0.q",
          "j1.v",
          "j0.q[1]",
          "a.p.x",
          "b.q.vz",
          "k*t",
          "j0.q - 0.1*j1.q",
          "tune*j2.q",
          "0.1*sin(s)",
          "step(t-1)",
          "exp(-t)*j3.q",
          "1/(1+t^2)",
          "j0.q;t",
          "atan2(t,1)");
  private static final List<String> UNITS =
      List.of(
          "m", "mm", "rad", "deg", "kg", "N", "N/m", "N*mm/rad", "m/s", "s", "kg*m^2", "1", "x");

  /** Elements that seldom stand several times. */
  private static final List<String> FEW =
      List.of("Joints", "jointVal", "vector", "point", "profile");

  /** Elements that a file without a folder can hardly have right. */
  private static final List<String> SELDOM =
      List.of("inipos", "include", "included", "table", "map", "boxContact", "tyre");

  /** Attributes that hold formulas. */
  private static final List<String> OF_STATE =
      List.of("expression", "driven", "height", "fx", "fy", "fz", "tx", "ty", "tz");

  private record Attribute(String name, List<String> choices, boolean required) {}

  private final Map<String, List<String>> models = new HashMap<>();
  private final Map<String, List<Attribute>> attributes = new LinkedHashMap<>();
  private final Random random;
  private int names;
  private boolean inModel;

  /** How many of a hundred choices are wild in this file. */
  private int wildness;

  RandomFile(Path dtd, Random random) throws IOException {
    this.random = random;
    String text = Files.readString(dtd).replaceAll("(?s)<!--.*?-->", "");
    Matcher entity = Pattern.compile("<!ENTITY % (\\w+) \"([^\"]*)\">").matcher(text);
    List<MatchResult> entities = entity.results().toList();
    // an entity may name those before it
    for (int i = entities.size() - 1; i >= 0; i--) {
      text = text.replace("%" + entities.get(i).group(1) + ";", entities.get(i).group(2));
    }
    for (MatchResult e : ELEMENT.matcher(text).results().toList()) {
      models.put(e.group(1), TOKEN.matcher(e.group(2)).results().map(MatchResult::group).toList());
    }
    for (MatchResult list : LIST.matcher(text).results().toList()) {
      List<Attribute> own = new ArrayList<>();
      for (MatchResult a : ATTRIBUTE.matcher(list.group(2)).results().toList()) {
        boolean free = a.group(2).equals("CDATA");
        List<String> choices =
            free ? List.of() : List.of(a.group(2).replaceAll("[()\\s]", "").split("\\|", -1));
        own.add(new Attribute(a.group(1), choices, a.group(3).equals("REQUIRED")));
      }
      attributes.put(list.group(1), own);
    }
  }

  /** Draws a file. */
  String next() {
    names = 0;
    inModel = false;
    wildness = one(List.of(0, 0, 1, 5, 30));
    StringBuilder text = new StringBuilder();
    element(text, "MechML");
    return text.toString();
  }

  private void element(StringBuilder text, String name) {
    if (name.equals("Bodies")) {
      bodies(text);
    } else if (name.equals("Joints")) {
      joints(text);
    } else {
      inModel |= name.equals("MBSmodel");
      text.append('<').append(name);
      attributes.getOrDefault(name, List.of()).forEach(a -> attribute(text, name, a));
      List<String> model = models.getOrDefault(name, List.of());
      if (model.stream().anyMatch(token -> token.equals("EMPTY") || token.endsWith("PCDATA"))) {
        text.append("/>");
      } else {
        text.append(">\n");
        group(text, model, new int[] {0}, true);
        if (name.equals("Parameters")) {
          text.append(
              "<parameter name='k' value='3'/><parameter name='tune' value='2' tunable='true'/>");
        }
        text.append("</").append(name).append(">\n");
      }
    }
  }

  /** Writes a bracketed group of a content model, or skips it. */
  private void group(StringBuilder text, List<String> model, int[] at, boolean write) {
    at[0]++;
    int open = at[0];
    int parts = 1 + separators(model, open, "|");
    boolean choice = parts > 1;
    int chosen = random.nextInt(parts);
    int part = 0;
    while (!model.get(at[0]).equals(")")) {
      String token = model.get(at[0]);
      if (token.equals(",") || token.equals("|")) {
        part++;
        at[0]++;
      } else {
        item(text, model, at, write && (!choice || part == chosen));
      }
    }
    at[0]++;
  }

  private void item(StringBuilder text, List<String> model, int[] at, boolean write) {
    int start = at[0];
    skip(model, at);
    String mark = at[0] < model.size() ? model.get(at[0]) : "";
    int count =
        switch (mark) {
          case "?" -> random.nextInt(2);
          case "*" -> random.nextInt(4);
          case "+" -> 1 + random.nextInt(2);
          default -> 1;
        };
    // Simulations and the sums of couplings are few, starts are not repeated.
    if (!mark.isEmpty() && !isWild()) {
      String name = model.get(start);
      count = SELDOM.contains(name) ? 0 : FEW.contains(name) ? 1 : count;
    }
    for (int k = 0; k < count && write; k++) {
      int[] again = {start};
      if (model.get(start).equals("(")) {
        group(text, model, again, true);
      } else {
        element(text, model.get(start));
      }
    }
    if ("?*+".contains(mark) && !mark.isEmpty()) {
      at[0]++;
    }
  }

  private static void skip(List<String> model, int[] at) {
    int depth = 0;
    do {
      depth += model.get(at[0]).equals("(") ? 1 : model.get(at[0]).equals(")") ? -1 : 0;
      at[0]++;
    } while (depth > 0);
  }

  private static int separators(List<String> model, int from, String separator) {
    int depth = 1;
    int count = 0;
    for (int i = from; depth > 0; i++) {
      String token = model.get(i);
      depth += token.equals("(") ? 1 : token.equals(")") ? -1 : 0;
      count += depth == 1 && token.equals(separator) ? 1 : 0;
    }
    return count;
  }

  private void attribute(StringBuilder text, String element, Attribute attribute) {
    if (isWanted(element, attribute)) {
      text.append(' ').append(attribute.name()).append("=\"");
      text.append(value(element, attribute)).append('"');
    }
  }

  private boolean isWanted(String element, Attribute attribute) {
    if (isWild()) {
      return random.nextBoolean();
    }
    String name = attribute.name();
    return switch (element) {
      case "output" -> name.equals("columns") != inModel && !name.equals("unit");
      case "event", "inertiaTensor", "integrator", "contact", "JointConstraint" ->
          attribute.required();
      case "sphereContact" -> attribute.required() || name.equals("radius1");
      case "discContact" -> attribute.required();
      case "CoordConstraint" -> name.equals("name") || name.equals("expression");
      case "body1" -> true;
      case "body2" -> attribute.required();
      default ->
          attribute.required()
              || (!name.toLowerCase(Locale.ROOT).endsWith("unit") && random.nextInt(4) == 0);
    };
  }

  private String value(String element, Attribute attribute) {
    String name = attribute.name();
    if (!attribute.choices().isEmpty()) {
      return one(attribute.choices());
    } else if (element.equals("integrator") && name.equals("name")) {
      return one(List.of("DE", "ode113", "ode15sR", "auto"));
    } else if (name.equals("name")) {
      return nameIn(element);
    } else if (name.equals("joint")) {
      return one(isWild() ? JOINTS : List.of("j0", "j1"));
    } else if (name.equals("body")) {
      return one(BODIES);
    } else if (name.equals("point")) {
      return one(PLACES);
    } else if (name.startsWith("vector")) {
      return isWild() ? one(DIRECTIONS) : name.equals("vector") ? "u" : "v";
    } else if (name.equals("fileName")) {
      return one(List.of("A.class", "x.y.Z.class", "java.lang.Runtime.class", "../x.class"));
    } else if (name.equals("unit") || name.endsWith("Unit")) {
      return one(UNITS);
    } else if (name.equals("component")) {
      return isWild() ? "7" : "0";
    } else if (element.equals("timeSet")) {
      return name.equals("tini") ? "0" : name.equals("tend") ? "2" : "0.1";
    } else if (element.equals("integrator")) {
      return "1e-6";
    } else if (element.equals("output") && name.equals("columns")) {
      return one(List.of("all", "joints; energy", "joints"));
    }
    if (OF_STATE.contains(name)) {
      return one(isWild() ? FORMULAS : CALM_FORMULAS);
    }
    return one(isWild() ? NUMBERS : PLAIN);
  }

  private String nameIn(String element) {
    return switch (element) {
      case "body1" -> one(isWild() ? BODIES : List.of("Ground", "a"));
      case "body2" -> one(isWild() ? BODIES : List.of("b", "c"));
      case "root" -> "Ground";
      case "jointVal", "set" -> one(JOINTS);
      case "point" -> one(PLACES);
      case "vector" -> one(DIRECTIONS);
      default -> element + names++;
    };
  }

  private void bodies(StringBuilder text) {
    text.append("<Bodies>\n");
    for (String body : BODIES) {
      text.append("<body name='").append(body).append("'>");
      for (String point : PLACES) {
        text.append(
            "<point name='%s' x='%s' y='0.5' z='%s'/>".formatted(point, number(), number()));
      }
      text.append("<vector name='u' vx='1' vy='0' vz='0'/><vector name='v' vx='0' vy='1' vz='0'/>");
      text.append("<vector name='w' vx='1' vy='%s' vz='1'/>".formatted(number()));
      if (!isWild()) {
        text.append("<mass value='1'/><inertiaTensor Ixx='1' Iyy='1' Izz='1.5'/>");
        text.append("</body>\n");
        continue;
      }
      for (String part : List.of("cog", "mass", "inertiaTensor")) {
        if (random.nextInt(3) > 0) {
          element(text, part);
        }
      }
      text.append("</body>\n");
    }
    text.append("</Bodies>\n");
  }

  private void joints(StringBuilder text) {
    text.append("<Joints>\n");
    for (int i = 0; i < JOINTS.size(); i++) {
      List<String> types =
          i < 2 ? List.of("R", "P", "H") : List.of("R", "P", "C", "U", "S", "PL", "H", "W");
      String type = one(isWild() ? List.of("F", "W", "S") : types);
      text.append("<joint name='%s' type='%s'".formatted(JOINTS.get(i), type));
      text.append(type.equals("H") ? " pitch='0.1'" : "");
      attributes.getOrDefault("joint", List.of()).stream()
          .filter(a -> !List.of("name", "type", "pitch").contains(a.name()))
          .filter(a -> isWild())
          .forEach(a -> attribute(text, "joint", a));
      // The first three make a tree; the last closes a loop.
      String inner = BODIES.get(i < 3 ? random.nextInt(i + 1) : random.nextInt(3));
      text.append('>');
      boolean vectors = !List.of("S", "F").contains(type) != isWild();
      String second = type.equals("PL") ? " vector2='v'" : "";
      end(text, "body1", inner, vectors ? " vector='u'" + second : "");
      end(text, "body2", BODIES.get(Math.min(i + 1, 3)), vectors(vectors, type));
      text.append("</joint>\n");
    }
    text.append("</Joints>\n");
  }

  private String vectors(boolean wanted, String type) {
    String axis = type.equals("U") ? "v" : isWild() ? "w" : "u";
    return wanted ? " vector='" + axis + "'" : "";
  }

  private static void end(StringBuilder text, String element, String body, String vectors) {
    text.append("<%s name='%s' point='p'%s/>".formatted(element, body, vectors));
  }

  private String number() {
    return isWild() ? one(NUMBERS) : Double.toString(random.nextInt(21) / 10.0 - 1);
  }

  private boolean isWild() {
    return random.nextInt(100) < wildness;
  }

  private <T> T one(List<T> of) {
    return of.get(random.nextInt(of.size()));
  }
}
