package org.mechservice.mechml.include;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * New names for old ones, each kind of names for itself. A name that the subsystem defines gets the
 * prefix; one that it leaves open and that is bound stands for a name of the including file; every
 * other name is one of the including file already.
 */
final class Renaming {
  /** The kinds of names. */
  enum Kind {
    BODY,
    JOINT,
    /** Parameters, states and the outputs of controllers. */
    VALUE,
    TABLE
  }

  private static final String NAME = "(?:[A-Za-z_][A-Za-z0-9_]*|'[^']+')";

  /** A number, or names joined by dots, with the bracket of a call behind them. */
  private static final Pattern WORD =
      Pattern.compile(
          "(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?|("
              + NAME
              + ")((?:\\s*\\.\\s*"
              + NAME
              + ")*)(\\s*\\()?");

  private static final Pattern PLAIN = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

  private final String prefix;
  private final Map<String, String> bound;
  private final Map<Kind, Set<String>> defined = new HashMap<>();
  private final Set<String> usedBindings = new HashSet<>();

  /**
   * Begins without names.
   *
   * @param prefix of the names that the subsystem defines
   * @param bound names of the including file by the names that stand for them
   */
  Renaming(String prefix, Map<String, String> bound) {
    this.prefix = prefix;
    this.bound = bound;
    for (Kind kind : Kind.values()) {
      defined.put(kind, new HashSet<>());
    }
  }

  /** Adds a name that the subsystem defines. */
  void define(Kind kind, String name) {
    defined.getOrDefault(kind, new HashSet<>()).add(name);
  }

  /** Returns whether the subsystem defines a name. */
  boolean defines(Kind kind, String name) {
    return defined.getOrDefault(kind, Set.of()).contains(name);
  }

  /** Returns the bound names that nothing has used. */
  Set<String> unusedBindings() {
    Set<String> unused = new HashSet<>(bound.keySet());
    unused.removeAll(usedBindings);
    return unused;
  }

  /** Returns the new name of an element that the subsystem defines. */
  String own(String name) {
    return prefix + name;
  }

  /** Returns the new name of a reference. */
  String reference(Kind kind, String name) {
    return defines(kind, name) ? own(name) : bound(name);
  }

  /** Returns what an open name stands for. */
  String bound(String name) {
    String meant = bound.get(name);
    if (meant == null) {
      return name;
    }
    usedBindings.add(name);
    return meant;
  }

  /** Returns an expression, or a list of them, with new names; what it cannot read it keeps. */
  String expression(String text) {
    Matcher word = WORD.matcher(text);
    StringBuilder renamed = new StringBuilder();
    while (word.find()) {
      String first = word.group(1);
      String replaced = word.group();
      if (first != null) {
        String dotted = String.valueOf(word.group(2));
        boolean quoted = first.startsWith("'");
        String name = quoted ? first.substring(1, first.length() - 1) : first;
        String changed = reference(kind(name, dotted, word.group(3) != null), name);
        String end = word.group(3) == null ? "" : String.valueOf(word.group(3));
        replaced = changed.equals(name) ? replaced : written(changed) + points(name, dotted) + end;
      }
      word.appendReplacement(renamed, Matcher.quoteReplacement(replaced));
    }
    return word.appendTail(renamed).toString();
  }

  /**
   * Returns the rest of {@code body.point.x}; an open point of a body of the model may be bound.
   */
  private String points(String body, String dotted) {
    if (dotted.isEmpty() || defines(Kind.BODY, body)) {
      return dotted;
    }
    String[] parts = dotted.strip().substring(1).split("\\.", -1);
    if (parts.length == 2) {
      parts[0] = bound(parts[0].strip());
    }
    return "." + String.join(".", parts);
  }

  private static String written(String name) {
    return PLAIN.matcher(name).matches() ? name : "'" + name + "'";
  }

  private Kind kind(String name, String dotted, boolean called) {
    int parts = dotted.isEmpty() ? 1 : dotted.split("\\.", -1).length;
    if (parts == 1) {
      return called ? Kind.TABLE : Kind.VALUE;
    }
    if (parts == 2) {
      return defines(Kind.JOINT, name) || !defines(Kind.VALUE, name) ? Kind.JOINT : Kind.VALUE;
    }
    return Kind.BODY;
  }
}
