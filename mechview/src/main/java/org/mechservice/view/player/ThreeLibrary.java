package org.mechservice.view.player;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * three.js, which draws in space, as one module.
 *
 * <p>It is published in several modules that import each other. Here each becomes a function that
 * is called at once and returns what the module exports, so that a page which must not fetch
 * anything holds them in its one script.
 */
public final class ThreeLibrary {
  private static final String FOLDER = "/org/mechservice/view/three/";

  /** An import or export of names of another module. */
  private static final Pattern FROM =
      Pattern.compile("(?s)(import|export)\\s*\\{([^}]*)\\}\\s*from\\s*[\"'][^\"']*[\"'];?");

  /** An export of names of its own. */
  private static final Pattern EXPORT = Pattern.compile("(?s)export\\s*\\{([^}]*)\\};?");

  private static final String MODULE =
      String.join(
          "\n",
          constant("THREE_CORE", "three.core.min.js", ""),
          constant("THREE", "three.module.min.js", "THREE_CORE"),
          constant("{ OrbitControls }", "OrbitControls.js", "THREE"),
          constant("{ RoomEnvironment }", "RoomEnvironment.js", "THREE"),
          "export { THREE, OrbitControls, RoomEnvironment };");

  private ThreeLibrary() {}

  /** Returns the text of an ES module that exports THREE, OrbitControls and RoomEnvironment. */
  public static String module() {
    return MODULE;
  }

  /** Returns the declaration of what a module exports. */
  private static String constant(String name, String file, String imported) {
    String text = resource(file);
    StringBuilder exports = new StringBuilder();
    Matcher from = FROM.matcher(text);
    String body =
        from.replaceAll(
            found -> {
              if (found.group(1).equals("export")) {
                names(found)
                    .forEach(one -> exports.append(one[1] + ": " + imported + "." + one[0] + ","));
                return "";
              }
              return Matcher.quoteReplacement(
                  names(found).stream()
                      .map(one -> one[0] + ": " + one[1])
                      .collect(Collectors.joining(", ", "const { ", " } = " + imported + ";")));
            });
    body =
        EXPORT
            .matcher(body)
            .replaceAll(
                found -> {
                  namesOf(found.group(1))
                      .forEach(one -> exports.append(one[1] + ": " + one[0] + ","));
                  return "";
                });
    return "const " + name + " = (() => {\n" + body + "\nreturn { " + exports + " };\n})();";
  }

  private static List<String[]> names(MatchResult found) {
    return namesOf(found.group(2));
  }

  /** Returns pairs of the name in the module that gives it and in the one that takes it. */
  private static List<String[]> namesOf(String list) {
    return Pattern.compile(",")
        .splitAsStream(list)
        .map(String::strip)
        .filter(one -> !one.isEmpty())
        .map(one -> one.split("\\s+as\\s+"))
        .map(one -> one.length == 1 ? new String[] {one[0], one[0]} : one)
        .toList();
  }

  private static String resource(String name) {
    try (InputStream in =
        Objects.requireNonNull(ThreeLibrary.class.getResourceAsStream(FOLDER + name), name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new IllegalStateException(name + " of three.js cannot be read", e);
    }
  }
}
