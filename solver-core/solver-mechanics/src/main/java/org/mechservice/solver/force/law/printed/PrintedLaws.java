package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.CoordinateLaw;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.PrintedLaw;

/**
 * The printed laws. Printed from its formula; do not edit. PrintedLawsTest compares it with the
 * formula and
 * prints it anew with -Dgolden.write=true.
 */
public final class PrintedLaws {
  private PrintedLaws() {}

  /**
   * Returns a new instance of a law.
   */
  public static PrintedLaw of(PairLaw law) {
    return switch (law) {
      case SPRING -> new PrintedSpring();
      case ROPE -> new PrintedRope();
      case BUFFER -> new PrintedBuffer();
      case BUSHING -> new PrintedBushing();
      case LINEAR_BUSHING -> new PrintedLinearBushing();
      case CONTACT -> new PrintedContact();
      case CONTACT_OF_CENTRE -> new PrintedContactOfCentre();
    };
  }

  /**
   * Returns a new instance of a law.
   */
  public static PrintedLaw of(CoordinateLaw law) {
    return switch (law) {
      case SPRING -> new PrintedJointSpring();
      case UPPER_STOP -> new PrintedJointUpperStop();
      case LOWER_STOP -> new PrintedJointLowerStop();
      case FRICTION -> new PrintedJointFriction();
    };
  }
}
