package org.mechservice.orb;

import org.jspecify.annotations.Nullable;

/** Nothing answers at an address, or something that is not a MechService. */
public final class ServiceUnreachableException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public ServiceUnreachableException(String message, @Nullable Throwable cause) {
    super(message, cause);
  }
}
