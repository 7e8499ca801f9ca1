package org.mechservice.view.mesh;

import java.io.IOException;

/** A geometry file cannot be used; the message says which, where and why. */
public final class MeshException extends IOException {
  private static final long serialVersionUID = 1;

  MeshException(String message) {
    super(message);
  }
}
