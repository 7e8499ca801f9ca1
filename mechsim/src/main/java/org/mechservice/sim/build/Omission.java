package org.mechservice.sim.build;

/**
 * Something the generated class does not contain because the scene does not need it.
 *
 * @param what what was left out, such as {@code loop closures}
 * @param why why the scene does not need it
 */
public record Omission(String what, String why) {}
