package org.mechservice.mechml.document;

/**
 * An attribute as the XML parser hands it on: line breaks have become blanks, references their
 * text.
 *
 * @param name name
 * @param value text
 */
public record Attribute(String name, String value) {}
