package org.mechservice.view.drawing;

/** The colours of a picture. */
public enum Theme {
  /** Dark lines on white. */
  LIGHT,
  /** Light lines on black. */
  DARK,
  /** As its reader prefers, light where that is not known. */
  AUTOMATIC
}
