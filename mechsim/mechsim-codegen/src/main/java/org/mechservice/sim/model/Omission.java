package org.mechservice.sim.model;

/**
 * A part that the generated class does not contain, because the scene does not need it or data
 * compute it.
 *
 * @param what the omitted part, such as {@code loop closures}
 * @param why the reason
 */
public record Omission(String what, String why) {}
