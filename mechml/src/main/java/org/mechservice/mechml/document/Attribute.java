package org.mechservice.mechml.document;

/**
 * An attribute after XML parsing: line breaks have become blanks, and references have been replaced
 * by their text.
 *
 * @param name name
 * @param value text
 */
public record Attribute(String name, String value) {}
