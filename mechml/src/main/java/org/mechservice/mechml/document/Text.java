package org.mechservice.mechml.document;

/**
 * Text between tags, which only the element {@code included} has: another file, as it is.
 *
 * @param text with line feeds as line breaks
 */
public record Text(String text) implements Content {}
