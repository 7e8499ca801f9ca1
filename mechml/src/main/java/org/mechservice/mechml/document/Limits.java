package org.mechservice.mechml.document;

/**
 * Bounds on the size of a model file. They lie far above every practical model and keep the memory
 * of one reading below about 500 MB.
 */
public final class Limits {
  /** Bytes of a file; the service has the same limit. */
  public static final int BYTES = 24 * 1024 * 1024;

  /** Elements in a file. */
  public static final int ELEMENTS = 600_000;

  /** Depth of nesting; the language needs 6. */
  public static final int DEPTH = 32;

  /** Depth of nesting in a file of another language, whose readers descend with it. */
  static final int FOREIGN_DEPTH = 1000;

  /** Characters of an attribute. */
  public static final int ATTRIBUTE_LENGTH = 100_000;

  /** References to entities that the file declares. */
  static final int ENTITY_REFERENCES = 1000;

  /** Characters of an entity's text. */
  static final int ENTITY_LENGTH = 1000;

  /** Validity errors after which reading stops: each costs the parser an exception. */
  static final int INVALIDITIES = 10_000;

  /** Moving bodies of a mechanism. */
  public static final int BODIES = 50_000;

  private Limits() {}
}
