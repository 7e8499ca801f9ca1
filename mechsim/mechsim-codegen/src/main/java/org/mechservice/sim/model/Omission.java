package org.mechservice.sim.model;

/**
 * Something the generated class does not contain: the scene does not need it, or data beside the
 * class compute it.
 *
 * @param what the part left out, such as {@code loop closures}
 * @param why the reason
 */
public record Omission(String what, String why) {}
