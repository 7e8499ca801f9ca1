package org.mechservice.orb;

/** The version of this service. */
public final class ServiceVersion {
  /** Version as in the build. */
  public static final String CURRENT = "0.1.0";

  private ServiceVersion() {}
}
