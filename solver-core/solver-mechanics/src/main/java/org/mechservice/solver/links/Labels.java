package org.mechservice.solver.links;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;

/**
 * Turns names from a model file into distinct parts of Java identifiers: ASCII letters, digits and
 * underscores, whatever the name was.
 */
public final class Labels {
  private static final int LONGEST = 24;

  private final Set<String> given = new HashSet<>();

  /** Returns an identifier part for a name, different from all given before. */
  public String labelOf(String name) {
    String label = sanitized(name);
    String distinct = label;
    for (int i = 2; !given.add(distinct.toLowerCase(Locale.ROOT)); i++) {
      distinct = label + "_" + i;
    }
    return distinct;
  }

  /** Returns the name with everything that is not an ASCII letter or digit as an underscore. */
  public static String sanitized(String name) {
    StringBuilder label = new StringBuilder();
    int length = Math.min(name.length(), LONGEST);
    for (int i = 0; i < length; i++) {
      char c = name.charAt(i);
      boolean plain = c < 128 && Character.isLetterOrDigit(c);
      label.append(plain ? c : '_');
    }
    return label.isEmpty() ? "_" : label.toString();
  }
}
