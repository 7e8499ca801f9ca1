package org.mechservice.view.player;

/**
 * A surface on the stage that moves with a body.
 *
 * @param body index of the body, or the root's
 * @param role what it stands for
 * @param name name of the body, joint or force in the model file
 * @param shape the surface, in body axes, m
 * @param colour 0xRRGGBB
 * @param opacity 1 for an opaque surface
 * @param finish how it takes light
 */
record Part(
    int body, Role role, String name, Shape shape, int colour, double opacity, Finish finish) {
  /** The part that a surface shows; viewers can hide all of one role. */
  enum Role {
    BODY,
    JOINT,
    /** A plane that something rolls or lies on, as a thin sheet. */
    SURFACE,
    /** A surface whose height changes, as far as the motion goes along it. */
    ROAD,
    /** The box of even density with a body's inertia, which is hidden unless asked for. */
    INERTIA
  }

  /** How a surface takes light. */
  enum Finish {
    GLOSSY,
    /** As rubber. */
    DULL
  }
}
