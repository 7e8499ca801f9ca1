package org.mechservice.sim.model;

/**
 * The source of a generated class.
 *
 * @param className fully qualified
 * @param text formatted
 */
public record SourceFile(String className, String text) {}
