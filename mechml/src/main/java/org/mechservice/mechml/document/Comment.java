package org.mechservice.mechml.document;

/**
 * A comment.
 *
 * @param text what stands between {@code <!--} and {@code -->}, line breaks as line feeds
 */
public record Comment(String text) implements Content {}
