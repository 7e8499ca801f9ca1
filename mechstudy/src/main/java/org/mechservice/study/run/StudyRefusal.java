package org.mechservice.study.run;

import java.util.Optional;
import org.mechservice.mechml.document.Element;

/** An element of a study cannot be used; the message says what to write. */
final class StudyRefusal extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient Optional<Element> at;

  StudyRefusal(String message) {
    super(message);
    at = Optional.empty();
  }

  /**
   * @param at an element other than the one that is read
   */
  StudyRefusal(Element at, String message) {
    super(message);
    this.at = Optional.of(at);
  }

  /** Returns the element that is wrong. */
  Element at(Element read) {
    return at.orElse(read);
  }
}
