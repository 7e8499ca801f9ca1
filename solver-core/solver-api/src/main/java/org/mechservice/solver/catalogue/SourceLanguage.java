package org.mechservice.solver.catalogue;

import java.util.Optional;
import java.util.stream.Stream;

/** A language in which the code of a model can be written for people and other programs. */
public enum SourceLanguage {
  /** The classes that run. */
  JAVA("java"),
  /** C99 without dependencies, with the same results to the bit. */
  C("c");

  /** The option of a request that names the language. */
  public static final String OPTION = "language";

  private final String label;

  SourceLanguage(String label) {
    this.label = label;
  }

  /** Returns its name in options. */
  public String label() {
    return label;
  }

  /** Returns the language of a name in options; empty if there is none. */
  public static Optional<SourceLanguage> of(String label) {
    return Stream.of(values()).filter(language -> language.label.equals(label)).findFirst();
  }
}
