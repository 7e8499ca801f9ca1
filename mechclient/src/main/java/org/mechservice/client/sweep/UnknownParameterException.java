package org.mechservice.client.sweep;

import org.mechservice.client.failure.ServiceException;

/** The model has no parameter of a name in the grid, so no point can be run. */
public final class UnknownParameterException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  UnknownParameterException(ServiceException cause) {
    super(cause.getMessage(), cause);
  }
}
