package org.mechservice.orb;

import org.jspecify.annotations.Nullable;

/** No MechService answers at an address. */
public final class ServiceUnreachableException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public ServiceUnreachableException(String message, @Nullable Throwable cause) {
    super(message, cause);
  }
}
