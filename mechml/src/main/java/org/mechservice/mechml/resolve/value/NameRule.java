package org.mechservice.mechml.resolve.value;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;

/** Checks whether a name may be used. */
public final class NameRule {
  /** Longest name allowed, so that names fit into tables and plots. */
  private static final int LONGEST = 200;

  private NameRule() {}

  /** Reports the name of an element if it cannot be used. */
  public static void check(Element element, Diagnostics diagnostics) {
    unusable(element.required("name"))
        .ifPresent(
            why ->
                diagnostics.error(
                    MessageCode.UNUSABLE_NAME,
                    element.position(),
                    Phrase.of("%s: the name %s", element.role(), why)));
  }

  private static Optional<String> unusable(String name) {
    if (name.isBlank()) {
      return Optional.of("is empty");
    }
    if (!name.equals(name.strip())) {
      return Optional.of(Quoted.of(name) + " begins or ends with a blank");
    }
    if (name.length() > LONGEST) {
      return Optional.of(Quoted.of(name) + " has more than " + LONGEST + " characters");
    }
    if (name.chars().anyMatch(Character::isISOControl)) {
      return Optional.of(Quoted.of(name) + " holds a control character");
    }
    return Optional.empty();
  }
}
