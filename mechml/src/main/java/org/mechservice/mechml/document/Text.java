package org.mechservice.mechml.document;

/**
 * Text between tags: in a model file another file as it is, which only the element {@code included}
 * holds; in a file of another language any text, without white space at its ends and never empty.
 *
 * @param text with line feeds as line breaks
 */
public record Text(String text) implements Content {}
