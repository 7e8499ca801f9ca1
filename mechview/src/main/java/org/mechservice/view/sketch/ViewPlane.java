package org.mechservice.view.sketch;

/** The plane that a drawing of a mechanism shows. */
public enum ViewPlane {
  /** The plane of motion of a planar mechanism; else as {@link #ISO}. */
  AUTO,
  /** x to the right, y up. */
  XY,
  /** x to the right, z up. */
  XZ,
  /** y to the right, z up. */
  YZ,
  /** All three axes to be seen. */
  ISO
}
