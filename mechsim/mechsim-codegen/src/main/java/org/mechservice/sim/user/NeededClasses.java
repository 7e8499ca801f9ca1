package org.mechservice.sim.user;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.guard.SolverClasses;
import org.mechservice.sim.compile.ReachableClasses;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** Follows the references of classes, starting from the forces of a model; loads nothing. */
final class NeededClasses {
  private static final String INTERFACE = UserForce.class.getPackageName().replace('.', '/') + "/";
  private static final String PRODUCT = "org/mechservice/";

  private final SortedMap<String, byte[]> given;
  private final UserCodeFindings findings;
  private final SortedMap<String, byte[]> needed = new TreeMap<>();
  private final Deque<String> open = new ArrayDeque<>();

  /**
   * @param given class files by binary name; not modified
   * @param findings receives missing classes and classes that cannot be used; modified
   */
  NeededClasses(SortedMap<String, byte[]> given, UserCodeFindings findings) {
    this.given = given;
    this.findings = findings;
  }

  /** Returns the class files that the forces need, by binary name. */
  SortedMap<String, byte[]> of(List<UserForceElement> forces) {
    for (UserForceElement force : forces) {
      String who = "force \"" + force.name() + "\" (" + force.origin() + ")";
      if (take(force.className())) {
        new ForceClassCheck(given, findings).check(force, who);
      } else {
        wanted(force, who);
      }
    }
    while (!open.isEmpty()) {
      follow(open.remove());
    }
    return needed;
  }

  private boolean take(String name) {
    byte[] bytes = given.get(name);
    if (bytes == null) {
      return false;
    }
    if (needed.putIfAbsent(name, bytes) == null) {
      open.add(name);
    }
    return true;
  }

  /** Reports that the class of a force is missing, or is in another package. */
  private void wanted(UserForceElement force, String who) {
    String name = force.className();
    String simple = name.substring(name.lastIndexOf('.') + 1);
    for (String other : given.keySet()) {
      if (other.substring(other.lastIndexOf('.') + 1).equals(simple)) {
        findings.add(
            MessageCode.USER_CLASS_FILE_UNUSABLE,
            simple,
            who
                + " is the class "
                + name
                + ", but what came is "
                + other
                + "; its package must be the one in the model");
        return;
      }
    }
    findings.missing(name, who + " is");
  }

  private void follow(String name) {
    byte[] bytes = needed.getOrDefault(name, new byte[0]);
    for (String reference : ReachableClasses.namesIn(bytes)) {
      boolean known = take(reference.replace('/', '.')) || isJava(reference);
      if (!known && reference.startsWith(PRODUCT)) {
        requireInterface(name, reference);
      } else if (!known) {
        findings.missing(reference.replace('/', '.'), name + " needs");
      }
    }
  }

  private void requireInterface(String name, String reference) {
    if (!reference.startsWith(INTERFACE) || SolverClasses.file(reference + ".class") == null) {
      findings.add(
          MessageCode.USER_CLASS_FILE_UNUSABLE,
          name,
          "this uses "
              + reference.replace('/', '.')
              + ", which is not part of the force interface; use Java and "
              + UserForce.class.getPackageName());
    }
  }

  private static boolean isJava(String reference) {
    try (InputStream file = Object.class.getModule().getResourceAsStream(reference + ".class")) {
      return file != null;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
