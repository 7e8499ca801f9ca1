package org.mechservice.mechml.document;

/**
 * A comment.
 *
 * @param text the text between {@code <!--} and {@code -->}, with line feeds as line breaks
 */
public record Comment(String text) implements Content {}
