package org.mechservice.mechml.document;

/**
 * Text between tags in a file of another language; a model file has none.
 *
 * @param text without white space at its ends, never empty
 */
public record Text(String text) implements Content {}
