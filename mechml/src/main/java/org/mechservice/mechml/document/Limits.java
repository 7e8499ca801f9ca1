package org.mechservice.mechml.document;

/**
 * How large a model file may be. The bounds lie far above any model and keep the memory of one
 * reading below some 200 MB.
 */
public final class Limits {
  /** Bytes of a file; the largest the service takes. */
  public static final int BYTES = 16 * 1024 * 1024;

  /** Elements in a file. */
  public static final int ELEMENTS = 200_000;

  /** Elements around an element; the language needs 6. */
  public static final int DEPTH = 32;

  /** Characters of an attribute. */
  public static final int ATTRIBUTE_LENGTH = 100_000;

  /** References to entities of the file's own. */
  static final int ENTITY_REFERENCES = 1000;

  /** Characters of an entity's text. */
  static final int ENTITY_LENGTH = 1000;

  /** Faults against the grammar before a file is given up: each costs the parser an exception. */
  static final int INVALIDITIES = 10_000;

  /** Moving bodies of a mechanism. */
  public static final int BODIES = 10_000;

  private Limits() {}
}
