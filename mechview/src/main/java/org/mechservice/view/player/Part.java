package org.mechservice.view.player;

import org.mechservice.view.mesh.Mesh;

/**
 * A surface on the stage that moves with a body.
 *
 * @param body index of the body, or the root's
 * @param role what it stands for
 * @param name name of the body, joint or force in the model file
 * @param mesh the surface, in body axes, m
 * @param colour 0xRRGGBB
 */
record Part(int body, Role role, String name, Mesh mesh, int colour) {
  /** The part that a surface shows; viewers can hide all of one role. */
  enum Role {
    BODY,
    JOINT,
    SURFACE
  }
}
